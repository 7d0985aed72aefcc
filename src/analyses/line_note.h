// What a line of work leaves for the lines after it, on whichever rank these run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct LineNote {
  std::vector<double> values{};
  std::string text{};
};

/// Room for a note: so many numbers, and a text that is cut to so many bytes.
struct NoteSize {
  std::size_t values = 0;
  std::size_t bytes = 0;
};

} // namespace vibroimpact::analyses
