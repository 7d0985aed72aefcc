#include "common/work_limit.h"

#include "common/signals.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <sys/time.h>
#include <unistd.h>

namespace vibroimpact {

namespace {

std::string last_words; // not touched while a timer runs

extern "C" void note_limit(int /*signal_number*/) { signals::set_limit_reached(true); }

extern "C" void end_at_limit(int /*signal_number*/) {
  (void)!write(STDOUT_FILENO, last_words.data(), last_words.size());
  _exit(0);
}

void set_timer(double seconds) {
  const double whole = std::floor(seconds);
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void start_timer(double seconds, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGPROF, &action, nullptr);
  set_timer(std::max(seconds, 1e-3)); // zero would disarm it
}

// A signal that is on its way already must not end the process.
void stop_timer() {
  set_timer(0);
  std::signal(SIGPROF, SIG_IGN);
}

} // namespace

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

WorkLimit::WorkLimit(double seconds) {
  signals::set_limit_reached(false);
  start_timer(seconds, note_limit);
}

WorkLimit::~WorkLimit() {
  stop_timer();
  signals::set_limit_reached(false);
}

bool WorkLimit::reached() const { return signals::limit_reached(); }

EndAtLimit::EndAtLimit(double seconds, const std::string &message, bool speaks) {
  last_words = speaks ? message + "\n" : "";
  start_timer(seconds, end_at_limit);
}

EndAtLimit::~EndAtLimit() { stop_timer(); }

} // namespace vibroimpact
