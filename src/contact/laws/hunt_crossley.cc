#include "contact/laws/hunt_crossley.h"

#include "contact/restitution_relation.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Hunt-Crossley";
enum : int { open = 0, contact = 1, separating = 2, slow_contact = 3, slow_separating = 4 };

bool acts(int mode) { return mode == contact || mode == slow_contact; }

// With d = d_c / z, z being the remembered approach speed, the force ends where z - d_c gap_rate
// falls to zero. An impact that began slower than v_min passes on to a contact with z = v_min: were
// it cut off by its own z and damped by v_min, the force would jump there, and a body pressed on
// would be pushed and let go for ever.
std::vector<Mode> make_modes(double damping, double lowest_speed) {
  const AffineForm push{.gap_rate = -damping, .internal = {1}};
  AffineLaw no_force;
  no_force.internal_rate.resize(1);
  std::vector<Mode> modes = open_contact_separating(push, std::nullopt, no_force);
  modes[open].guards[0].reset = {{.gap_rate = -1}};
  Mode slow = modes[contact];
  slow.name = "slow contact";
  slow.guards.back().target = slow_separating;
  Mode slow_apart = modes[separating];
  slow_apart.name = "slow separating";
  slow_apart.guards.back().target = slow_contact;
  Guard &too_slow = modes[contact].guards.emplace_back();
  too_slow.indicator.constant = -lowest_speed;
  too_slow.indicator.internal.assign(1, 1.0);
  too_slow.target = slow_contact;
  too_slow.reset.resize(1);
  too_slow.reset[0].constant = lowest_speed;
  modes.push_back(slow);
  modes.push_back(slow_apart);
  return modes;
}

} // namespace

HuntCrossley::HuntCrossley(std::vector<Mode> modes, std::vector<double> initial_internal,
                           HertzConstants constants, double coefficient, double lowest_speed)
    : ContactLaw(std::move(modes), std::move(initial_internal)), constants_(constants),
      coefficient_(coefficient), lowest_speed_(lowest_speed) {}

std::shared_ptr<HuntCrossley> HuntCrossley::with_dissipation(HertzConstants constants,
                                                             double dissipation) {
  return std::shared_ptr<HuntCrossley>(
      new HuntCrossley(open_contact_separating({.constant = 1, .gap_rate = -dissipation}), {},
                       constants, dissipation, 0));
}

std::shared_ptr<HuntCrossley> HuntCrossley::with_dimensionless_damping(HertzConstants constants,
                                                                       double dimensionless_damping,
                                                                       double lowest_speed) {
  return std::shared_ptr<HuntCrossley>(
      new HuntCrossley(make_modes(dimensionless_damping, lowest_speed), {1.0}, constants,
                       dimensionless_damping, lowest_speed));
}

int HuntCrossley::initial_mode(const LocalState &state) const {
  if (state.gap >= 0)
    return open;
  return lowest_speed_ > 0 && state.internal[0] <= lowest_speed_ ? slow_contact : contact;
}

double HuntCrossley::dissipation(const LocalState &state) const {
  return lowest_speed_ > 0 ? coefficient_ / std::max(state.internal[0], lowest_speed_)
                           : coefficient_;
}

void HuntCrossley::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double penetration = acts(mode) ? std::max(0.0, -state.gap) : 0;
  const double slope = constants_.secant(penetration);
  const double elastic = slope * penetration;
  const double d = dissipation(state);
  const double factor = 1 - d * state.gap_rate;
  response.force = elastic * factor;
  response.force_by_gap = -constants_.exponent * slope * factor;
  response.force_by_gap_rate = -elastic * d;
  response.stored_energy = elastic * penetration / (constants_.exponent + 1);
  response.dissipated_power = elastic * d * state.gap_rate * state.gap_rate;
  if (lowest_speed_ > 0) {
    // d d / d z = -d / z above the lowest speed
    const double by_speed = state.internal[0] > lowest_speed_ ? -d / state.internal[0] : 0;
    response.force_by_internal = {-elastic * by_speed * state.gap_rate};
    response.internal_rate = {0};
    response.internal_rate_by_gap = {0};
    response.internal_rate_by_gap_rate = {0};
    response.internal_rate_by_internal = {0};
  }
}

std::vector<InternalState> HuntCrossley::internal_states() const {
  if (lowest_speed_ == 0)
    return {};
  return {{.name = "approach_speed",
           .unit = "m/s",
           .description = "Approach speed of the latest impact, no less than the lowest one"}};
}

std::optional<PowerLaw> HuntCrossley::power_law() const {
  PowerLaw law{.stiffness = constants_.stiffness, .exponent = constants_.exponent};
  if (lowest_speed_ > 0)
    law.dissipation.reset();
  else
    law.dissipation = coefficient_;
  return law;
}

// Cut off, 1 + d u' falls to zero while there is still penetration.
std::optional<ForcePulse> HuntCrossley::force_pulse(int mode) const {
  if (!acts(mode))
    return std::nullopt;
  const ForceEdge touch{.power = constants_.exponent};
  return ForcePulse{.begin = touch, .ends = {{.guard = 0, .edge = touch}, {.guard = 1}}};
}

void HuntCrossley::declare(parameters::Section &contact_section) {
  using namespace parameters;
  Section &law = contact_section.subsection(
      section_name, "Hertz contact with damping proportional to the elastic force: "
                    "F = k u^n (1 + (mu/k) u'). Give the damping factor or a restitution "
                    "coefficient.");
  declare_hertz_constants(law);
  law.quantity("Damping factor", "", dimension::any, range::non_negative, "mu",
               "Damping factor in N s/m^(n+1).")
      .quantity("Restitution coefficient", "", dimension::none,
                Range{.lower = 0, .upper = 1, .lower_open = true}, "e",
                "Restitution that two free bodies with this contact show.")
      .required("Damping factor is not given")
      .choice("Relation", "exact", restitution_relations(),
              "Formula that turns the restitution coefficient into the damping factor.")
      .quantity("Approach speed", "", dimension::velocity, range::positive, "v_c",
                "Approach speed the restitution coefficient belongs to; leave empty to take that "
                "of each impact.")
      .quantity("Lowest approach speed", "1e-6 m/s", dimension::velocity, range::positive, "v_min",
                "Where each impact takes its own approach speed: slower impacts are damped as if "
                "they had this one.");
}

std::shared_ptr<const ContactLaw> HuntCrossley::create(const parameters::Values &contact_values) {
  const parameters::Values law = contact_values.subsection(section_name);
  const HertzConstants constants = read_hertz_constants(law);
  if (law.has("Damping factor") && law.has("Restitution coefficient"))
    law.reject("Damping factor",
               "Damping factor must not be set when Restitution coefficient is set.");
  if (!law.has("Damping factor"))
    law.require("Restitution coefficient");
  if (law.has("Damping factor")) {
    const parameters::Dimension unit{.length = -constants.exponent, .mass = 1, .time = -1};
    return with_dissipation(constants,
                            law.quantity_of("Damping factor", unit) / constants.stiffness);
  }
  const double damping =
      dimensionless_damping(law.choice("Relation"), law.quantity("Restitution coefficient"));
  if (!std::isfinite(damping))
    law.reject("Restitution coefficient",
               "Restitution coefficient is so small that its damping factor is no number.");
  if (law.has("Approach speed"))
    return with_dissipation(constants, damping / law.quantity("Approach speed"));
  return with_dimensionless_damping(constants, damping, law.quantity("Lowest approach speed"));
}

} // namespace vibroimpact::contact
