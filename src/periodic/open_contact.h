// A contact that never closes: what a motion does when a shallow touch is overlooked.
//
// Near a graze the map of a motion is smooth on either side only. With the contact kept open while
// its gap dips, both sides have one smooth extension, the same before the graze, from which the
// graze is located as a zero of the least value of the guard.
#pragma once

#include "contact/contact_set.h"

namespace vibroimpact::periodic {

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

/// Does passing this guard of a law close the contact?
bool closes(const contact::ContactLaw &law, const contact::Guard &guard);

/// The contacts with one of them kept open.
contact::ContactSet with_open(const contact::ContactSet &contacts, std::size_t contact);

} // namespace vibroimpact::periodic
