// What a phase's dense blocks of coordinates add to energies and impulses.
//
// With z an amplitude of exponent e and x the coordinates of a dense block, x' = B x,
//
//   (z x)' = (e + B) z x,     integral of z x over h = (e + B)^-1 [z x]        ([] = end - start)
//
// For a block of d coordinates that is a polynomial, the inverse has the factor e^-d, which over a
// short part takes digits away, (e h)^-d of them. Such products, those where e + B is next to
// singular, and those of two dense blocks are integrated by Gauss quadrature, whose error is
// 6.5e-20 (k h)^14 of the integrand, k being the fastest of their exponents together; free bodies
// move by polynomials, which it integrates exactly.
//
// A power is the product of two forms F G of the amplitudes. Of these, F = F_d + F_f + F_r: the
// dense blocks, the groups that the quadrature follows, and the rest; it integrates
// F_d G_d + F_d G_f + F_f G_d. Under a polynomial that is faster than the modes, (e h)^-d times as
// large as what they do, F_d and F_f nearly cancel; over a short part it therefore follows all
// groups and integrates F G.
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
  /// Are parts of this length integrated as a whole?
  bool takes_all(double h) const;
  /// Adds the integral of each power over a part of length h to `integrals`, one entry per power;
  /// where it takes all, with the products of the other groups.
  void add(const double *start, const double *end, double h, std::vector<double> &integrals);

private:
  // A group and a dense block whose products can be integrated in closed form.
  struct Mixed {
    std::size_t block = 0;
    Eigen::MatrixXcd coefficients; ///< powers x coordinates of the block
  };
  // What both factors of each power see of a group, and its products with the dense blocks.
  struct Seen {
    Matrix first, second; ///< powers x real coordinates
    std::vector<std::size_t> places;
    double fastest = 0; ///< exponent of it and of a dense block together [1/s]
    bool dense = false;
    bool closed = false;      ///< with every dense block
    std::vector<Mixed> mixed; ///< with those blocks
  };
  struct Forms {
    Vector first, second;
  };
  Seen seen(const PhaseGroup &group) const;
  bool integrate_mixed(Seen &group, Complex exponent, std::size_t block) const;
  Vector coordinates(const Seen &of, const double *amplitudes) const;
  void add_mixed(std::size_t group, const double *start, const double *end,
                 std::vector<double> &integrals) const;
  bool is_followed(const Seen &group, double h) const;
  void add_quadrature(const double *start, double h, bool all, std::vector<double> &integrals);
  void add_node(double weight, bool all, std::vector<double> &integrals);
  void see(const Seen &group, Forms &forms) const;

  const PowerForms &powers_;
  const ExactPhase &phase_;
  std::vector<Seen> seen_; ///< by groups
  std::vector<const Seen *> followed_;
  double fastest_ = 0; ///< of the groups that are followed
  Forms of_dense_, of_others_;
  Amplitudes turned_;
};

} // namespace vibroimpact::motion
