// How far a long computation is, for the person at the terminal: one live line on a terminal,
// sparse plain lines in a log.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

namespace vibroimpact {

/// Cases done of a known total, with rate and time left. Meant for rank 0; construct it with
/// `active = false` elsewhere and it stays silent. The destructor ends a live line.
class Progress {
public:
  /// Where and when to print; the default is standard output and the steady clock.
  struct Surroundings {
    std::ostream *stream;
    bool terminal;
    std::function<double()> seconds; ///< a clock that never goes back
  };

  Progress(std::size_t total, std::string label, bool active = true);
  Progress(std::size_t total, std::string label, Surroundings surroundings);
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;
  ~Progress();

  /// `done` cases are finished. Prints at most 5 times a second on a terminal; otherwise at every
  /// tenth part, or when 30 s have passed since the last line.
  void update(std::size_t done);

private:
  bool due(std::size_t done, double now) const;
  std::string line(std::size_t done, double now) const;

  std::size_t total_;
  std::string label_;
  Surroundings surroundings_;
  bool active_ = true;
  bool line_open_ = false;
  bool printed_ = false;
  double start_;
  double last_print_;
  std::size_t last_done_ = 0;
};

} // namespace vibroimpact
