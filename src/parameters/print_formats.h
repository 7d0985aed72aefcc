// The reference of all keys in its three formats.
#pragma once

#include "parameters/section.h"

namespace vibroimpact::parameters {

/// A heading and a table for each section.
std::string print_markdown(const Section &declarations);

/// All defaults with comments; named subsections are called NAME.
std::string print_prm(const Section &declarations);

/// Nested objects with everything a key was declared with.
std::string print_json(const Section &declarations);

/// "m", "true or false", "name": the unit of a number, else what the value is.
std::string unit_or_kind(const Key &key);

/// "greater than 0; 3 values": everything that limits a value; may be empty.
std::string limits(const Key &key);

} // namespace vibroimpact::parameters
