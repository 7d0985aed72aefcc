#include "analyses/recorders/window_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::analyses {

void WindowBlocks::declare(parameters::Section &section, const std::string &errors) {
  section.integer(
      "Blocks", "10", parameters::Range{.lower = 2, .upper = 1e6}, "",
      "Equal parts of the recorded window, of whole forcing periods, whose means give " + errors +
          "; each should be longer than the motion remembers. With fewer periods there "
          "are as many as periods.");
}

void WindowBlocks::begin(const Window &window, long blocks, Vector totals) {
  window_ = window;
  blocks_ = blocks;
  means_.begin(window.start, std::move(totals));
}

bool WindowBlocks::ends_with(const motion::Interval &part) const {
  const double block = window_.length() / static_cast<double>(blocks_);
  const auto number = [&](double time) { return std::floor((time - window_.start) / block); };
  return window_.cycles == 0 && number(part.end()) > number(means_.last_end()) &&
         part.end() < window_.end;
}

bool WindowBlocks::ends_with_period(long cycle) const {
  const long blocks = std::min(blocks_, window_.cycles);
  return cycle < window_.cycles &&
         cycle * blocks / window_.cycles > (cycle - 1) * blocks / window_.cycles;
}

} // namespace vibroimpact::analyses
