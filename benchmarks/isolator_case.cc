#include "isolator_case.h"

#include "contact/laws/bilinear_stop.h"
#include "vibroimpact_side.h"

namespace vibroimpact::benchmarks {

Isolator isolator_by_hand(double lambda, double mu) {
  return {.zeta0 = 0.01, .zeta1 = 0.2, .mu = mu, .amplitude = 0.52, .forcing = lambda};
}

analyses::System isolator_system(double lambda, double mu) {
  const Isolator values = isolator_by_hand(lambda, mu);
  const auto one = [](double value) { return Vector::Constant(1, value); };
  model::Model model({body_along_x("mass", one(1), one(1), one(2 * values.zeta0), one(1))});
  model.add_force("drive",
                  std::make_shared<model::Harmonic>(model::Given::displacement, values.amplitude,
                                                    values.forcing, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const auto law = std::make_shared<contact::BilinearStop>(values.mu, 2 * values.zeta1);
  std::vector<contact::ContactPair> pairs = {contact_of_heads(model, "mass", "", 1, 1, law),
                                             contact_of_heads(model, "mass", "", -1, 1, law)};
  for (contact::ContactPair &pair : pairs)
    pair.accept_initial_penetration = true;
  contact::ContactSet contacts(std::move(pairs));
  return {.model = std::move(model),
          .contacts = std::move(contacts),
          .integration = {},
          .initial = {.displacement = Vector::Zero(1), .velocity = Vector::Zero(1)}};
}

} // namespace vibroimpact::benchmarks
