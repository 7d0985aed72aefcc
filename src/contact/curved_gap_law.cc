#include "contact/curved_gap_law.h"

#include <algorithm>

namespace vibroimpact::contact {

namespace {

bool sees_gap(const AffineForm &form) { return form.gap != 0 || form.gap_rate != 0; }

// What is affine in gap and gap rate is not affine in the motion.
std::vector<Mode> on_curved_gap(std::vector<Mode> modes) {
  for (Mode &mode : modes)
    if (mode.affine &&
        (!mode.affine->force.zero() || std::any_of(mode.affine->internal_rate.begin(),
                                                   mode.affine->internal_rate.end(), sees_gap)))
      mode.affine.reset();
  return modes;
}

// Is the form the gap, times a factor of the sign?
bool is_gap(const AffineForm &form, double sign) {
  AffineForm rest = form;
  rest.gap = 0;
  return form.gap * sign > 0 && rest.zero();
}

} // namespace

CurvedGapLaw::CurvedGapLaw(std::shared_ptr<const ContactLaw> law)
    : ContactLaw(on_curved_gap(law->modes()), law->initial_internal()), law_(std::move(law)) {}

std::optional<ForcePulse> CurvedGapLaw::force_pulse(int mode) const {
  const Mode &of = law_->modes()[static_cast<std::size_t>(mode)];
  if (!of.affine || of.holds() || !is_gap(of.affine->force, -1))
    return law_->force_pulse(mode);
  const ForceEdge touch{.power = 1};
  ForcePulse pulse{.begin = touch};
  for (std::size_t g = 0; g < of.guards.size(); ++g)
    if (is_gap(of.guards[g].indicator, -1))
      pulse.ends.push_back({.guard = g, .edge = touch});
  return pulse;
}

} // namespace vibroimpact::contact
