// The normal law of a contact whose gap is no affine form of the motion: the same modes, forces and
// guards, but wherever there is a force none of its modes is affine.
#pragma once

#include "contact/contact_law.h"

#include <memory>

namespace vibroimpact::contact {

class CurvedGapLaw : public ContactLaw {
public:
  explicit CurvedGapLaw(std::shared_ptr<const ContactLaw> law);

  std::string name() const override { return law_->name(); }
  std::vector<InternalState> internal_states() const override { return law_->internal_states(); }
  int initial_mode(const LocalState &state) const override { return law_->initial_mode(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override {
    law_->evaluate(mode, state, response);
  }
  std::optional<ElasticForce> elastic_force() const override { return law_->elastic_force(); }
  bool may_pull() const override { return law_->may_pull(); }
  std::string objection(int mode, const LocalState &state) const override {
    return law_->objection(mode, state);
  }
  double restitution(double approach_speed) const override {
    return law_->restitution(approach_speed);
  }
  RestitutionHypothesis hypothesis() const override { return law_->hypothesis(); }
  /// Of a force in proportion to the penetration too, which is no affine form here.
  std::optional<ForcePulse> force_pulse(int mode) const override;

private:
  std::shared_ptr<const ContactLaw> law_;
};

} // namespace vibroimpact::contact
