// Sums of exponentials as phases of a motion, for tests.
#pragma once

#include "motion/phase/exact_phase.h"

#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// constant + sum over j of Re(coefficient_j exp(exponent_j t))
struct Sum {
  double constant = 0;
  std::vector<Complex> coefficients, exponents;

  double operator()(double t) const {
    double value = constant;
    for (std::size_t j = 0; j < exponents.size(); ++j)
      value += (coefficients[j] * std::exp(exponents[j] * t)).real();
    return value;
  }
};

/// The same exponents in all sums, as a phase whose guards they are; every exponential is 1 at 0.
class SumsPhase {
public:
  explicit SumsPhase(const std::vector<Sum> &sums, double longest = 8)
      : SumsPhase(sums, matrix_of(sums[0].exponents), longest) {}

  /// Runs to `limit` or the first zero.
  MarchEnd advance(const Kernel &kernel, double limit) {
    MarchEnd end = MarchEnd::paused;
    while (end == MarchEnd::paused)
      end = kernel.advance(phase->view(), walk, limit);
    return end;
  }
  /// At the start.
  const Amplitudes &amplitudes() const { return origin_; }
  double reached(MarchEnd end) const {
    return walk.time + (end == MarchEnd::guard ? walk.to_guard : 0.0);
  }

  std::unique_ptr<ExactPhase> phase;
  MarchState walk;
  std::vector<unsigned char> order;

private:
  SumsPhase(const std::vector<Sum> &sums, const Matrix &matrix, double longest)
      : order(sums.size(), 0) {
    const Index n = matrix.rows();
    GuardForms guards{.rows = Matrix::Zero(static_cast<Index>(sums.size()), n),
                      .constants = Vector::Zero(static_cast<Index>(sums.size()))};
    Vector y = Vector::Zero(n);
    for (std::size_t g = 0; g < sums.size(); ++g) {
      guards.constants[static_cast<Index>(g)] = sums[g].constant;
      Index column = 0;
      for (std::size_t j = 0; j < sums[g].exponents.size(); ++j) {
        y[column] = 1;
        guards.rows(static_cast<Index>(g), column++) = sums[g].coefficients[j].real();
        if (sums[g].exponents[j].imag() != 0)
          guards.rows(static_cast<Index>(g), column++) = -sums[g].coefficients[j].imag();
      }
    }
    phase = std::make_unique<ExactPhase>(matrix, Vector::Zero(n), std::vector<LinearSystem::Load>(),
                                         guards, longest);
    Excitation nothing;
    nothing.take({});
    phase->take(nothing);
    const double one = 1;
    phase->amplitudes(y, &one, amplitudes_);
    magnitudes_.assign(amplitudes_.size(), 0);
    turned_ = origin_ = amplitudes_;
    reach_ = magnitudes_;
    noise_.assign(sums.size(), 0);
    walk.amplitudes = amplitudes_.data();
    walk.origin = origin_.data();
    walk.turned = turned_.data();
    walk.magnitudes = magnitudes_.data();
    walk.reach = reach_.data();
    walk.noise = noise_.data();
    walk.order = order.data();
  }

  static Matrix matrix_of(const std::vector<Complex> &exponents) {
    Index size = 0;
    for (const Complex e : exponents)
      size += e.imag() != 0 ? 2 : 1;
    Matrix matrix = Matrix::Zero(size, size);
    Index column = 0;
    for (const Complex e : exponents) {
      matrix(column, column) = e.real();
      if (e.imag() != 0) {
        matrix(column + 1, column + 1) = e.real();
        matrix(column, column + 1) = -e.imag();
        matrix(column + 1, column) = e.imag();
        ++column;
      }
      ++column;
    }
    return matrix;
  }

  Amplitudes amplitudes_, origin_, turned_;
  AlignedArray magnitudes_, reach_, noise_;
};

/// Those that this machine has.
inline std::vector<const Kernel *> kernels() {
  std::vector<const Kernel *> list;
  for (const Kernel *kernel : {&kernel_plain, &kernel_avx2, &kernel_avx512})
    if (machine_has(*kernel))
      list.push_back(kernel);
  return list;
}

} // namespace vibroimpact::motion
