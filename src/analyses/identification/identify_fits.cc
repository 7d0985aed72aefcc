#include "analyses/identification/identify_fits.h"

#include "common/decompositions.h"
#include "common/linear_algebra.h"
#include "common/scalar.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace vibroimpact::analyses {

namespace {

/// Of the intervals of 95 % of the coefficients of a linear fit.
Vector half_widths(const Matrix &factors, const Vector &residuals) {
  const Index freedom = factors.rows() - factors.cols();
  if (freedom <= 0)
    return Vector::Constant(factors.cols(), nan);
  const double variance = residuals.squaredNorm() / static_cast<double>(freedom);
  const Matrix inverse = vibroimpact::inverse(Matrix(factors.transpose() * factors));
  const boost::math::students_t distribution(static_cast<double>(freedom));
  return boost::math::quantile(distribution, 0.975) * (variance * inverse.diagonal()).cwiseSqrt();
}

} // namespace

double constant_damping_factor(const std::vector<Identified> &impacts) {
  double numerator = 0;
  double denominator = 0;
  for (const Identified &impact : impacts) {
    if (!std::isfinite(impact.damping_factor))
      continue;
    const double square = impact.approach_speed * impact.approach_speed;
    numerator += impact.damping_factor * square; // mu v_c = k d_c
    denominator += square;
  }
  return numerator / denominator;
}

PowerFit fit_power(const std::vector<Identified> &impacts, double speed_unit) {
  std::vector<Identified> usable;
  for (const Identified &impact : impacts)
    if (impact.restitution > 0)
      usable.push_back(impact);
  const auto rows = static_cast<Index>(usable.size());
  Matrix factors(rows, 2);
  Vector logarithms(rows);
  for (Index i = 0; i < rows; ++i) {
    const Identified &impact = usable[static_cast<std::size_t>(i)];
    factors.row(i) << 1, std::log(impact.approach_speed / speed_unit);
    logarithms[i] = std::log(impact.restitution);
  }
  PowerFit fit{.coefficient = nan,
               .exponent = nan,
               .coefficient_interval = {.low = nan, .high = nan},
               .exponent_interval = {.low = nan, .high = nan},
               .impacts = usable.size()};
  if (rows < 2)
    return fit;
  const PivotedQr decomposition(factors);
  if (decomposition.rank() < 2)
    return fit;
  const Vector solution = decomposition.solve(logarithms);
  fit.coefficient = std::exp(solution[0]);
  fit.exponent = solution[1];
  const Vector half = half_widths(factors, logarithms - factors * solution);
  fit.coefficient_interval = {.low = std::exp(solution[0] - half[0]),
                              .high = std::exp(solution[0] + half[0])};
  fit.exponent_interval = {.low = solution[1] - half[1], .high = solution[1] + half[1]};
  return fit;
}

} // namespace vibroimpact::analyses
