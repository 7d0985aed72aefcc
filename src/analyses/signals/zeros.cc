#include "analyses/signals/zeros.h"

#include <boost/math/tools/roots.hpp>

#include <cstdint>

namespace vibroimpact::analyses {

namespace {

double bracketed_zero(const motion::Bernstein &polynomial, double left, double right) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      polynomial, left, right, boost::math::tools::eps_tolerance<double>(), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

} // namespace

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
      zeros.push_back(bracketed_zero(polynomial, left, right));
    left = right;
    sign = value;
  }
  return zeros;
}

} // namespace vibroimpact::analyses
