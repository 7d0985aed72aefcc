// Motions with rigid contacts for tests.
#pragma once

#include "contact/laws/newton_restitution.h"
#include "model/piecewise_function.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace vibroimpact::testing {

inline std::shared_ptr<const contact::ContactLaw> newton(double restitution) {
  return std::make_shared<contact::NewtonRestitution>(restitution);
}

inline Vector vector_of(std::initializer_list<double> values) {
  Vector vector(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), vector.begin());
  return vector;
}

inline void add_weight(model::Model &model, double gravity,
                       const std::vector<std::size_t> &bodies) {
  model.add_gravity("weight", model::make_constant(model::Given::displacement, gravity), bodies,
                    Vector3::UnitX());
}

/// A stop on the base that the body stands on.
inline contact::ContactPair stop_on_base(const model::Model &model, const std::string &side_a,
                                         double clearance,
                                         std::shared_ptr<const contact::ContactLaw> law) {
  contact::ContactPair pair = contact_along_x(model, side_a, "", clearance, std::move(law));
  for (double &base_coefficients : pair.gap.base_coefficients)
    base_coefficients = 0;
  return pair;
}

/// Keeps all events, and calls `check` for each step.
class Events : public motion::Observer {
public:
  struct Event {
    double time = 0;
    std::size_t contact = 0;
    int from = 0, to = 0;
    bool onset = false;
    double gap_rate = 0, gap_rate_after = 0, chatter_duration = 0;
  };
  void event(const motion::ContactEvent &event) override {
    list.push_back({event.time, event.contact, event.from, event.to, event.onset, event.gap_rate,
                    event.gap_rate_after, event.chatter_duration});
  }
  std::vector<Event> list;
};

inline motion::Settings settings_of(const std::string &method) {
  motion::Settings settings;
  settings.method = method;
  if (method == "rk")
    settings.relative_tolerance = 1e-12;
  return settings;
}

} // namespace vibroimpact::testing
