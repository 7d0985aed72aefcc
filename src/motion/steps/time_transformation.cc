#include "motion/steps/time_transformation.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

TimeTransformation TimeTransformation::even(double start, double end) {
  return {.start = start, .length = end - start};
}

TimeTransformation TimeTransformation::since(double instant, double start, double end) {
  TimeTransformation course = even(start, end);
  course.origin = instant;
  course.root = std::sqrt(start - instant);
  course.span = std::sqrt(end - instant) - course.root;
  return course;
}

TimeTransformation TimeTransformation::until(double instant, double start, double end) {
  TimeTransformation course = even(start, end);
  course.origin = instant;
  course.sign = -1;
  course.root = std::sqrt(instant - start);
  course.span = std::sqrt(instant - end) - course.root;
  return course;
}

TimeTransformation TimeTransformation::to(double end) const {
  if (span == 0)
    return even(start, end);
  return sign > 0 ? since(origin, start, end) : until(std::max(origin, end), start, end);
}

} // namespace vibroimpact::motion
