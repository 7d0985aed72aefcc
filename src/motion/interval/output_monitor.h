// What is observed of a motion that flies through its linear phases in closed form, instead of
// being seen step by step: the extreme values of linear forms of the motion.
#pragma once

#include "motion/interval/guard_forms.h"
#include "motion/interval/value_range.h"

#include <optional>
#include <vector>

namespace vibroimpact::motion {

/// A linear form of the motion, or its time derivative, or the normal force of a contact whose law
/// is not affine, whose extreme values are wanted.
struct MonitoredForm {
  LinearRow row{};
  bool differentiated = false;
  std::optional<std::size_t> contact{}; ///< its normal force, in place of the row
  ValueRange *range = nullptr;          ///< lives as long as the monitor
};

/// Displacement and velocity seen by a projection, and the time derivative of the latter.
MonitoredForm monitored_displacement(const Equations &equations,
                                     const model::Projection &projection, ValueRange &range);
MonitoredForm monitored_velocity(const Equations &equations, const model::Projection &projection,
                                 ValueRange &range);
MonitoredForm monitored_acceleration(const Equations &equations,
                                     const model::Projection &projection, ValueRange &range);
/// An affine form of the local state of a contact.
MonitoredForm monitored_contact(const Equations &equations, std::size_t contact,
                                const contact::AffineForm &form, ValueRange &range);
/// The normal force of a contact that touches.
MonitoredForm monitored_force(const Equations &equations, std::size_t contact, ValueRange &range);
/// An entry of the physical state plus a constant.
MonitoredForm monitored_state(const Equations &equations, Index entry, double constant,
                              ValueRange &range);

/// The forms of a phase together: rows and constants one below the other.
struct MonitoredForms {
  explicit MonitoredForms(const std::vector<MonitoredForm> &forms);

  struct Force {
    std::size_t contact = 0;
    ValueRange *range = nullptr;
  };

  Matrix rows; ///< forms x (physical size + 3 sources)
  std::vector<double> constants;
  std::vector<bool> differentiated;
  std::vector<ValueRange *> ranges;
  std::vector<Force> forces; ///< of laws that are not affine
};

class OutputMonitor {
public:
  OutputMonitor();
  virtual ~OutputMonitor() = default;
  OutputMonitor(const OutputMonitor &) = delete;
  OutputMonitor &operator=(const OutputMonitor &) = delete;

  /// Adds the forms that are to be observed in the present modes of the equations.
  virtual void add_forms(const Equations &equations, std::vector<MonitoredForm> &forms) = 0;
  /// A part of the motion in the present modes begins, at a state with its work integrals.
  virtual void part_begins(const Equations & /*equations*/, double /*start*/,
                           const Vector & /*state*/) {}
  /// A part of the motion in the present modes is over, at a state with its work integrals; the
  /// ranges have grown by it.
  virtual void part_done(const Equations & /*equations*/, double /*start*/, double /*end*/,
                         const Vector & /*state*/) {}
  /// A nonlinear contact that is solved as a whole is one part too. False: it must be seen in
  /// steps.
  virtual bool takes_contacts() const { return true; }

  /// No two monitors have the same, so that forms need not be asked for again.
  long identity() const { return identity_; }

private:
  long identity_;
};

} // namespace vibroimpact::motion
