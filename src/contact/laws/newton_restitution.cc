#include "contact/laws/newton_restitution.h"

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Newton restitution";
enum : int { open = 0, resting = 1 };

std::vector<Mode> make_modes() {
  const Guard meet{
      .indicator = {.gap = 1}, .target = resting, .reset = {}, .action = GuardAction::impact};
  const AffineForm push{.normal_force = 1};
  const Guard let_go{.indicator = push, .target = open};
  return {{.name = "open", .in_contact = false, .guards = {meet}, .affine = AffineLaw{}},
          {.name = "resting",
           .in_contact = true,
           .guards = {let_go},
           .affine = AffineLaw{.force = push},
           .holds_gap = true}};
}

RestitutionHypothesis hypothesis_of(const std::string &name) {
  return name == "newton"    ? RestitutionHypothesis::newton
         : name == "poisson" ? RestitutionHypothesis::poisson
                             : RestitutionHypothesis::energetic;
}

} // namespace

NewtonRestitution::NewtonRestitution(double coefficient, RestitutionHypothesis hypothesis)
    : ContactLaw(make_modes(), {}), coefficient_(coefficient), hypothesis_(hypothesis) {}

void NewtonRestitution::declare(parameters::Section &contact_section) {
  using namespace parameters;
  contact_section
      .subsection(
          section_name,
          "Rigid sides that never overlap: the separation speed is a fraction of the approach "
          "speed; they remain in contact while they are pressed together.")
      .quantity("Restitution coefficient", "", dimension::none, Range{.lower = 0, .upper = 1}, "e",
                "Separation speed over approach speed; 1 loses no energy.")
      .required()
      .choice(
          "Hypothesis", "energetic", {"energetic", "newton", "poisson"},
          "What the coefficient is a ratio of where friction acts between the sides: the square "
          "root of the work that the normal force gives back and takes (Stronge), the speeds "
          "along the normal, or the impulses of restitution and compression. Without friction "
          "all are the same.");
}

std::shared_ptr<const ContactLaw>
NewtonRestitution::create(const parameters::Values &contact_values) {
  const parameters::Values law = contact_values.subsection(section_name);
  law.require("Restitution coefficient");
  return std::make_shared<NewtonRestitution>(law.quantity("Restitution coefficient"),
                                             hypothesis_of(law.choice("Hypothesis")));
}

// Sides that touch begin open: whether they are pressed together is for the whole system to tell.
int NewtonRestitution::initial_mode(const LocalState & /*state*/) const { return open; }

// The power takes in what an error of the integration leaves of the gap rate.
void NewtonRestitution::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  response.force = mode == resting ? state.normal_force : 0;
  response.force_by_gap = 0;
  response.force_by_gap_rate = 0;
  response.stored_energy = 0;
  response.dissipated_power = -response.force * state.gap_rate;
}

} // namespace vibroimpact::contact
