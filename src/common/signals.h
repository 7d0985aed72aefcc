// What SIGINT (Ctrl-C) and SIGTERM (a scheduler) do: end the process at once where nothing can be
// lost, and let results be completed where there are some.
#pragma once

namespace vibroimpact {

/// Exit code of a process that a signal has stopped.
constexpr int stopped_exit_code = 4;

/// Thrown where a computation is left unfinished because stop_requested().
struct Interrupted {};

/// From now on SIGINT and SIGTERM end the process at once with exit code 4 and, where `speaks`, one
/// line on standard error.
void install_signal_handlers(bool speaks = true);

/// While one exists, the first signal only makes stop_requested() true, and whoever computes ends
/// soon in good order; a second one ends the process at once, as if no handler were there.
class DeferSignals {
public:
  DeferSignals();
  ~DeferSignals();
  DeferSignals(const DeferSignals &) = delete;
  DeferSignals &operator=(const DeferSignals &) = delete;
};

/// Is the present computation to end, because of a signal or of a WorkLimit (work_limit.h)? Costs
/// nothing: every loop whose length the input decides looks at it.
bool stop_requested();
/// Throws Interrupted when stop_requested().
void leave_if_stopped();

namespace signals {
/// For WorkLimit: makes stop_requested() true or, when no signal has come either, false.
void set_limit_reached(bool reached);
bool limit_reached();
} // namespace signals

} // namespace vibroimpact
