// Where along a motion a contact is about to close, or has hardly closed.
#pragma once

#include "contact/contact_set.h"
#include "motion/observer.h"

#include <vector>

namespace vibroimpact::periodic {

/// A guard of an open contact comes near to zero, or falls below it for a short time.
struct GuardMinimum {
  std::size_t contact = 0;
  int mode = 0;              ///< of the open contact
  std::size_t guard = 0;     ///< in that mode
  double time = 0;           ///< of the minimum, or the middle of the time in contact [s]
  double begin = 0, end = 0; ///< of the contact [s]; both `time` where there is none
  double value = 0;          ///< least value; where it falls below zero its speed there [m/s]
  bool touched = false;
};

/// Lists the minima of a motion that it observes.
class MinimumObserver : public motion::Observer {
public:
  /// `contacts` with the laws whose guards count; the motion may have some that stay open.
  explicit MinimumObserver(const contact::ContactSet &contacts) : contacts_(contacts) {}

  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  const std::vector<GuardMinimum> &minima() const { return minima_; }

private:
  const contact::ContactSet &contacts_;
  std::vector<GuardMinimum> minima_;
  std::vector<std::size_t> closed_; ///< places in minima_ of the contacts that are closed
};

} // namespace vibroimpact::periodic
