// Smooth phases that are not linear, in few steps: the Runge-Kutta method of order 8 by Dormand and
// Prince, with as much dense output.
//
// The error of a step and that of the polynomial through its ends are both kept below the relative
// tolerance of what the motion has recently been (ErrorMeasure). Where model and sources
// allow, the third derivative of the motion is known at the ends (from the Jacobian of the law),
// and the polynomial has degree 7.
//
// A force like u^(3/2) is not smooth where the penetration u rises from zero and where it returns
// there. As a function of the square root of the time since then, or until then, it is; so a step
// of an only contact goes evenly in that root: since the start of the phase while the two sides
// approach, and until its own end where that is (nearly) the end of the contact.
#pragma once

#include "motion/settings.h"
#include "motion/steps/error_measure.h"
#include "motion/steps/source_step.h"
#include "motion/steps/stepper.h"
#include "motion/steps/time_transformation.h"
#include "motion/system/equations.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

class HighOrderStepper : public Stepper {
public:
  HighOrderStepper(const Equations &equations, const Settings &settings);

  void forget() override;
  void restart(double time, const Vector &x) override;
  void step(double limit) override;
  void shorten(double time) override;
  void undo() override;
  long rejected_steps() const override { return rejected_; }

private:
  /// Lengths that are good enough, as far as is known.
  struct LearnedSteps {
    double first = 0; ///< of a phase
    double last = 0;  ///< up to the end of a contact
  };
  /// What a course is worth: the error over the tolerance.
  double attempt(const TimeTransformation &course);
  void take_stages(const TimeTransformation &course);
  template <std::size_t... stage>
  void take_stages(const TimeTransformation &course, std::index_sequence<stage...>);
  template <std::size_t stage> void take_stage(const TimeTransformation &course);
  template <std::size_t count, typename Factor>
  void add_stages(Factor factor, Index size, double *state) const;
  double step_error();
  double dense_error();
  void complete(EndPoint &point);
  void add_higher(EndPoint &point);
  void read_sources(double time);
  void find_only_contact();
  void find_curved_guards();
  double curved_step() const;
  contact::LocalState contact_at(const EndPoint &point) const;
  bool opening() const;
  double rest_of_contact() const;
  bool take_last(double left, double limit);
  double instant_tolerance() const;
  double wanted_step(double left) const;
  bool move_end(double time);
  void accept(double error);
  static double growth(double error);
  void recall_steps();
  void learn(const LearnedSteps &steps);

  const Equations &equations_;
  double maximum_step_, event_tolerance_;
  ErrorMeasure measure_;
  SourceStep source_step_;
  Vector error_;       ///< of the state at the end of the step
  Vector dense_error_; ///< of the coordinates in its middle
  Matrix stages_;      ///< dx/ds, one column each
  Vector stage_state_;
  contact::LawResponse response_;
  Vector elastic_, damping_;
  std::vector<model::ExponentialForm> sources_; ///< empty: without closed form
  bool has_higher_ = false;
  std::vector<std::size_t> curved_guards_;  ///< contacts with guards along a turning normal
  std::optional<std::size_t> only_contact_; ///< that is not linear; with its root at the start
  bool begins_contact_ = false;             ///< its penetration was zero at the start of the phase
  double phase_start_ = 0;
  TimeTransformation taken_; ///< of the last attempt
  double natural_step_ = 0;
  bool first_of_phase_ = true;
  LearnedSteps steps_;
  std::map<std::vector<int>, LearnedSteps> learned_; ///< from the last phase with these modes
  long rejected_ = 0;
};

} // namespace vibroimpact::motion
