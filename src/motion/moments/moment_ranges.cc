#include "motion/moments/moment_ranges.h"

#include "motion/interval/peak_force.h"

#include <algorithm>

namespace vibroimpact::motion {

MomentRanges::MomentRanges(const Equations &equations, const MomentStep &step)
    : equations_(equations), step_(step), of_contacts_(equations.contacts().size()) {
  const auto &pairs = equations.contacts().pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c)
    contact_of_internal_.insert(contact_of_internal_.end(),
                                static_cast<std::size_t>(pairs[c].n_internal()), c);
}

std::optional<std::size_t> MomentRanges::contact_of(const OutputForm &form) const {
  if (const auto *gap = std::get_if<GapForm>(&form))
    return gap->contact;
  if (const auto *force = std::get_if<ForceForm>(&form))
    return force->contact;
  if (const auto *slip = std::get_if<SlipForm>(&form))
    return slip->contact;
  if (const auto *friction = std::get_if<FrictionForm>(&form))
    return friction->contact;
  if (const auto *state = std::get_if<StateForm>(&form))
    return contact_of_internal_[static_cast<std::size_t>(state->place)];
  return {};
}

// Accelerations jump where contacts change.
bool MomentRanges::known(const OutputForm &form) const {
  if (const auto *point = std::get_if<PointForm>(&form))
    return point->order < 2;
  if (const auto *friction = std::get_if<FrictionForm>(&form))
    return std::ranges::all_of(equations_.contacts().pairs()[friction->contact].law->modes(),
                               [](const contact::Mode &mode) { return mode.affine.has_value(); });
  return !std::holds_alternative<CurveForm>(form);
}

bool MomentRanges::ask(const std::vector<Observer *> &observers) {
  const auto needs_steps = [&](const Observer *observer) {
    return observer->sees_steps(equations_) || observer->follows_phases();
  };
  if (std::ranges::any_of(observers, needs_steps))
    return false;
  audience_.list = observers;
  audience_.ask(equations_);
  for (const std::size_t c : asked_)
    of_contacts_[c].clear();
  asked_.clear();
  others_.clear();
  for (const Output &output : audience_.outputs) {
    if (!known(*output.form))
      return false;
    const std::optional<std::size_t> contact = contact_of(*output.form);
    if (contact && of_contacts_[*contact].empty())
      asked_.push_back(*contact);
    (contact ? of_contacts_[*contact] : others_).push_back(output);
  }
  return true;
}

Bernstein MomentRanges::curve(const OutputForm &form, std::size_t contact,
                              const CourseStretch &stretch) const {
  const ContactCourse &course = step_.course(contact);
  if (const auto *slip = std::get_if<SlipForm>(&form)) {
    const DirectionCurve &along = course.curve(static_cast<std::size_t>(slip->direction));
    return slip->rate ? along.rate : along.position;
  }
  const auto &pair = equations_.contacts().pairs()[contact];
  if (const auto *state = std::get_if<StateForm>(&form)) {
    Bernstein value =
        stretch.internal[static_cast<std::size_t>(state->place - pair.internal_offset)];
    value += state->constant;
    return value;
  }
  if (const auto *friction = std::get_if<FrictionForm>(&form)) {
    const contact::Mode &mode = pair.law->modes()[static_cast<std::size_t>(stretch.mode)];
    return course.form(
        mode.affine->tangential_force[static_cast<std::size_t>(friction->direction - 1)], stretch);
  }
  return course.gap();
}

void MomentRanges::include_force(const Output &output, std::size_t contact,
                                 const CourseStretch &stretch) {
  const ContactCourse &course = step_.course(contact);
  const contact::ContactLaw &law = *equations_.contacts().pairs()[contact].law;
  const contact::Mode &mode = law.modes()[static_cast<std::size_t>(stretch.mode)];
  if (mode.affine) {
    const Bernstein force = course.form(mode.affine->force, stretch);
    output.range->include(force.between(stretch.from, stretch.to).maximum());
    return;
  }
  const double length = stretch.to - stretch.from;
  const PeakForce peak = sampled_peak([&](double tau) {
    law.evaluate(stretch.mode, course.at(stretch, stretch.from + tau * length), response_);
    return response_.force;
  });
  if (peak.force <= output.range->maximum)
    return;
  const double x = stretch.from + peak.tau * length;
  if (x == 0 || x == 1) { // there the polynomials are the motion
    output.range->include(peak.force);
    return;
  }
  // Within the step they say where it is, the motion itself how large.
  contact::LocalState local = step_.contact_rows().local(contact, step_.rows_at(x));
  local.internal = course.at(stretch, x).internal;
  law.evaluate(stretch.mode, local, response_);
  output.range->include(response_.force);
}

void MomentRanges::include(const Output &output, std::size_t contact,
                           const CourseStretch &stretch) {
  if (std::holds_alternative<ForceForm>(*output.form))
    include_force(output, contact, stretch);
  else
    output.range->include(curve(*output.form, contact, stretch).between(stretch.from, stretch.to));
}

void MomentRanges::include(std::size_t contact, const CourseStretch &stretch) {
  for (const Output &output : of_contacts_[contact])
    include(output, contact, stretch);
}

// Of a contact that the step has left out: without force, its internal states at rest.
void MomentRanges::include_open(std::size_t contact) const {
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  for (const Output &output : of_contacts_[contact]) {
    const auto *slip = std::get_if<SlipForm>(output.form);
    if (slip || std::holds_alternative<GapForm>(*output.form)) {
      const contact::Direction along = pair.along(slip ? slip->direction : 0);
      const DirectionCurve seen = step_.curve_of(*along.projection);
      Bernstein value = slip && slip->rate ? seen.rate : seen.position;
      value += slip && slip->rate ? along.speed : along.offset;
      output.range->include(value);
    } else if (const auto *state = std::get_if<StateForm>(output.form)) {
      output.range->include(step_.internal()[state->place] + state->constant);
    } else {
      output.range->include(0.0);
    }
  }
}

void MomentRanges::include_ends() {
  const std::vector<std::size_t> &listed = step_.listed();
  for (const std::size_t c : asked_)
    if (std::ranges::binary_search(listed, c))
      include(c, step_.course(c).stretches().back());
    else
      include_open(c);
  for (const Output &output : others_) {
    const auto &point = std::get<PointForm>(*output.form);
    const DirectionCurve seen = step_.curve_of(point.projection);
    output.range->include(point.order == 0 ? seen.position : seen.rate);
  }
}

} // namespace vibroimpact::motion
