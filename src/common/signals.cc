#include "common/signals.h"

#include <csignal>
#include <cstring>
#include <unistd.h>

namespace vibroimpact {

namespace {

volatile std::sig_atomic_t requested = 0;
volatile std::sig_atomic_t limit = 0;
volatile std::sig_atomic_t deferring = 0;
volatile std::sig_atomic_t speaking = 1;

void end_process() {
  constexpr const char *line = "vibroimpact: stopped by a signal; no results were at hand.\n";
  if (speaking != 0)
    (void)!write(STDERR_FILENO, line, std::strlen(line));
  _exit(stopped_exit_code);
}

extern "C" void request_stop(int signal_number) {
  if (deferring == 0)
    end_process();
  if (requested != 0) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number); // delivered when this handler returns
  }
  requested = 1;
}

} // namespace

void install_signal_handlers(bool speaks) {
  requested = 0;
  speaking = speaks ? 1 : 0;
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART; // a write in progress goes on
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

DeferSignals::DeferSignals() { deferring = deferring + 1; }

DeferSignals::~DeferSignals() { deferring = deferring - 1; }

bool stop_requested() { return requested != 0 || limit != 0; }

void leave_if_stopped() {
  if (stop_requested())
    throw Interrupted{};
}

void signals::set_limit_reached(bool reached) { limit = reached ? 1 : 0; }

bool signals::limit_reached() { return limit != 0; }

} // namespace vibroimpact
