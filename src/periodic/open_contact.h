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

/// The same law without the guards that close the contact.
class OpenContact : public contact::ContactLaw {
public:
  explicit OpenContact(std::shared_ptr<const contact::ContactLaw> law);

  std::string name() const override { return law_->name(); }
  std::vector<contact::InternalState> internal_states() const override {
    return law_->internal_states();
  }
  int initial_mode(const contact::LocalState &state) const override;
  void evaluate(int mode, const contact::LocalState &state,
                contact::LawResponse &response) const override {
    law_->evaluate(mode, state, response);
  }

private:
  std::shared_ptr<const contact::ContactLaw> law_;
};

/// The same law without one guard of a mode, in which all motions begin.
class KeptContact : public contact::ContactLaw {
public:
  KeptContact(std::shared_ptr<const contact::ContactLaw> law, const Overlooked &overlooked);

  std::string name() const override { return law_->name(); }
  std::vector<contact::InternalState> internal_states() const override {
    return law_->internal_states();
  }
  int initial_mode(const contact::LocalState & /*state*/) const override { return mode_; }
  void evaluate(int mode, const contact::LocalState &state,
                contact::LawResponse &response) const override {
    law_->evaluate(mode, state, response);
  }

private:
  std::shared_ptr<const contact::ContactLaw> law_;
  int mode_;
};

/// Does passing this guard of a law close the contact?
bool closes(const contact::ContactLaw &law, const contact::Guard &guard);

/// The contacts with one of them overlooking guards.
contact::ContactSet overlooking(const contact::ContactSet &contacts, const Overlooked &overlooked);

} // namespace vibroimpact::periodic
