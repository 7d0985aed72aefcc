#include "analyses/signals/zeros.h"

#include "common/zero.h"

#include <functional>

namespace vibroimpact::analyses {

std::vector<double> sign_changes(const motion::Bernstein &polynomial) {
  std::vector<double> knots;
  if (polynomial.degree() > 0)
    knots = sign_changes(polynomial.derivative());
  if (knots.empty() || knots.back() < 1)
    knots.push_back(1);
  std::vector<double> zeros;
  double left = 0;
  double sign = polynomial(0);
  for (const double right : knots) {
    const double value = polynomial(right);
    if (value == 0 && sign != 0)
      zeros.push_back(right);
    else if (value * sign < 0)
      zeros.push_back(zero_between(std::cref(polynomial), left, right));
    left = right;
    sign = value;
  }
  return zeros;
}

} // namespace vibroimpact::analyses
