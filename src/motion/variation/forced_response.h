// What groups of coordinates that go on by themselves, x' = D x, become when something small
// couples them,
//
//   dx' = D dx + E x,   dx(h) = exp(D h) dx(0) + int_0^h exp(D (h - s)) E exp(D s) ds x(0)
//
// Between two exponents the integral is the divided difference of the exponential,
//
//   phi(a, b) = (exp(b h) - exp(a h)) / (b - a) = h exp((a + b) h / 2) sinhc((b - a) h / 2)
//
// which is as exact for equal exponents. A pair x = (Re z, Im z) meets E as the complex numbers
// E z = u z + v conj(z). Where a dense block takes part, the integral is a block of one exponential
// (Van Loan 1978),
//
//   exp([D_i E_ij; 0 D_j] h) = [. F_ij; 0 .]
#pragma once

#include "motion/phase/exact_groups.h"

#include <vector>

namespace vibroimpact::motion {

class ForcedResponse {
public:
  /// `coupling`: E, in the coordinates that the groups count [1/s].
  ForcedResponse(const std::vector<PhaseGroup> &groups, const Matrix &coupling);

  std::size_t bytes() const { return bytes_of(waves_, wave_couplings_); }
  /// dx(h) of x(0) and dx(0).
  Vector operator()(double h, const Vector &x, const Vector &start) const;

private:
  /// A pair, or a real coordinate as a pair without imaginary part.
  struct Wave {
    Complex exponent;
    Index real = 0, imaginary = -1; ///< coordinates; -1: none
  };
  struct WaveCoupling {
    std::size_t to = 0, from = 0;
    Complex by_value, by_conjugate; ///< u, v
  };
  struct DenseCoupling {
    std::vector<Index> to, from; ///< coordinates
    Matrix generator;            ///< [D_i E_ij; 0 D_j]
  };

  void couple_waves(const Matrix &coupling);
  void couple_dense(const std::vector<PhaseGroup> &groups, const Matrix &coupling);

  std::vector<Wave> waves_;
  std::vector<WaveCoupling> wave_couplings_;
  std::vector<DenseCoupling> dense_couplings_;
  std::vector<PhaseGroup> dense_; ///< groups
};

} // namespace vibroimpact::motion
