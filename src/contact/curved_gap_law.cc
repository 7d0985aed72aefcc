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

} // namespace

CurvedGapLaw::CurvedGapLaw(std::shared_ptr<const ContactLaw> law)
    : ContactLaw(on_curved_gap(law->modes()), law->initial_internal()), law_(std::move(law)) {}

} // namespace vibroimpact::contact
