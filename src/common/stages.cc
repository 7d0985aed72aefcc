#include "common/stages.h"

#include <ostream>
#include <utility>

namespace vibroimpact {

Stages::Stages(std::string label, bool active) : Stages(std::move(label), usual_surroundings()) {
  active_ = active;
}

Stages::Stages(std::string label, Surroundings surroundings)
    : label_(std::move(label)), surroundings_(std::move(surroundings)) {}

Stages::~Stages() {
  if (line_open_)
    *surroundings_.stream << "\r\033[K" << std::flush;
}

void Stages::begin(const std::string &stage, bool takes_seconds) {
  if (!active_)
    return;
  if (surroundings_.terminal)
    *surroundings_.stream << "\r\033[K" << label_ << ": " << stage << std::flush;
  else if (takes_seconds)
    *surroundings_.stream << label_ << ": " << stage << std::endl;
  line_open_ = surroundings_.terminal;
}

} // namespace vibroimpact
