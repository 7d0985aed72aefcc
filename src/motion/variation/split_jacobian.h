// The Jacobian of linear bodies with contacts, times columns, without assembling it:
//
//   J = J_0 + sum_c b_c f_c,   J_0 = [0 1; -M^-1 K  -M^-1 C],   b_c = M^-1 w_c^T
//
// with the gap row w_c and f_c the derivatives of the contact force by coordinates, velocities and
// internal states. J_0 is the same at all instants; the rest is of rank one for each contact. Rates
// of internal states are rows beside it.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

class SplitJacobian {
public:
  /// Keeps a reference. The model is linear and no gap is held in the present modes. `scale`:
  /// columns and products are in scaled entries, S J S^-1.
  SplitJacobian(const Equations &equations, const Vector &scale);

  /// The two conditions.
  static bool is_possible(const Equations &equations) {
    return equations.model().linear() && equations.holding().empty() &&
           equations.layout().n_sliding == 0 && !equations.contacts().has_circles();
  }

  /// product = J columns at a state with its integrals. Returns the trace of J.
  double apply(double time, ConstVectorView state, const Eigen::Ref<const Matrix> &columns,
               Eigen::Ref<Matrix> product) const;

private:
  struct Acting {
    std::size_t contact = 0;
    RowVector by_gap, by_gap_rate; ///< rows of gap and gap rate by scaled coordinates, velocities
    Vector response;               ///< scaled rates of the velocities by the force
  };
  double add_contact(const Acting &acting, double time, ConstVectorView state,
                     const Eigen::Ref<const Matrix> &columns, Eigen::Ref<Matrix> product) const;

  const Equations &equations_;
  Vector scale_;
  Vector by_velocity_; ///< diagonal of the upper right block
  // The lower half: diagonals by displacements and velocities, and n x 2n off them, or 0 x 0.
  Vector stiffness_, damping_;
  Matrix coupling_;
  std::vector<Acting> acting_;
  mutable contact::LawResponse response_;
};

} // namespace vibroimpact::motion
