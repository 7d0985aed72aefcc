#include "integration/step_course.h"

#include <cmath>

namespace vibroimpact::integration {

StepCourse StepCourse::even(double start, double end) {
  return {.start = start, .length = end - start};
}

StepCourse StepCourse::since(double instant, double start, double end) {
  StepCourse course = even(start, end);
  course.origin = instant;
  course.root = std::sqrt(start - instant);
  course.span = std::sqrt(end - instant) - course.root;
  return course;
}

StepCourse StepCourse::until(double instant, double start, double end) {
  StepCourse course = even(start, end);
  course.origin = instant;
  course.sign = -1;
  course.root = std::sqrt(instant - start);
  course.span = std::sqrt(instant - end) - course.root;
  return course;
}

} // namespace vibroimpact::integration
