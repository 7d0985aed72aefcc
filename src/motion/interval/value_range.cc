#include "motion/interval/value_range.h"

#include "common/scalar.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

void ValueRange::include(double value) {
  minimum = std::min(minimum, value);
  maximum = std::max(maximum, value);
}

// Most steps stay within what was seen before, as their coefficients tell at once.
void ValueRange::include(const Bernstein &polynomial) {
  if (polynomial.lower_bound() < minimum)
    minimum = std::min(minimum, polynomial.minimum());
  Bernstein negative = polynomial;
  negative *= -1;
  if (-negative.lower_bound() > maximum)
    maximum = std::max(maximum, polynomial.maximum());
}

double ValueRange::peak_to_peak() const { return maximum >= minimum ? maximum - minimum : nan; }

double ValueRange::peak() const {
  return maximum >= minimum ? std::max(std::abs(minimum), std::abs(maximum)) : nan;
}

} // namespace vibroimpact::motion
