#include "motion/settings.h"

namespace vibroimpact::motion {

void declare_integration(parameters::Section &root) {
  using namespace parameters;
  root.subsection("Integration", "How motions are integrated in time.")
      .choice(
          "Method", "exact", {"exact", "moments", "rk", "bdf", "theta", "arkimex"},
          "Time integrator: exact where everything is linear and adaptive Runge-Kutta elsewhere; "
          "moments for many contacts, in steps that no contact change ends (linear models, laws "
          "with finite forces that hold no slip, internal states without relaxation); or "
          "throughout adaptive Runge-Kutta of "
          "order 5 (Dormand-Prince), backward "
          "differentiation, trapezoidal-type theta, or diagonally implicit Runge-Kutta.")
      .quantity("Relative tolerance", "1e-9", dimension::none, Range{.lower = 1e-14, .upper = 0.1},
                "",
                "Error allowed in one step, relative to what the motion has recently been: each "
                "coordinate and velocity to its own size, each contact to its own penetration, "
                "work and impulses to the energy and momentum at hand.")
      .quantity("Absolute tolerance", "", dimension::length, range::positive, "",
                "Displacement at the points below which errors do not matter; velocities follow by "
                "the natural frequencies. Empty: none, and no size of model needs one.")
      .quantity("Event tolerance", "1e-12 s", dimension::time, range::positive, "",
                "Uncertainty allowed in the instant at which a contact begins or ends.")
      .quantity("Maximum step", "", dimension::time, range::positive, "",
                "Longest time step; empty means no limit.")
      .integer("Maximum steps", "0", Range{.lower = 0}, "",
               "Steps after which a case ends as failed; 0 means no limit.")
      .integer("Maximum events", "10000000", Range{.lower = 0}, "",
               "Contact changes after which a case ends as failed; 0 means no limit.");
}

Settings read_integration(const parameters::Values &root) {
  const parameters::Values values = root.subsection("Integration");
  return {.method = values.choice("Method"),
          .relative_tolerance = values.quantity("Relative tolerance"),
          .absolute_tolerance =
              values.has("Absolute tolerance") ? values.quantity("Absolute tolerance") : 0,
          .event_tolerance = values.quantity("Event tolerance"),
          .maximum_step = values.has("Maximum step") ? values.quantity("Maximum step") : 0,
          .maximum_steps = values.integer("Maximum steps"),
          .maximum_events = values.integer("Maximum events")};
}

} // namespace vibroimpact::motion
