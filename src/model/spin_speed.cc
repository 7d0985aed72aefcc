#include "model/spin_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::model {

double SpinSpeed::rate(double time) const {
  return !constant() && time >= start_ && time < end() ? (last_ - first_) / duration_ : 0;
}

double SpinSpeed::at(double time) const {
  if (constant() || time <= start_)
    return first_;
  return time >= end() ? last_ : first_ + (last_ - first_) * (time - start_) / duration_;
}

double SpinSpeed::integral(double time) const {
  const double t = time - start_;
  if (constant() || t <= 0)
    return first_ * t;
  if (t >= duration_)
    return (first_ + last_) / 2 * duration_ + last_ * (t - duration_);
  return first_ * t + (last_ - first_) * t * t / (2 * duration_);
}

double SpinSpeed::angle(double time) const { return integral(time) - integral(0); }

double SpinSpeed::highest() const { return std::max(std::abs(first_), std::abs(last_)); }

double SpinSpeed::next_break(double time) const {
  if (!constant())
    for (const double instant : {start_, end()})
      if (instant > time)
        return instant;
  return std::numeric_limits<double>::infinity();
}

} // namespace vibroimpact::model
