// A contact that overlooks a guard: what a motion does when a shallow touch, or a short release, is
// not seen.
//
// Near a graze the map of a motion is smooth on either side only. With the contact kept in its mode
// while the guard dips below zero, both sides have one smooth extension, the same before the graze,
// from which the graze is located as a zero of the least value of the guard.
#pragma once

#include "contact/contact_set.h"

#include <compare>

namespace vibroimpact::periodic {

/// Guards of a contact that are left out.
struct Overlooked {
  std::size_t contact = 0;
  /// The mode in contact that is kept, without the guard; none: the contact never closes.
  int kept_mode = -1;
  std::size_t guard = 0;

  auto operator<=>(const Overlooked &) const = default;
};

/// The same law with other modes, which overlook guards.
class OverlookingContact : public contact::ContactLaw {
public:
  std::string name() const override { return law_->name(); }
  std::vector<contact::InternalState> internal_states() const override {
    return law_->internal_states();
  }
  int initial_mode(const contact::LocalState &state) const override {
    return law_->initial_mode(state);
  }
  void evaluate(int mode, const contact::LocalState &state,
                contact::LawResponse &response) const override {
    law_->evaluate(mode, state, response);
  }
  int n_tangential() const override { return law_->n_tangential(); }
  int mode_by_slip(int mode, const contact::LocalState &state) const override {
    return law_->mode_by_slip(mode, state);
  }
  void leave(int mode, const contact::LocalState &state,
             std::span<double> internal) const override {
    law_->leave(mode, state, internal);
  }
  double restitution(double approach_speed) const override {
    return law_->restitution(approach_speed);
  }
  contact::RestitutionHypothesis hypothesis() const override { return law_->hypothesis(); }
  double impact_friction() const override { return law_->impact_friction(); }
  double static_friction() const override { return law_->static_friction(); }
  bool may_pull() const override { return law_->may_pull(); }
  std::string objection(int mode, const contact::LocalState &state) const override {
    return law_->objection(mode, state);
  }

protected:
  OverlookingContact(std::shared_ptr<const contact::ContactLaw> law,
                     std::vector<contact::Mode> modes)
      : ContactLaw(std::move(modes), law->initial_internal()), law_(std::move(law)) {}

private:
  std::shared_ptr<const contact::ContactLaw> law_;
};

/// Without the guards that close the contact.
class OpenContact : public OverlookingContact {
public:
  explicit OpenContact(std::shared_ptr<const contact::ContactLaw> law);
  int initial_mode(const contact::LocalState &state) const override;
};

/// Without one guard of a mode, in which all motions begin.
class KeptContact : public OverlookingContact {
public:
  KeptContact(std::shared_ptr<const contact::ContactLaw> law, const Overlooked &overlooked);
  int initial_mode(const contact::LocalState & /*state*/) const override { return mode_; }
  int mode_by_slip(int mode, const contact::LocalState &state) const override {
    return mode == mode_ ? mode : OverlookingContact::mode_by_slip(mode, state);
  }

private:
  int mode_;
};

/// Does passing this guard of a law close the contact?
bool closes(const contact::ContactLaw &law, const contact::Guard &guard);

/// The contacts with one of them overlooking guards.
contact::ContactSet overlooking(const contact::ContactSet &contacts, const Overlooked &overlooked);

} // namespace vibroimpact::periodic
