#include "contact/laws/kelvin_voigt_bumper.h"

#include <cmath>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Kelvin-Voigt bumper";
enum : int { open = 0, contact = 1, leaving = 2 };

std::vector<Mode> make_modes(double stiffness, double damping_constant) {
  const std::vector<AffineForm> pushed_in = {{.gap = -1}};
  const AffineForm force{.gap = -stiffness, .gap_rate = -damping_constant};
  const AffineLaw pushed{.force = force, .internal_rate = {{.gap_rate = -1}}};
  AffineLaw relaxing;
  relaxing.internal_rate = {{.internal = {-stiffness / damping_constant}}};
  const AffineForm distance{.gap = 1, .internal = {1}};
  // c times the rate of the distance; minus the force at the instant of release
  const AffineForm parting{.gap_rate = damping_constant, .internal = {-stiffness}};
  const Guard meet{.indicator = distance, .target = contact, .reset = pushed_in};
  const Guard let_go{.indicator = force, .target = leaving, .reset = pushed_in};
  const Guard catch_up{.indicator = parting, .target = open};
  return {{.name = "open", .in_contact = false, .guards = {meet}, .affine = relaxing},
          {.name = "contact", .in_contact = true, .guards = {let_go}, .affine = pushed},
          {.name = "leaving", .in_contact = false, .guards = {catch_up}, .affine = relaxing}};
}

} // namespace

KelvinVoigtBumper::KelvinVoigtBumper(double stiffness, double damping_constant)
    : ContactLaw(make_modes(stiffness, damping_constant), {0.0}), stiffness_(stiffness),
      damping_constant_(damping_constant) {}

void KelvinVoigtBumper::declare(parameters::Section &contact_section) {
  using namespace parameters;
  contact_section
      .subsection(
          section_name,
          "Spring and dashpot compressed by the mass; they detach where they would pull, and then "
          "recover by themselves: F = k z + c z' with the compression z of the stop.")
      .quantity("Stiffness", "", dimension::stiffness, range::positive, "k",
                "Contact force per unit compression.")
      .required()
      .quantity("Damping constant", "", dimension::damping, range::positive, "c",
                "Contact force per unit compression rate; the stop recovers with the time constant "
                "c / k.")
      .required();
}

std::shared_ptr<const ContactLaw>
KelvinVoigtBumper::create(const parameters::Values &contact_values) {
  const parameters::Values law = contact_values.subsection(section_name);
  law.require("Stiffness");
  law.require("Damping constant");
  return std::make_shared<KelvinVoigtBumper>(law.quantity("Stiffness"),
                                             law.quantity("Damping constant"));
}

std::vector<InternalState> KelvinVoigtBumper::internal_states() const {
  return {{.name = "stop_deformation",
           .unit = "m",
           .description =
               "Compression of the stop; its end stands this far behind the place it has "
               "when uncompressed"}};
}

// A motion may go on from within a contact or from a release, where the distance gap + z is zero up
// to the error of the integration. A stop that is overlapped without being compressed so far is
// taken over by the guard of "open", which sets z.
int KelvinVoigtBumper::initial_mode(const LocalState &state) const {
  constexpr double integration_error = 1e-9; // relative
  const double compression = state.internal[0];
  if (compression <= 0 || std::abs(state.gap + compression) > integration_error * compression)
    return open;
  return stiffness_ * state.gap + damping_constant_ * state.gap_rate < 0 ? contact : leaving;
}

void KelvinVoigtBumper::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const bool pushed = mode == contact;
  const double compression = pushed ? -state.gap : state.internal[0];
  const double recovery = stiffness_ / damping_constant_;
  const double rate = pushed ? -state.gap_rate : -recovery * compression;
  response.force = pushed ? stiffness_ * compression + damping_constant_ * rate : 0;
  response.force_by_gap = pushed ? -stiffness_ : 0;
  response.force_by_gap_rate = pushed ? -damping_constant_ : 0;
  response.force_by_internal.assign(1, 0);
  response.internal_rate.assign(1, rate);
  response.internal_rate_by_gap.assign(1, 0);
  response.internal_rate_by_gap_rate.assign(1, pushed ? -1.0 : 0.0);
  response.internal_rate_by_internal.assign(1, pushed ? 0 : -recovery);
  response.stored_energy = 0.5 * stiffness_ * compression * compression;
  response.dissipated_power = damping_constant_ * rate * rate;
}

} // namespace vibroimpact::contact
