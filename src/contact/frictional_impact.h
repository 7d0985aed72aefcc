// An impact at one point of two rigid sides that rub on each other, by the impulse that has acted.
//
// While they touch, the impulse p along the normal grows and the velocities change by it. With
// G = [a b; b d] = W M^-1 W^T, the rows of W those of the gap and of the slip (Routh 1905),
//
//   slip, sigma the sign of v_t   dv_n/dp = a - sigma mu b    dv_t/dp = b - sigma mu d
//   stick, where |b| <= mu d      dv_n/dp = a - b^2 / d       v_t = 0
//
// and where v_t = 0 is passed with |b| > mu d the slip goes on with sigma = sign b. Between such
// changes v_n and v_t are linear in p: a slip that ends, what comes after it, each before or after
// the greatest compression v_n = 0. Slip in which v_n would fall, a <= sigma mu b, comes to an end
// by itself, since then sigma b > mu d a mu b / (a d) makes |v_t| fall.
//
// The impact is over where (Wang and Mason 1992; Stronge 1990)
//
//   newton      v_n = -e v_n before
//   poisson     p = (1 + e) p_c, p_c that of the greatest compression
//   energetic   the integral of v_n dp since then is e^2 times what it was until then
//
// The three agree where b = 0 or the slip neither stops nor turns. Of newton alone energy may grow.
#pragma once

#include "common/linear_algebra.h"
#include "contact/contact_law.h"

namespace vibroimpact::contact {

struct PointImpact {
  double normal = 0;      ///< a > 0 [1/kg]
  double coupling = 0;    ///< b, b^2 <= a d
  double tangential = 0;  ///< d > 0
  double gap_rate = 0;    ///< v_n before; an impact where it is below zero [m/s]
  double slip_rate = 0;   ///< v_t [m/s]
  double friction = 0;    ///< mu > 0
  double restitution = 0; ///< 0 <= e <= 1
  RestitutionHypothesis hypothesis = RestitutionHypothesis::energetic; ///< of e
};

/// Along the normal and the tangential direction.
struct PointImpulse {
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero(); ///< on side b [N s]
  Eigen::Vector2d after = Eigen::Vector2d::Zero();   ///< v_n, v_t [m/s]; zero where they are held
  double rubbing = 0;                                ///< integral of |v_t| dp [J]
  /// Of the impulse by v_n and v_t before it [kg].
  Eigen::Matrix2d by_rates = Eigen::Matrix2d::Zero();
};

PointImpulse impulse_at_point(const PointImpact &impact);

} // namespace vibroimpact::contact
