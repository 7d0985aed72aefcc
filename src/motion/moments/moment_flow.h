// Coordinates of a linear phase under forces that are polynomials over a step.
//
// Over a step of length h the force on coordinate q_i is the sum over k of A_ik P_k(2 x - 1), x in
// [0, 1] the part of the step that is over. A group of coordinates with the generator S is then
//
//   xi(x) = exp(S h x) xi(0) + h sum over k of J_k(S h, x) (L A)_k
//
// with J_k of legendre_response.h and L what a force makes of the coordinates, W^-1 [0; M^-1].
#pragma once

#include "motion/moments/legendre_response.h"
#include "motion/phase/exact_phase.h"

#include <vector>

namespace vibroimpact::motion {

/// What leads from the start of a step to one of its instants.
struct MomentTable {
  std::vector<Complex> turn;                ///< of each group with one exponent
  std::vector<LegendreResponses> responses; ///< h J_k of these
  std::vector<Matrix> dense_turn;           ///< of each other group
  std::vector<std::array<Matrix, n_responses>> dense_responses;
};

class MomentFlow {
public:
  /// Keeps a reference to the phase. mass: that of each coordinate q [kg].
  MomentFlow(const ExactPhase &phase, const Vector &mass);

  /// For the instant x of a step of length h [s], under the present excitation of the phase.
  MomentTable table(double h, double x) const;

  /// L A: coordinates x n_moments, `forces` n x n_moments [N].
  Matrix loads(const Matrix &forces) const { return load_ * forces; }
  /// The coordinates there; `loads` as above.
  void move(const MomentTable &table, const Vector &start, const Matrix &loads,
            Vector &coordinates) const;
  /// h J_k L a there, of the polynomial k = n_moments that the forces lack; load: L a.
  Vector response(const MomentTable &table, const Vector &load) const;

private:
  const ExactPhase &phase_;
  Matrix load_; ///< L, coordinates x n; rows of inputs are zero
};

} // namespace vibroimpact::motion
