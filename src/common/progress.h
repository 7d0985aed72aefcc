// How far a long computation is, for the person at the terminal: one live line on a terminal,
// sparse plain lines in a log.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

namespace vibroimpact {

/// Where and when to print.
struct Surroundings {
  std::ostream *stream;
  bool terminal;
  std::function<double()> seconds; ///< a clock that never goes back
};

/// Standard output and the steady clock.
Surroundings usual_surroundings();

/// Cases done of a known total, with rate and time left. Meant for rank 0; construct it with
/// `active = false` elsewhere and it stays inactive. The destructor ends a live line.
class Progress {
public:
  Progress(std::size_t total, std::string label, bool active = true);
  Progress(std::size_t total, std::string label, Surroundings surroundings);
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;
  ~Progress();

  /// `done` cases are finished, and the `share` (0 to 1) of another one. Prints at most 5 times a
  /// second on a terminal; otherwise when a tenth part more of the cases is finished, or when 30 s
  /// have passed since the last line.
  void update(std::size_t done, double share = 0);

private:
  bool due(std::size_t done, double now) const;
  std::string line(std::size_t done, double share, double now) const;

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
