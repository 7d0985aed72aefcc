// What a phase's dense blocks of coordinates add to energies and impulses.
//
// With z an amplitude of exponent e and x the coordinates of a dense block, x' = B x,
//
//   (z x)' = (e + B) z x,     integral of z x over h = (e + B)^-1 [z x]        ([] = end - start)
//
// Where e + B is next to singular, and for two dense blocks, the products are integrated by Gauss
// quadrature, whose error is 6.5e-20 (k h)^14 of the integrand, k being the fastest of their
// exponents together; free bodies move by polynomials, which it integrates exactly.
#pragma once

#include "motion/interval/phase_forms.h"
#include "motion/phase/exact_phase.h"

#include <vector>

namespace vibroimpact::motion {

class DenseWork {
public:
  /// Keeps references to both.
  DenseWork(const PowerForms &powers, const ExactPhase &phase);

  /// The inputs of the phase are others.
  void renew();

  std::size_t bytes() const;
  /// Adds the integral of each power over a part of length h to `integrals`, one entry per power.
  void add(const double *start, const double *end, double h, std::vector<double> &integrals);

private:
  // What both factors of each power see of a group: powers x real coordinates.
  struct Seen {
    Matrix first, second;
  };
  // A group and a dense block whose products are integrated in closed form.
  struct Mixed {
    std::size_t group = 0, block = 0;
    Eigen::MatrixXcd coefficients; ///< powers x coordinates of the block
  };
  Seen seen(const PhaseGroup &group) const;
  void list_products();
  bool integrate_mixed(std::size_t group, std::size_t block);
  Complex amplitude(std::size_t group, const double *amplitudes) const;
  Vector coordinates(std::size_t group, const double *amplitudes) const;
  void add_mixed(const double *start, const double *end, std::vector<double> &integrals) const;
  void add_quadrature(const double *start, double h, std::vector<double> &integrals);
  void add_node(double weight, std::vector<double> &integrals) const;

  const PowerForms &powers_;
  const ExactPhase &phase_;
  std::vector<Seen> seen_; ///< by groups
  std::vector<Mixed> mixed_;
  std::vector<std::array<std::size_t, 2>> quadrature_; ///< pairs of groups
  std::vector<std::size_t> followed_;                  ///< the groups among them
  double fastest_ = 0;                                 ///< of two of them together [1/s]
  std::vector<Vector> moved_;                          ///< coordinates at a node, by groups
};

} // namespace vibroimpact::motion
