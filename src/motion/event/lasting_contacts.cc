#include "motion/event/lasting_contacts.h"

#include "motion/event/leading_acceleration.h"
#include "motion/event/rubbing.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using contact::Friction;

namespace {

std::vector<std::size_t> lasting_contacts(const Equations &equations) {
  std::vector<std::size_t> list;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (equations.mode(c).holds_gap)
      list.push_back(c);
  return list;
}

const contact::Mode &mode_behind(const Equations &equations, std::size_t contact,
                                 const contact::Guard &guard) {
  return equations.contacts().pairs()[contact].law->modes()[static_cast<std::size_t>(guard.target)];
}

// The sign of the slip in a mode, by its force -sigma mu N; 0: it does not slip.
int direction_of_slip(const Equations &equations, std::size_t contact, int mode) {
  const double share = friction_share(equations.contacts().pairs()[contact], mode);
  return share < 0 ? 1 : share > 0 ? -1 : 0;
}

double slip_rate(const Equations &equations, std::size_t contact, double time,
                 const Vector &state) {
  if (equations.contacts().pairs()[contact].tangential.empty())
    return 0;
  return equations.local_state(contact, time, ConstVectorView(state.data(), state.size()))
      .tangential.front()
      .slip_rate;
}

// The direction in which a contact slides for certain where the stick of one has broken: that of
// its guard if its own stick breaks too, within the error of its forces; that in which it slides.
int direction_of_break(const Equations &equations, const ContactScales &scales, std::size_t contact,
                       double time, const Vector &state) {
  const contact::Mode &mode = equations.mode(contact);
  if (mode.friction != Friction::stick)
    return direction_of_slip(equations, contact, equations.modes()[contact]);
  const contact::LocalState local =
      equations.local_state(contact, time, ConstVectorView(state.data(), state.size()));
  for (const contact::Guard &guard : mode.guards)
    if (const int direction = direction_of_slip(equations, contact, guard.target);
        direction != 0 && guard.indicator(local) <= scales.error(contact, guard.indicator))
      return direction;
  return 0;
}

// What the contacts can do, from what they do now. `first` has passed its guard.
std::vector<RestingContact> resting_contacts(const Equations &equations,
                                             const ContactScales &scales,
                                             const std::vector<std::size_t> &contacts,
                                             std::size_t first, const contact::Guard &guard,
                                             double time, const Vector &state) {
  const contact::Mode &behind = mode_behind(equations, first, guard);
  // What the location of a stop has left of its slip rate is left of those of other feet too.
  const double left =
      behind.in_contact ? 2 * std::abs(slip_rate(equations, first, time, state)) : 0;
  const bool breaks =
      behind.friction == Friction::slip && equations.mode(first).friction == Friction::stick;
  std::vector<RestingContact> list;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::size_t c = contacts[k];
    if (c == first && !behind.holds_gap)
      continue;
    const int slides = !breaks      ? 0
                       : c == first ? direction_of_slip(equations, c, guard.target)
                                    : direction_of_break(equations, scales, c, time, state);
    list.push_back(
        {.place = static_cast<Index>(k),
         .mode = equations.contacts().pairs()[c].law->mode_by_slip(equations.modes()[c], {}),
         .slow = std::max(scales.speed(c), left),
         .slides = slides});
  }
  return list;
}

} // namespace

bool lasts_beside_others(const Equations &equations, std::size_t contact) {
  if (!equations.mode(contact).holds_gap)
    return false;
  const std::vector<std::size_t> list = lasting_contacts(equations);
  return list.size() > 1 && Rubbing::holds(equations, list);
}

void pass_together(Equations &equations, const ContactScales &scales, std::size_t contact,
                   const contact::Guard &guard, double time, Vector &state) {
  const std::vector<std::size_t> contacts = lasting_contacts(equations);
  const std::vector<RestingContact> list =
      resting_contacts(equations, scales, contacts, contact, guard, time, state);
  const Rubbing rubbing(equations, contacts, time, state);
  for (const std::size_t c : contacts)
    equations.set_mode(c, equations.mode(c).guards.front().target);
  Vector accelerations = Vector::Zero(2 * static_cast<Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    for (int d = 0; d < (rubbing.has_friction(list[i].place) ? 2 : 1); ++d)
      accelerations[2 * static_cast<Index>(i) + d] = leading_acceleration(
          equations, contacts[static_cast<std::size_t>(list[i].place)], time, state, d);
  const std::vector<int> chosen = rubbing.modes_at_rest(list, accelerations, state);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (chosen[i] >= 0)
      equations.set_mode(contacts[static_cast<std::size_t>(list[i].place)], chosen[i]);
  if (!equations.holding().empty())
    equations.stop_slip(time, state);
}

} // namespace vibroimpact::motion
