// Impulses of several rigid contacts with friction at one instant, and their forces while they
// last.
//
// Each contact i has two rows of W, that of the gap and that of the slip (zero where it has no
// friction). With G = W M^-1 W^T the rates become v = q + G p, or the accelerations by forces p.
// For each contact one of these holds (Moreau 1988; Glocker and Pfeiffer 1995):
//
//   open    p_n = p_t = 0               v_n >= 0
//   stick   v_n = 0, v_t = 0            p_n >= 0, |p_t| <= mu_s p_n
//   slip    v_n = 0, p_t = -s mu p_n    p_n >= 0, s v_t >= 0           s = +-1
//
// The modes are guessed by Gauss-Seidel steps, contact by contact; when they repeat, the linear
// system of these modes is solved and all inequalities are judged. Problems that this does not
// solve go on across the inequality that is violated most, from these states and from random ones;
// small ones by trying all states.
//
// Impacts by components of contacts that act on each other: one alone by its course
// (frictional_impact.h), several by v_n + e v_n before in place of v_n, direction of slip that
// after the impact. There energy may grow; where p . (v before + v after) / 2 is above zero, or
// sides that wedge have no such impulses, the restitution coefficients of the component are reduced
// by one factor until it is zero. For e = 0 it never grows: p_n v_n = 0 and p_t v_t <= 0 after, and
// p . (v before + v after) / 2 = p . v after - p . G p / 2.
#pragma once

#include "contact/frictional_impact.h"

#include <vector>

namespace vibroimpact::contact {

struct ContactFriction {
  double coefficient = 0; ///< mu; 0: none acts
  double at_rest = 0;     ///< mu_s >= mu
  int slides = 0;         ///< the sign of the slip where that is known; 0: it is not
};

/// What a contact does.
enum class FrictionalState { open, stick, forward, backward };

struct FrictionalSolution {
  Vector impulses; ///< p_n, p_t of each contact, one after the other
  std::vector<FrictionalState> states;
  Matrix by_start; ///< of the impulses by q
};

enum class FrictionalEffort { full, limited };

/// `matrix`: G; `start`: q. NumericalError when no states of the contacts fit, or, with limited
/// effort, when none is found soon.
FrictionalSolution solve_frictional(const Matrix &matrix, const Vector &start,
                                    const std::vector<ContactFriction> &contacts,
                                    FrictionalEffort effort = FrictionalEffort::full);

struct FrictionalImpulses {
  Vector impulses, after; ///< impulses, rates after them
  Vector friction_work;   ///< of each contact, what friction takes [J]
  Vector rubbing;         ///< integral of |v_t| dp_n [J]
  Matrix by_rates;        ///< of the impulses by the rates before
  long reduced = 0;       ///< components whose restitution was reduced
};

/// Of contacts that approach, rest or touch; `restitution`: of each, 0 where nothing approaches.
struct FrictionalImpact {
  Matrix matrix; ///< G
  Vector rates;  ///< v_n, v_t of each before
  std::vector<ContactFriction> contacts;
  Vector restitution;
  std::vector<RestitutionHypothesis> hypotheses;
};
FrictionalImpulses frictional_impulses(const FrictionalImpact &impact);

} // namespace vibroimpact::contact
