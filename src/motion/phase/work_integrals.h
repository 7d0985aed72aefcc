// Energies and impulses of a part of a linear phase in closed form.
//
// All powers are sums of products of two linear forms of the motion. With z_j the amplitudes of the
// groups, a power is the sum over i <= j of Re(a_ij z_i z_j + b_ij z_i conj(z_j)), and
//
//   integral of z_i z_j over h = [z_i z_j] / (e_i + e_j)         ([] = end - start)
//
// likewise with conjugates. Where the sum of the exponents is next to zero that is lost in
// rounding, and the integral is taken from both ends by the trapezoidal rule with its first
// correction, which is exact to (|e_i + e_j| h)^4 / 720: it sets how long a part may be, and a
// decay that is over sets nothing. Coordinates of dense blocks: dense_work.h.
#pragma once

#include "motion/interval/phase_forms.h"
#include "motion/phase/dense_work.h"

#include <vector>

namespace vibroimpact::motion {

class WorkIntegrals {
public:
  /// For a phase with these powers; keeps references to both.
  WorkIntegrals(const PowerForms &powers, const ExactPhase &phase, const StateLayout &layout);

  /// The inputs of the phase are others.
  void renew();

  /// The longest part that is integrated to rounding [s], and no more than a turn of the slowest
  /// vibration, over which the work of a load changes its sign.
  double longest() const { return longest_; }
  std::size_t bytes() const { return bytes_of(products_, forms_, coefficients_) + dense_.bytes(); }

  /// Adds the integrals over a part of length h to the entries of `state`. In place of the integral
  /// of |power| stands the absolute value of the integral, which is never larger.
  void add(const double *start, const double *end, double h, Vector &state);

private:
  void arrange();
  void list_products();
  bool is_seen(std::size_t i, std::size_t j) const;
  bool set_forms(std::size_t group);
  void set_product(std::size_t k);
  bool is_slow(const ProductView &product) const;
  Complex coefficient(std::size_t power, const ProductView &product) const;
  void set_scale();
  void limit_length();
  std::size_t n_blocks() const { return (entries_.size() + 7) / 8; }

  const PowerForms &powers_;
  const ExactPhase &phase_;
  long arrangement_ = -1, generation_ = -1;
  Index input_work_, absolute_input_work_;
  double scale_ = 0; ///< of time: sums of exponents far below its inverse are next to zero [s]
  bool vibrates_ = false;
  double longest_ = 0;
  std::vector<Index> entries_;        ///< of the state
  std::vector<std::size_t> place_of_; ///< of the powers, among the entries
  std::vector<ProductView> products_;
  std::vector<Complex> forms_; ///< 2 powers x groups
  DenseWork dense_;
  std::vector<double> of_dense_; ///< powers
  AlignedArray coefficients_, integrals_;
  WorkView view_;
};

} // namespace vibroimpact::motion
