// A polite end on Ctrl-C or a scheduler's SIGTERM: finish the case at hand, keep what is done.
#pragma once

namespace vibroimpact {

/// From now on the first SIGINT or SIGTERM only makes stop_requested() true; a second one ends the
/// process at once, as if no handler were there.
void install_signal_handlers();

/// Has a signal asked this process to stop? Long loops look at it between two cases.
bool stop_requested();

} // namespace vibroimpact
