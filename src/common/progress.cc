#include "common/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace vibroimpact {

namespace {

constexpr double seconds_between_live_updates = 0.2;
constexpr double seconds_between_plain_lines = 30;

double steady_seconds() {
  using seconds = std::chrono::duration<double>;
  return seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string formatted(const char *format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string duration(double seconds) {
  if (seconds < 60)
    return formatted("%.0f s", seconds);
  if (seconds < 3600)
    return formatted("%.0f min ", std::floor(seconds / 60)) +
           formatted("%.0f s", std::fmod(seconds, 60));
  return formatted("%.0f h ", std::floor(seconds / 3600)) +
         formatted("%.0f min", std::fmod(seconds, 3600) / 60);
}

std::string rate(double cases_per_second) {
  if (cases_per_second >= 1)
    return formatted("%.3g/s", cases_per_second);
  return formatted("%.3g s each", 1 / cases_per_second);
}

// Under mpirun every process has a pseudo-terminal; what counts is where mpirun itself, the parent,
// writes to.
bool on_terminal() {
  if (isatty(STDOUT_FILENO) != 1)
    return false;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    return true;
  const std::string parent = "/proc/" + std::to_string(getppid()) + "/fd/1";
  const int descriptor = open(parent.c_str(), O_WRONLY | O_NOCTTY);
  const bool terminal = descriptor >= 0 && isatty(descriptor) == 1;
  if (descriptor >= 0)
    close(descriptor);
  return terminal;
}

} // namespace

Surroundings usual_surroundings() { return {&std::cout, on_terminal(), steady_seconds}; }

Progress::Progress(std::size_t total, std::string label, bool active)
    : Progress(total, std::move(label), usual_surroundings()) {
  active_ = active;
}

Progress::Progress(std::size_t total, std::string label, Surroundings surroundings)
    : total_(total), label_(std::move(label)), surroundings_(std::move(surroundings)),
      start_(surroundings_.seconds()), last_print_(start_) {}

Progress::~Progress() {
  if (line_open_)
    *surroundings_.stream << std::endl;
}

bool Progress::due(std::size_t done, double now) const {
  if (last_done_ == total_)
    return false;
  if (done == total_)
    return true;
  if (surroundings_.terminal)
    return !printed_ || now - last_print_ >= seconds_between_live_updates;
  return 10 * done / total_ > 10 * last_done_ / total_ ||
         now - last_print_ >= seconds_between_plain_lines;
}

std::string Progress::line(std::size_t done, double share, double now) const {
  const double cases = std::min(static_cast<double>(done) + share, static_cast<double>(total_));
  std::string text = label_ + ": " + std::to_string(done) + " of " + std::to_string(total_) + " (" +
                     formatted("%.0f", 100.0 * cases / static_cast<double>(total_)) + " %)";
  const double elapsed = now - start_;
  if (!(cases > 0) || elapsed <= 0)
    return text;
  const double cases_per_second = cases / elapsed;
  text += ", " + rate(cases_per_second);
  if (done < total_)
    return text + ", " + duration((static_cast<double>(total_) - cases) / cases_per_second) +
           " left";
  return text + ", took " + duration(elapsed);
}

void Progress::update(std::size_t done, double share) {
  if (!active_ || total_ == 0)
    return;
  const double now = surroundings_.seconds();
  if (!due(done, now))
    return;
  std::ostream &stream = *surroundings_.stream;
  if (surroundings_.terminal)
    stream << "\r\033[K" << line(done, share, now)
           << std::flush; // back to column 0, clear the line
  else
    stream << line(done, share, now) << std::endl;
  line_open_ = surroundings_.terminal && done < total_;
  if (surroundings_.terminal && done == total_)
    stream << std::endl;
  printed_ = true;
  last_print_ = now;
  last_done_ = done;
}

} // namespace vibroimpact
