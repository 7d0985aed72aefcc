// No force at all, whatever the gap does: a contact that cannot close in an analysis and whose gap
// is recorded nevertheless.
#pragma once

#include "contact/contact_law.h"

#include <string>

namespace vibroimpact::contact {

class NoForce : public ContactLaw {
public:
  NoForce();

  std::string name() const override { return "no force"; }
  int initial_mode(const LocalState & /*state*/) const override { return 0; }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
};

} // namespace vibroimpact::contact
