// What an evaluation leaves for the lines after its own.
#pragma once

#include "analyses/design/objective.h"
#include "analyses/line_note.h"

namespace vibroimpact::analyses {

/// Largest lengths of texts in a note; longer ones are cut off.
inline constexpr std::size_t bytes_of_a_unit = 32;
inline constexpr std::size_t bytes_of_a_failure = 256;

NoteSize size_of_design_note(const Objective &objective);
LineNote design_note(const DesignValue &value, const Objective &objective);
/// Of an empty note: a value that failed.
DesignValue noted_design_value(const LineNote &note, const Objective &objective);

} // namespace vibroimpact::analyses
