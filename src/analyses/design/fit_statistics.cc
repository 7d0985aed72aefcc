#include "analyses/design/fit_statistics.h"

#include "common/decompositions.h"
#include "common/scalar.h"
#include "parameters/text.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>

namespace vibroimpact::analyses {

namespace {

/// Singular values below this part of the largest are errors of the differences.
constexpr double noise = 1e-5;

struct Decomposition {
  Vector values;
  Matrix directions; ///< columns
};

Decomposition decompose(const Matrix &matrix) {
  const SingularValues of = right_singular_values(matrix);
  return {of.values, of.right};
}

// (J' J)^-1 = V S^-2 V'; a key that takes part in a direction without information has no error.
Matrix covariance(const Matrix &scaled, double variance) {
  const auto [values, directions] = decompose(scaled);
  Matrix sum = Matrix::Zero(scaled.cols(), scaled.cols());
  for (Index k = 0; k < values.size(); ++k) {
    const Vector v = directions.col(k);
    if (values[k] > noise * values[0])
      sum += v * v.transpose() * variance / (values[k] * values[k]);
    else
      for (Index i = 0; i < v.size(); ++i)
        if (std::abs(v[i]) > 1e-3)
          sum(i, i) = infinity;
  }
  return sum;
}

/// Factor of the standard error for 95 %.
double quantile(Index freedom, bool known_variance) {
  if (known_variance)
    return boost::math::quantile(boost::math::normal(), 0.975);
  return freedom > 0
             ? boost::math::quantile(boost::math::students_t(static_cast<double>(freedom)), 0.975)
             : infinity;
}

std::string part(double value) { return parameters::number_text(std::round(value * 100) / 100); }

} // namespace

FitStatistics fit_statistics(const Vector &residuals, const Matrix &jacobian, const Vector &sizes,
                             const std::vector<bool> &fixed, bool known_variance) {
  const Index n = jacobian.cols();
  std::vector<Index> free;
  for (Index k = 0; k < n; ++k)
    if (!fixed[static_cast<std::size_t>(k)])
      free.push_back(k);
  const Index freedom = residuals.size() - static_cast<Index>(free.size());
  FitStatistics statistics;
  statistics.residual_variance =
      freedom > 0 ? residuals.squaredNorm() / static_cast<double>(freedom) : nan;
  const double variance = known_variance ? 1 : statistics.residual_variance;
  const Matrix scaled = jacobian * sizes.asDiagonal();

  statistics.standard_error = Vector::Constant(n, nan);
  statistics.correlation = Matrix::Constant(n, n, nan);
  if (!free.empty()) {
    const Matrix c = covariance(scaled(Eigen::all, free), variance);
    for (std::size_t i = 0; i < free.size(); ++i) {
      const auto a = static_cast<Index>(i);
      statistics.standard_error[free[i]] = sizes[free[i]] * std::sqrt(c(a, a));
      for (std::size_t j = 0; j < free.size(); ++j) {
        const auto b = static_cast<Index>(j);
        statistics.correlation(free[i], free[j]) = c(a, b) / std::sqrt(c(a, a) * c(b, b));
      }
    }
  }
  statistics.half_width = quantile(freedom, known_variance) * statistics.standard_error;

  const auto [values, directions] = decompose(scaled);
  statistics.singular_value = Vector::Zero(n);
  statistics.direction = Matrix::Zero(n, n);
  statistics.direction_error = Vector::Constant(n, infinity);
  statistics.singular_value.head(values.size()) = values;
  statistics.direction.topRows(values.size()) = directions.transpose();
  for (Index k = 0; k < values.size(); ++k)
    if (values[k] > noise * values[0])
      statistics.direction_error[k] = std::sqrt(variance) / values[k];
  return statistics;
}

std::string combinations_in_words(const FitStatistics &statistics,
                                  const std::vector<std::string> &names) {
  std::string determined, free;
  for (Index k = 0; k < statistics.direction.rows(); ++k) {
    Vector direction = statistics.direction.row(k);
    Index largest = 0;
    const double size = direction.cwiseAbs().maxCoeff(&largest);
    if (!(size > 0))
      continue;
    direction /= direction[largest];
    std::vector<std::string> keys, shares;
    for (Index i = 0; i < direction.size(); ++i)
      if (std::abs(direction[i]) >= 0.05) {
        keys.push_back(names[static_cast<std::size_t>(i)]);
        shares.push_back(part(direction[i]));
      }
    std::string text = parameters::join(keys, ", ");
    if (keys.size() > 1)
      text += " as " + parameters::join(shares, " : ");
    const double error = statistics.direction_error[k];
    if (error <= free_error)
      determined += (determined.empty() ? "" : "; ") + text + " to " +
                    parameters::number_text(100 * error) + " %";
    else
      free += (free.empty() ? "" : "; ") + text;
  }
  return "relative changes of the keys that the data determine: " +
         (determined.empty() ? "none" : determined) +
         "; that they leave free: " + (free.empty() ? "none" : free);
}

} // namespace vibroimpact::analyses
