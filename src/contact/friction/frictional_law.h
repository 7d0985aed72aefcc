// A normal law together with a law of friction.
//
// Its modes are made once: those of the normal law without a force, and for each of the others one
// for each mode of the tangential law. Guards of the normal law come first: where the normal force
// ends, so does friction. The internal states of the tangential law stand behind those of the
// normal one.
#pragma once

#include "contact/friction/tangential_law.h"

#include <memory>

namespace vibroimpact::contact {

class FrictionalLaw : public ContactLaw {
public:
  /// The normal law must be affine in all its modes and have no rigid ones; see why_no_friction().
  FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                std::shared_ptr<const TangentialLaw> tangential);

  std::string name() const override { return normal_->name() + " with " + tangential_->name(); }
  std::vector<InternalState> internal_states() const override;
  int n_tangential() const override { return 1; }
  int initial_mode(const LocalState &state) const override;
  int mode_by_slip(int mode, const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override { return normal_->elastic_force(); }

private:
  /// What a mode is made of; tangential: -1 where no friction acts.
  struct Part {
    int normal = 0;
    int tangential = -1;
  };
  struct Product;
  FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                std::shared_ptr<const TangentialLaw> tangential, Product product);
  static Product multiply(const ContactLaw &normal, const TangentialLaw &tangential);
  LocalState of_normal(const LocalState &state) const;
  int mode_of(int normal, int tangential) const;

  std::shared_ptr<const ContactLaw> normal_;
  std::shared_ptr<const TangentialLaw> tangential_;
  std::vector<Part> parts_;
};

/// Why a normal law cannot be combined with this law of friction; empty: it can.
std::string why_no_friction(const ContactLaw &normal, const TangentialLaw &tangential);

} // namespace vibroimpact::contact
