// What is watched of a motion that flies through its linear phases in closed form, instead of being
// seen step by step: the extreme values of linear forms of the motion.
#pragma once

#include "integration/extent.h"
#include "integration/guard_forms.h"

#include <vector>

namespace vibroimpact::integration {

/// A linear form of the motion, or its time derivative, whose extreme values are wanted.
struct WatchedForm {
  LinearRow row;
  bool differentiated = false;
  Extent *extent = nullptr; ///< lives as long as the watcher
};

/// Displacement and velocity seen by a projection, and the time derivative of the latter.
WatchedForm watched_displacement(const Equations &equations, const model::Projection &projection,
                                 Extent &extent);
WatchedForm watched_velocity(const Equations &equations, const model::Projection &projection,
                             Extent &extent);
WatchedForm watched_acceleration(const Equations &equations, const model::Projection &projection,
                                 Extent &extent);
/// An affine form of the local state of a contact.
WatchedForm watched_contact(const Equations &equations, std::size_t contact,
                            const contact::AffineForm &form, Extent &extent);
/// An entry of the physical state plus a constant.
WatchedForm watched_state(const Equations &equations, Index entry, double constant, Extent &extent);

/// The forms of a phase together: rows and constants one below the other.
struct WatchedForms {
  explicit WatchedForms(const std::vector<WatchedForm> &forms);

  Matrix rows; ///< forms x (physical size + 3 sources)
  std::vector<double> constants;
  std::vector<bool> differentiated;
  std::vector<Extent *> extents;
};

class FlightWatcher {
public:
  FlightWatcher();
  virtual ~FlightWatcher() = default;
  FlightWatcher(const FlightWatcher &) = delete;
  FlightWatcher &operator=(const FlightWatcher &) = delete;

  /// Adds the forms that are to be watched in the present modes of the equations.
  virtual void watch(const Equations &equations, std::vector<WatchedForm> &forms) = 0;
  /// A part of the motion in the present modes is over; the extents have grown by it.
  virtual void flown(const Equations & /*equations*/, double /*start*/, double /*end*/) {}

  /// No two watchers have the same, so that forms need not be asked for again.
  long identity() const { return identity_; }

private:
  long identity_;
};

} // namespace vibroimpact::integration
