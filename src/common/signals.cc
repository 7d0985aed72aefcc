#include "common/signals.h"

#include <csignal>

namespace vibroimpact {

namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void request_stop(int signal_number) {
  if (requested != 0) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number); // delivered when this handler returns
  }
  requested = 1;
}

} // namespace

void install_signal_handlers() {
  requested = 0;
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART; // a write in progress goes on
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() { return requested != 0; }

} // namespace vibroimpact
