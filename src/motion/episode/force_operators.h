// Repeated integrals of the forces of a family.
//
//   I_k[i, j] = integral of (X_i - y)^k / k! phi_j(y) over [0, X_i],   k = 0, 1, 2, ...
//
// What forces do to a linear system over a step: I_0 gives the impulse, I_1 what it moves, and the
// higher ones what the system makes of that meanwhile (forced_output.h). They belong to no system.
//
// With y = x(Xi s), X = x(Xi), the integrand is a power of s times what is smooth in s, but for the
// other end's singularity at s = 1 / Xi outside: a Gauss rule for that power gives it to better
// than 1e-15. At X = 1 the family's own weight leaves a polynomial, or what is as smooth.
#pragma once

#include "motion/episode/force_family.h"

#include <vector>

namespace vibroimpact::motion {

class ForceOperators {
public:
  /// Xi_i of X_i = x(Xi_i): `targets`, each in (0, 1]. Keeps a reference to the family.
  ForceOperators(const ForceFamily &family, std::vector<long double> targets);

  /// The nodes of the family, and the end behind them.
  static std::vector<long double> nodes_and_end(const ForceFamily &family);

  int n_targets() const { return static_cast<int>(targets_.size()); }
  /// Makes I_0 ... I_(count-1); of earlier calls they stay.
  void require(int count);
  int n_terms() const { return n_terms_; }
  /// I_0, I_1, ... side by side: targets x (nodes terms).
  const Matrix &terms() const { return terms_; }
  auto term(int k) const {
    return terms_.middleCols(static_cast<Index>(k) * family_.size(), family_.size());
  }

private:
  /// What of a target's integrals does not depend on k.
  struct Integrand {
    LongArray distance; ///< (X - y) at the points of the rule
    LongMatrix factors; ///< points x nodes
  };
  /// `end`: power there that the rule's weight does not have.
  Integrand integrand(long double target, double end, const GaussRule &rule) const;

  const ForceFamily &family_;
  std::vector<long double> targets_;
  std::vector<Integrand> integrands_;
  Matrix terms_;
  int n_terms_ = 0;
};

} // namespace vibroimpact::motion
