// Writing .prm text.
#pragma once

#include "parameters/tree.h"

namespace vibroimpact::parameters {

/// The whole tree; what was not given carries the comment "# default".
std::string echo_text(const Node &root);

/// "  set Key   = value" with the '=' in column `width` of the name, continued by '\' where it is
/// long; `comment` goes behind it.
std::string assignment(int depth, const std::string &key, std::size_t width,
                       const std::string &value, const std::string &comment);

/// Width of the longest name of a key.
std::size_t name_width(const Section &section);

} // namespace vibroimpact::parameters
