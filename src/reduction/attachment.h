// A place whose static answer is kept beside the modes.
#pragma once

#include <string>

namespace vibroimpact::reduction {

/// A place of the interface: a point, or each point of a named interface, along an axis (0, 1, 2),
/// whose static answer is kept beside the modes.
struct Attachment {
  std::string point; ///< or interface
  int axis = 0;
};

} // namespace vibroimpact::reduction
