#include "continuation/harmonic_series.h"

#include "common/zero.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace vibroimpact::continuation {

using std::numbers::pi;

Index harmonics_of(Index coefficients) {
  if (coefficients % 2 == 0)
    throw std::logic_error("a harmonic series has 2 H + 1 coefficients");
  return coefficients / 2;
}

// By powers of exp(i phi), which lose h roundings at most.
Vector harmonic_basis(double phase, Index harmonics) {
  Vector values(2 * harmonics + 1);
  values(0) = 1;
  const double c = std::cos(phase), s = std::sin(phase);
  double real = 1, imaginary = 0;
  for (Index h = 1; h <= harmonics; ++h) {
    const double next = real * c - imaginary * s;
    imaginary = real * s + imaginary * c;
    real = next;
    values(2 * h - 1) = real;
    values(2 * h) = imaginary;
  }
  return values;
}

Vector harmonic_projection(const Vector &basis) {
  Vector weights = basis / pi;
  weights(0) /= 2;
  return weights;
}

Matrix harmonic_rate(Index harmonics) {
  Matrix rate = Matrix::Zero(2 * harmonics + 1, 2 * harmonics + 1);
  for (Index h = 1; h <= harmonics; ++h) {
    rate(2 * h - 1, 2 * h) = -static_cast<double>(h);
    rate(2 * h, 2 * h - 1) = static_cast<double>(h);
  }
  return rate;
}

Matrix with_harmonics(const Matrix &series, Index harmonics) {
  Matrix longer = Matrix::Zero(series.rows(), 2 * harmonics + 1);
  longer.leftCols(series.cols()) = series;
  return longer;
}

Vector harmonic_amplitudes(const RowVector &series) {
  Vector amplitudes(harmonics_of(series.size()) + 1);
  amplitudes(0) = std::abs(series(0));
  for (Index h = 1; h < amplitudes.size(); ++h)
    amplitudes(h) = series.segment(2 * h - 1, 2).norm();
  return amplitudes;
}

SeriesRange range_of(const RowVector &series) {
  const Index harmonics = harmonics_of(series.size());
  const RowVector rate = series * harmonic_rate(harmonics);
  const Index samples = 16 * std::max<Index>(harmonics, 1);
  const auto value = [&](double phase) { return series.dot(harmonic_basis(phase, harmonics)); };
  const auto slope = [&](double phase) { return rate.dot(harmonic_basis(phase, harmonics)); };
  SeriesRange range{.minimum = value(0), .maximum = value(0)};
  const auto include = [&range](double x) {
    range = {.minimum = std::min(range.minimum, x), .maximum = std::max(range.maximum, x)};
  };
  double before = slope(0);
  for (Index i = 0; i < samples; ++i) {
    const double step = 2 * pi / static_cast<double>(samples);
    const double begin = step * static_cast<double>(i), end = begin + step;
    const double after = slope(end);
    include(value(end));
    if (before * after < 0)
      include(value(zero_between(slope, begin, end)));
    before = after;
  }
  return range;
}

} // namespace vibroimpact::continuation
