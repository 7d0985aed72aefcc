#include "continuation/harmonic_balance.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::continuation {

namespace {

// 1, cos phi, sin phi, cos 2 phi...
RowVector basis(double phase, Index harmonics) {
  RowVector values(2 * harmonics + 1);
  values(0) = 1;
  for (Index h = 1; h <= harmonics; ++h) {
    values(2 * h - 1) = std::cos(static_cast<double>(h) * phase);
    values(2 * h) = std::sin(static_cast<double>(h) * phase);
  }
  return values;
}

// kron(series^T, matrix): d(matrix X series)/dX for X by columns.
void add_product(Matrix &total, const Matrix &series, const Matrix &matrix, double factor) {
  const Index n = matrix.rows();
  for (Index column = 0; column < series.cols(); ++column)
    for (Index row = 0; row < series.rows(); ++row)
      if (series(row, column) != 0)
        total.block(column * n, row * n, n, n) += factor * series(row, column) * matrix;
}

} // namespace

HarmonicBalance::HarmonicBalance(HarmonicSystem &system, Index harmonics, Index samples,
                                 Vector size, double key_size)
    : system_{system}, harmonics_{harmonics}, size_{std::move(size)}, key_size_{key_size},
      synthesis_(samples, coefficients()), rate_{Matrix::Zero(coefficients(), coefficients())} {
  if (samples < coefficients())
    throw std::logic_error("harmonic balance needs a sample for each coefficient");
  for (Index i = 0; i < samples; ++i)
    synthesis_.row(i) =
        basis(2 * M_PI * static_cast<double>(i) / static_cast<double>(samples), harmonics);
  // Columns of the synthesis are orthogonal over equal samples; their squares sum to half the
  // number.
  projection_ = synthesis_.transpose() * (2.0 / static_cast<double>(samples));
  projection_.row(0) /= 2;
  for (Index h = 1; h <= harmonics; ++h) {
    rate_(2 * h - 1, 2 * h) = -static_cast<double>(h);
    rate_(2 * h, 2 * h - 1) = static_cast<double>(h);
  }
}

Vector HarmonicBalance::scales() const {
  Vector scales(size_.size() * coefficients() + 1);
  scales << size_.replicate(coefficients(), 1), key_size_;
  return scales;
}

Evaluation HarmonicBalance::evaluate(const Point &point) {
  const double key = point.keys(0), step = 1e-6 * key_size_;
  Evaluation result;
  result.residual = residual(point.state, key, &result.by_state);
  result.by_keys =
      (residual(point.state, key + step, nullptr) - residual(point.state, key - step, nullptr)) /
      (2 * step);
  return result;
}

// For each coefficient an equation, in the unit of force.
Vector HarmonicBalance::residual(const Vector &state, double key, Matrix *by_state) {
  const HarmonicEquations equations = system_.equations(key);
  const double omega = equations.frequency;
  const Index n = size_.size();
  const Matrix series = Eigen::Map<const Matrix>(state.data(), n, coefficients());
  const Matrix twice = rate_ * rate_;
  Matrix rest = omega * omega * equations.mass * series * twice +
                omega * equations.damping * series * rate_ + equations.stiffness * series;
  const Index shared = std::min(equations.load.cols(), coefficients());
  rest.leftCols(shared) -= equations.load.leftCols(shared);
  if (by_state) {
    by_state->setZero(state.size(), state.size());
    add_product(*by_state, twice, equations.mass, omega * omega);
    add_product(*by_state, rate_, equations.damping, omega);
    add_product(*by_state, Matrix::Identity(coefficients(), coefficients()), equations.stiffness,
                1);
  }
  add_forces(series, omega, key, rest, by_state);
  return rest.reshaped();
}

void HarmonicBalance::add_forces(const Matrix &series, double frequency, double key,
                                 Matrix &residual, Matrix *by_state) {
  const double samples = static_cast<double>(synthesis_.rows());
  const Matrix rates = frequency * rate_;
  for (Index i = 0; i < synthesis_.rows(); ++i) {
    const RowVector now = synthesis_.row(i);
    const ForceSample sample =
        system_.force(series * now.transpose(), series * rates * now.transpose(),
                      2 * M_PI * static_cast<double>(i) / samples, key);
    const Vector weights = projection_.col(i);
    residual += sample.force * weights.transpose();
    if (!by_state)
      continue;
    // X enters the sample as X now^T and X rates now^T.
    add_product(*by_state, now.transpose() * weights.transpose(), sample.by_displacement, 1);
    add_product(*by_state, rates * now.transpose() * weights.transpose(), sample.by_velocity, 1);
  }
}

Vector HarmonicBalance::displacement(const Vector &state, double phase) const {
  return Eigen::Map<const Matrix>(state.data(), size_.size(), coefficients()) *
         basis(phase, harmonics_).transpose();
}

Vector HarmonicBalance::amplitudes(const Vector &state, Index harmonic) const {
  const Eigen::Map<const Matrix> series(state.data(), size_.size(), coefficients());
  if (harmonic == 0)
    return series.col(0).cwiseAbs();
  return series.middleCols(2 * harmonic - 1, 2).rowwise().norm();
}

} // namespace vibroimpact::continuation
