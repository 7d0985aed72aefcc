// Newton restitution: the two sides are rigid. They never overlap; where they meet, the speed with
// which they part is a fixed share of that with which they came (Newton's rule).
//
//   gap_rate+ = -e gap_rate-           e  restitution coefficient, 0 <= e <= 1
//
// Where the sides rub on each other the coefficient needs a hypothesis
// (contact/frictional_impact.h); without friction all of them are this rule.
//
// There is no force of finite size during such an impact, only an impulse >= 0, which follows from
// the masses that meet; e = 1 loses no energy, e = 0 leaves the two sides together. Modes:
//   open     no force; ended by an impact where the gap falls to zero
//   resting  the gap is held at zero by the normal force that it takes, which depends on all that
//            acts on the two sides; ended where that force falls to zero
// A free mass m that comes with speed v gets the impulse (1 + e) m v and loses (1 - e^2) m v^2 / 2.
// For e < 1 a mass that is pressed on bounces infinitely often in a finite time, under the
// acceleration g and after an impact with the approach speed v for 2 e v / (g (1 - e)), and rests
// then; the integration completes that (integration/collision.h).
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class NewtonRestitution : public ContactLaw {
public:
  /// 0 <= coefficient <= 1
  explicit NewtonRestitution(double coefficient,
                             RestitutionHypothesis hypothesis = RestitutionHypothesis::energetic);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "newton restitution"; }
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  double restitution(double /*approach_speed*/) const override { return coefficient_; }
  RestitutionHypothesis hypothesis() const override { return hypothesis_; }

private:
  double coefficient_;
  RestitutionHypothesis hypothesis_;
};

} // namespace vibroimpact::contact
