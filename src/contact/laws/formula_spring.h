// A connection between two ends whose tension the file gives as an expression, in both directions.
//
//   T = T(e, v)                e  elongation [m], the gap of the pair, v its rate [m/s]
//                              T  tension [N], the force with the opposite sign
//
// differentiated exactly. Stored energy: the integral of T(w, 0) from 0 to e; dissipated power
// [T(e, v) - T(e, 0)] v. The ends never part. A formula that is linear in e and v has an affine
// form.
#pragma once

#include "contact/contact_law.h"
#include "contact/laws/integrated_force.h"
#include "parameters/formula.h"

namespace vibroimpact::contact {

class FormulaSpring : public ContactLaw {
public:
  /// largest_elongation > 0 [m], of either sign: up to there the law is to hold.
  FormulaSpring(parameters::Formula tension, double largest_elongation);

  std::string name() const override { return "formula of a connection"; }
  int initial_mode(const LocalState & /*state*/) const override { return 0; }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::string objection(int mode, const LocalState &state) const override;
  bool may_pull() const override { return true; }

  /// At rest: where up to the largest elongation the tension is no number; empty: nowhere.
  std::string fault_at_rest() const;

private:
  parameters::Formula tension_;
  double largest_elongation_;
  IntegratedForce stretched_, pressed_; ///< the energy at e > 0, and at e < 0
};

} // namespace vibroimpact::contact
