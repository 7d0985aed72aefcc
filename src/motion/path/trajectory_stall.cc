// What a trajectory says where it cannot go on.
#include "motion/path/trajectory.h"

#include <algorithm>
#include <sstream>

namespace vibroimpact::motion {

void Trajectory::note_change(std::size_t contact, bool at_once) {
  if (!at_once)
    last_.changed.clear();
  if (std::find(last_.changed.begin(), last_.changed.end(), contact) == last_.changed.end())
    last_.changed.push_back(contact);
}

// The contacts that changed last, what they are doing, and what can be tried.
std::string Trajectory::stall_reason(const std::string &what) const {
  std::ostringstream text;
  text.precision(10);
  text << what << " at t = " << time() << " s";
  const char *separator = ": contact ";
  bool rigid = false;
  for (const std::size_t c : last_.changed) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const contact::LocalState local =
        equations_.local_state(c, time(), ConstVectorView(state().data(), state().size()));
    text.precision(3);
    text << separator << pair.name << " (" << pair.law->name() << ", " << equations_.mode(c).name
         << ", gap " << local.gap << " m, gap rate " << local.gap_rate << " m/s)";
    separator = ", contact ";
    rigid = rigid || pair.law->rigid();
  }
  text << ". No combination of their modes lasts there. Try ";
  if (rigid)
    text << "a law with a finite stiffness instead of rigid sides that may jam, ";
  text << "clearances that are not exactly equal, or another Method.";
  return text.str();
}

} // namespace vibroimpact::motion
