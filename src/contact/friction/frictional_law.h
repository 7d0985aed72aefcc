// A normal law together with a law of friction.
//
// Its modes are made once: those of the normal law without a force, and for each of the others one
// for each mode of the tangential law. Guards of the normal law come first: where the normal force
// ends, so does friction. The internal states of the tangential law stand behind those of the
// normal one.
//
// Where the normal law has no affine form, neither has the product: forms of the tangential law
// then see the normal force by value, and its rate by the chain rule from gap rate and
// acceleration.
//
// Rigid sides slide by the force that holds the gap, which is a form like others. Their impacts and
// what they begin to do at rest depend on the coefficients of friction alone.
#pragma once

#include "contact/friction/tangential_law.h"

#include <memory>

namespace vibroimpact::contact {

class FrictionalLaw : public ContactLaw {
public:
  /// The two must fit together; see why_no_friction().
  FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                std::shared_ptr<const TangentialLaw> tangential);

  std::string name() const override { return normal_->name() + " with " + tangential_->name(); }
  std::vector<InternalState> internal_states() const override;
  int n_tangential() const override { return tangential_->n_directions(); }
  int initial_mode(const LocalState &state) const override;
  int mode_by_slip(int mode, const LocalState &state) const override;
  std::string objection(int mode, const LocalState &state) const override;
  void leave(int mode, const LocalState &state, std::span<double> internal) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override { return normal_->elastic_force(); }
  /// That of the normal force, where friction has no states, the sides slide, and its force is in
  /// proportion to the normal one.
  std::optional<ForcePulse> force_pulse(int mode) const override;
  double restitution(double approach_speed) const override {
    return normal_->restitution(approach_speed);
  }
  RestitutionHypothesis hypothesis() const override { return normal_->hypothesis(); }
  double impact_friction() const override;
  double static_friction() const override;

private:
  /// What a mode is made of; tangential: -1 where no friction acts.
  struct Part {
    int normal = 0;
    int tangential = -1;
    bool evaluated = false; ///< the tangential law has no forms in it
  };
  struct Product;
  FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                std::shared_ptr<const TangentialLaw> tangential, Product product);
  static int place(const std::vector<Part> &parts, int normal, int tangential);
  static Product multiply(const ContactLaw &normal, const TangentialLaw &tangential);
  /// Partial derivatives of the normal force and of its rate, as forms.
  struct NormalForce {
    AffineForm force, rate;
    double by_gap_acceleration = 0;
  };
  NormalForce normal_force(int mode, const LocalState &state, const LawResponse &normal) const;
  void add_curvature(int mode, const LocalState &state, const LawResponse &normal,
                     AffineForm &rate) const;
  TangentialValues friction(int mode, const LocalState &state) const;
  void add_friction(int mode, const NormalForce &normal, const TangentialValues &friction,
                    LawResponse &response) const;
  void add_work(int mode, const LocalState &state, const TangentialValues &friction,
                LawResponse &response) const;
  LocalState of_normal(const LocalState &state) const;
  int mode_of(int normal, int tangential) const;

  std::shared_ptr<const ContactLaw> normal_;
  std::shared_ptr<const TangentialLaw> tangential_;
  std::vector<Part> parts_;
  std::vector<AffineLaw> forms_; ///< of the tangential law in each mode
};

/// Why a normal law cannot be combined with a law of friction; empty: it can.
std::string why_no_friction(const ContactLaw &normal, const TangentialLaw &tangential);

} // namespace vibroimpact::contact
