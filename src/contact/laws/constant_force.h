// A normal force that is always the same: F > 0, whatever the gap does.
//
// The sides are pressed on each other by something that yields, such as a bolt, a weight or a
// soft spring, and never part. With friction it is an element of a joint, a damper or a bearing
// whose force has a constant limit.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class ConstantForce : public ContactLaw {
public:
  /// force > 0 [N]
  explicit ConstantForce(double force);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "constant force"; }
  int initial_mode(const LocalState & /*state*/) const override { return 0; }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;

private:
  double force_;
};

} // namespace vibroimpact::contact
