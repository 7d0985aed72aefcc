// Small deviations through a contact that was solved as a whole (collocation/contact_episode.h), in
// closed form.
//
// Newton's equations of the contact are differentiated at fixed nodes. With I_k f the repeated
// integrals of the force, m_k those up to the end, theta = T max|exponent|:
//
//   df_i = F_u du_i + F_u' du'_i at the nodes,   dc = 0 at the end, c the form that is zero there
//   du   = sum d_k (theta X)^k + T sum g_k theta^k (I_k df) + dlnT du/dlnT
//
// Deviations count at a fixed instant, the contact begins where u = 0: it is late by
// dt = -du(t0) / u'(t0). There is no force at either end, so that both are shifts in time alone:
//
//   dx(t0 + T) = exp(S T) dx(t0) + T sum over k of (T S)^k b mu_k,
//   mu_k = (I_k df)(1) + dlnT ((k + 1) m_k - m_(k-1)) - dt/T m_(k-1)
//
// that is: what is left of x1 after exp(S T) x0 is differentiated by f and T and moved by dt, and
// what S x1 dT and S x0 dt would add cancels but for the terms of the force.
#pragma once

#include "common/decompositions.h"
#include "motion/episode/contact_episode.h"

namespace vibroimpact::motion {

class ContactMap {
public:
  /// Of the contact that `solved` has solved last, from x0 on. Keeps references; made anew for each
  /// contact.
  ContactMap(const ContactEpisode &solved, const ForcedOutput &penetration, const double *x0);

  /// What the force adds to deviations of x, size x any number of columns at the touch: the
  /// deviations at the release are exp(S T) columns plus this.
  Matrix forced(const Matrix &columns) const;
  /// What the damping of the contact adds to the integral of the divergence, tr S T without it.
  double divergence() const;

private:
  /// Of each column.
  struct Shift {
    Matrix forces;     ///< df [N], nodes x columns
    RowVector length;  ///< dlnT
    RowVector instant; ///< dt / T
  };
  Shift shift(const Matrix &columns) const;
  double end_scale() const;
  void factorise();

  const ContactEpisode &solved_;
  const ForcedOutput &penetration_;
  Index n_;                  ///< nodes
  Vector positions_;         ///< theta X of the nodes and the end
  Vector powers_;            ///< g_k theta^k
  Vector coefficients_;      ///< d_k of the motion, one more than there are terms
  LuFactors<Matrix> newton_; ///< of the exact matrix, without dimensions
};

} // namespace vibroimpact::motion
