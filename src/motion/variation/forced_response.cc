#include "motion/variation/forced_response.h"

#include "common/decompositions.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// sinh(z)/z; the difference of exponentials would lose digits where z is small. For |z| < 1 nine
// terms leave 1/19! < 1e-17.
Complex sinhc(Complex z) {
  if (std::norm(z) >= 1)
    return std::sinh(z) / z;
  const Complex square = z * z;
  Complex sum = 1;
  for (int k = 16; k >= 2; k -= 2)
    sum = 1.0 + square / static_cast<double>(k * (k + 1)) * sum;
  return sum;
}

// `at_a`, `at_b`: exp(a h), exp(b h). Far apart nothing cancels, and sinh would overflow where the
// product does not.
Complex divided_difference(Complex a, Complex b, Complex at_a, Complex at_b, double h) {
  const Complex half = 0.5 * h * (b - a);
  if (std::norm(half) >= 1)
    return (at_b - at_a) / (b - a);
  return h * std::exp(0.5 * h * (a + b)) * sinhc(half);
}

Matrix block(const Matrix &matrix, const std::vector<Index> &rows,
             const std::vector<Index> &columns) {
  return matrix(rows, columns);
}

Matrix generator_of(const PhaseGroup &group) {
  if (group.kind == BlockKind::pair)
    return pair_generator(group.exponent);
  return group.kind == BlockKind::real ? Matrix::Constant(1, 1, group.exponent.real())
                                       : group.generator;
}

} // namespace

ForcedResponse::ForcedResponse(const std::vector<PhaseGroup> &groups, const Matrix &coupling) {
  for (const PhaseGroup &group : groups) {
    if (group.kind == BlockKind::dense)
      dense_.push_back(group);
    else
      waves_.push_back({.exponent = group.exponent,
                        .real = group.coordinates[0],
                        .imaginary = group.coordinates.size() > 1 ? group.coordinates[1] : -1});
  }
  couple_waves(coupling);
  couple_dense(groups, coupling);
}

void ForcedResponse::couple_waves(const Matrix &coupling) {
  const auto entry = [&](Index row, Index column) {
    return row < 0 || column < 0 ? 0.0 : coupling(row, column);
  };
  for (std::size_t i = 0; i < waves_.size(); ++i)
    for (std::size_t j = 0; j < waves_.size(); ++j) {
      const Wave &to = waves_[i];
      const Wave &from = waves_[j];
      const double rr = entry(to.real, from.real), ri = entry(to.real, from.imaginary);
      const double ir = entry(to.imaginary, from.real), ii = entry(to.imaginary, from.imaginary);
      if (rr != 0 || ri != 0 || ir != 0 || ii != 0)
        wave_couplings_.push_back({.to = i,
                                   .from = j,
                                   .by_value = 0.5 * Complex(rr + ii, ir - ri),
                                   .by_conjugate = 0.5 * Complex(rr - ii, ir + ri)});
    }
}

void ForcedResponse::couple_dense(const std::vector<PhaseGroup> &groups, const Matrix &coupling) {
  for (const PhaseGroup &to : groups)
    for (const PhaseGroup &from : groups) {
      const Matrix between = block(coupling, to.coordinates, from.coordinates);
      if ((to.kind != BlockKind::dense && from.kind != BlockKind::dense) || between.isZero(0))
        continue;
      const Index n = between.rows();
      const Index m = between.cols();
      Matrix generator = Matrix::Zero(n + m, n + m);
      generator << generator_of(to), between, Matrix::Zero(m, n), generator_of(from);
      dense_couplings_.push_back(
          {.to = to.coordinates, .from = from.coordinates, .generator = std::move(generator)});
    }
}

Vector ForcedResponse::operator()(double h, const Vector &x, const Vector &start) const {
  const auto amplitude = [](const Wave &wave, const Vector &of) {
    return Complex(of[wave.real], wave.imaginary < 0 ? 0 : of[wave.imaginary]);
  };
  Vector end = Vector::Zero(x.size());
  ComplexVector growth(static_cast<Index>(waves_.size()));
  ComplexVector sums(growth.size());
  for (Index i = 0; i < growth.size(); ++i) {
    const Wave &wave = waves_[static_cast<std::size_t>(i)];
    growth[i] = std::exp(wave.exponent * h);
    sums[i] = growth[i] * amplitude(wave, start);
  }
  for (const WaveCoupling &coupling : wave_couplings_) {
    const auto i = static_cast<Index>(coupling.to);
    const auto j = static_cast<Index>(coupling.from);
    const Complex a = waves_[coupling.to].exponent;
    const Complex b = waves_[coupling.from].exponent;
    const Complex value = amplitude(waves_[coupling.from], x);
    sums[i] += coupling.by_value * divided_difference(a, b, growth[i], growth[j], h) * value;
    if (coupling.by_conjugate != 0.0)
      sums[i] += coupling.by_conjugate *
                 divided_difference(a, std::conj(b), growth[i], std::conj(growth[j]), h) *
                 std::conj(value);
  }
  for (Index i = 0; i < growth.size(); ++i) {
    const Wave &wave = waves_[static_cast<std::size_t>(i)];
    end[wave.real] = sums[i].real();
    if (wave.imaginary >= 0)
      end[wave.imaginary] = sums[i].imag();
  }
  for (const PhaseGroup &group : dense_)
    end(group.coordinates) += exponential(h * group.generator) * start(group.coordinates);
  for (const DenseCoupling &coupling : dense_couplings_) {
    const auto n = static_cast<Index>(coupling.to.size());
    const auto m = static_cast<Index>(coupling.from.size());
    const Matrix all = exponential(h * coupling.generator);
    end(coupling.to) += all.topRightCorner(n, m) * x(coupling.from);
  }
  return end;
}

} // namespace vibroimpact::motion
