// What a long computation whose length nobody knows is at, for the person at the terminal.
#pragma once

#include "common/progress.h"

#include <string>

namespace vibroimpact {

/// One live line on a terminal, which goes when the last stage is over; plain lines elsewhere, for
/// the stages that are expected to take seconds. Meant for rank 0, as Progress.
class Stages {
public:
  Stages(std::string label, bool active);
  Stages(std::string label, Surroundings surroundings);
  Stages(const Stages &) = delete;
  Stages &operator=(const Stages &) = delete;
  ~Stages();

  /// "body plate: normal modes". `takes_seconds`: worth a plain line.
  void begin(const std::string &stage, bool takes_seconds);

private:
  std::string label_;
  Surroundings surroundings_;
  bool active_ = true;
  bool line_open_ = false;
};

} // namespace vibroimpact
