#include "contact/laws/formula_spring.h"

#include "contact/laws/formula_shape.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace vibroimpact::contact {

namespace {

// Within the range, and a mode behind it that objects.
std::vector<Mode> within(const parameters::Formula &tension, double largest_elongation) {
  Mode inside{.name = "connected", .in_contact = true};
  if (const std::optional<LinearForm> linear = shape_of(tension).linear)
    inside.affine = AffineLaw{.force = {.constant = -linear->constant,
                                        .gap = -linear->by_penetration,
                                        .gap_rate = -linear->by_rate}};
  for (const double sign : {1.0, -1.0})
    inside.guards.push_back(
        {.indicator = {.constant = largest_elongation, .gap = sign}, .target = 1});
  return {inside, {.name = "beyond", .in_contact = true}};
}

std::string at(double elongation) {
  std::ostringstream text;
  text << "at an elongation of " << elongation << " m";
  return text.str();
}

} // namespace

FormulaSpring::FormulaSpring(parameters::Formula tension, double largest_elongation)
    : ContactLaw(within(tension, largest_elongation), {}), tension_(std::move(tension)),
      largest_elongation_(largest_elongation),
      stretched_([t = tension_](double e) { return t(e, 0).value; }, largest_elongation),
      pressed_([t = tension_](double e) { return -t(-e, 0).value; }, largest_elongation) {}

void FormulaSpring::evaluate(int /*mode*/, const LocalState &state, LawResponse &response) const {
  const parameters::Dual tension = tension_(state.gap, state.gap_rate);
  response.force = -tension.value;
  response.force_by_gap = -tension.by[0];
  response.force_by_gap_rate = -tension.by[1];
  response.stored_energy = state.gap > 0 ? stretched_(state.gap) : pressed_(-state.gap);
  const std::optional<AffineLaw> &affine = modes().front().affine;
  response.dissipated_power = affine
                                  ? -affine->force.gap_rate * state.gap_rate * state.gap_rate
                                  : (tension.value - tension_(state.gap, 0).value) * state.gap_rate;
}

std::string FormulaSpring::objection(int mode, const LocalState &state) const {
  if (mode == 1)
    return "is asked for beyond its Largest elongation, " + at(state.gap) + ",";
  return std::isfinite(tension_(state.gap, state.gap_rate).value)
             ? ""
             : "is no finite number " + at(state.gap);
}

std::string FormulaSpring::fault_at_rest() const {
  constexpr int places = 1000; // on either side
  for (int k = -places; k <= places; ++k)
    if (const double e = largest_elongation_ * k / places; !std::isfinite(tension_(e, 0).value))
      return "is no finite number " + at(e);
  return "";
}

} // namespace vibroimpact::contact
