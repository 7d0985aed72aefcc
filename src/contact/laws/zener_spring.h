// Springs and a dashpot without masses between two ends, in both directions: the model of Zener,
// also called standard linear solid, with a dashpot that may follow a power.
//
//   ends --- k1 --- inner node --- k2 --- ends         e   elongation [m], the gap of the pair
//                        |                             e2  of the inner node from the second end
//                        +---- k3 --- dashpot          z   elongation of the dashpot [m]
//
//   T = k1 (e - e2) = k2 e2 + S,   S = k3 (e2 - z) = c |z'|^a sgn(z')
//
// k1, k2, k3 [N/m], c [N (s/m)^a], T the tension [N], the force with the opposite sign. Without k1
// the first spring is rigid; without k2 what is left is Maxwell's model. z is an internal state,
//
//   e2 = (k1 e + k3 z) / (k1 + k2 + k3),   z' = (|S| / c)^(1/a) sgn(S)
//
// With a = 1 the law is affine, with the relaxation time c (k1 + k2 + k3) / (k3 (k1 + k2)).
// Exponents above 1 would make z' rise with an infinite slope from S = 0. Stored energy: that of
// the three springs; dissipated power S z'.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>
#include <optional>

namespace vibroimpact::contact {

struct ZenerConstants {
  std::optional<double> series{}; ///< k1 > 0 [N/m]; none: rigid
  double parallel = 0;            ///< k2 >= 0 [N/m]
  double branch = 0;              ///< k3 > 0 [N/m]
  double damping = 0;             ///< c > 0 [N (s/m)^a]
  double exponent = 1;            ///< 0 < a <= 1
};

class ZenerSpring : public ContactLaw {
public:
  explicit ZenerSpring(const ZenerConstants &constants);

  static void declare(parameters::Section &connection);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &connection);

  std::string name() const override { return "zener spring of a connection"; }
  std::vector<InternalState> internal_states() const override;
  int initial_mode(const LocalState & /*state*/) const override { return 0; }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  bool may_pull() const override { return true; }

private:
  ZenerConstants constants_;
};

} // namespace vibroimpact::contact
