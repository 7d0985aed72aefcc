// "set Like = NAME": a section says what another of its kind says, but for what it says itself.
#pragma once

#include "parameters/scanned_file.h"
#include "parameters/section.h"

namespace vibroimpact::parameters {

/// Puts into each section "KIND NAME" with a key Like the entries of the section of that kind and
/// name beside it, which may have one itself. An entry that both have is that of the section; of
/// subsections that both have the same holds within. Entries keep the place they were written at.
/// Throws InputError for a section that is not there or is, by way of others, like itself.
void take_over_entries(ScannedEntry &file, const Section &declarations);

} // namespace vibroimpact::parameters
