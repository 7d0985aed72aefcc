// A normal force that the file gives as an expression of penetration and its rate.
//
//   F = F(u, v)                u  penetration [m], v its rate [m/s], both > 0 while the sides
//   approach
//
// differentiated exactly. Stored energy: the integral of F(w, 0) over w from 0 to u; dissipated
// power [F(u, v) - F(u, 0)] v, negative where the formula drives the motion. So the elastic part is
// what is left of the force when nothing moves.
//
// A formula that is linear in u and v has an affine form, and its motion a closed one. Of others a
// contact is solved in one step where the formula is smooth between touch and release. A force that
// pulls, and one that jumps at the touch, are refused unless the file allows them: by trial where
// nothing moves, and during the motion by objection(). Where v stands in one linear factor alone,
// u^(3/2) (1 + d v) say, the force can be cut off where this factor falls to zero.
#pragma once

#include "contact/contact_law.h"
#include "contact/laws/formula_shape.h"
#include "contact/laws/integrated_force.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

enum class Tension {
  refused,
  cut_off, ///< no force instead
  pulls,
};

class FormulaLaw : public ContactLaw {
public:
  /// largest_penetration > 0 [m]: up to there the law is to hold. std::invalid_argument where a
  /// force that pulls cannot be cut off.
  FormulaLaw(parameters::Formula formula, double largest_penetration, Tension tension);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "formula"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::string objection(int mode, const LocalState &state) const override;
  std::optional<ElasticForce> elastic_force() const override { return shape_.elastic; }
  bool may_pull() const override { return tension_ == Tension::pulls; }
  std::optional<ForcePulse> force_pulse(int mode) const override;

  /// At a penetration that does not change: the greatest penetration up to the largest one at
  /// which the force is no number, or pulls by more than its rounding; empty: there is none.
  std::string fault_at_rest() const;
  /// Is there a force at the touch, at a speed of either sign?
  bool jumps() const;

private:
  FormulaLaw(parameters::Formula formula, const FormulaShape &shape, double largest_penetration,
             Tension tension);
  bool acts(int mode) const;
  double stored(double penetration) const;

  parameters::Formula formula_;
  FormulaShape shape_;
  double largest_penetration_;
  Tension tension_;
  IntegratedForce energy_;
};

} // namespace vibroimpact::contact
