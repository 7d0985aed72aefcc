// A bound on processor time for work whose length nobody knows beforehand.
#pragma once

#include <string>

namespace vibroimpact {

/// Processor time of this process so far [s].
double processor_seconds();

/// While it lives, stop_requested() becomes true once the process has computed for `seconds` more.
/// One WorkLimit or EndAtLimit at a time.
class WorkLimit {
public:
  explicit WorkLimit(double seconds);
  ~WorkLimit();
  WorkLimit(const WorkLimit &) = delete;
  WorkLimit &operator=(const WorkLimit &) = delete;

  bool reached() const;
};

/// For work inside libraries that cannot be asked to stop: when the process computes for `seconds`
/// more while it lives, the process ends with exit code 0 and, where `speaks`, the message on
/// standard output.
class EndAtLimit {
public:
  EndAtLimit(double seconds, const std::string &message, bool speaks);
  ~EndAtLimit();
  EndAtLimit(const EndAtLimit &) = delete;
  EndAtLimit &operator=(const EndAtLimit &) = delete;
};

} // namespace vibroimpact
