#include "continuation/problem.h"

namespace vibroimpact::continuation {

Transfer Problem::transfer(const Point &, double) {
  throw std::logic_error("this problem has one chart only");
}

Extension Problem::extend(const Point &, const Graze &) {
  throw std::logic_error("this problem has no grazing motions");
}

} // namespace vibroimpact::continuation
