// What is observed of a motion: quantities along a step, and the same in closed form where the
// motion is known so.
#pragma once

#include "motion/interval/guard_forms.h"
#include "motion/interval/step_view.h"
#include "motion/interval/value_range.h"

#include <functional>
#include <variant>
#include <vector>

namespace vibroimpact::motion {

/// A displacement, or its first or second derivative by time.
struct PointForm {
  model::Projection projection;
  int order = 0;
};
struct GapForm {
  std::size_t contact = 0;
};
/// An internal state of a law plus a constant.
struct StateForm {
  Index place = 0;
  double constant = 0;
};
/// The normal force of a contact that touches, which is no polynomial along a step.
struct ForceForm {
  std::size_t contact = 0;
};
/// Slip of a contact along a tangential direction, or its rate.
struct SlipForm {
  std::size_t contact = 0;
  int direction = 1;
  bool rate = false;
};
/// The tangential force of a contact, by the law or where sides stick the force that holds them.
struct FrictionForm {
  std::size_t contact = 0;
  int direction = 1;
};
/// What is not linear in the motion.
using CurveForm = std::function<Bernstein(const StepView &view)>;
using OutputForm =
    std::variant<PointForm, GapForm, StateForm, ForceForm, SlipForm, FrictionForm, CurveForm>;

/// A range that grows by all values along the motion. Keeps pointers to both.
struct Output {
  const OutputForm *form = nullptr;
  ValueRange *range = nullptr;

  /// By a step.
  void include(const StepView &view) const;
};

/// Along a step. std::logic_error for forces.
Bernstein curve(const OutputForm &form, const StepView &view);

/// A linear form of the motion, or its time derivative.
struct LinearForm {
  LinearRow row{};
  bool differentiated = false;
};

/// In the present modes of the equations. std::logic_error for what is not linear in the motion,
/// and for the force of a law that is not affine.
LinearForm linear_form(const OutputForm &form, const Equations &equations);

/// No curve is; of circular gaps neither gap nor slip nor friction; friction of other gaps is where
/// the law is affine or something holds.
bool is_linear(const OutputForm &form, const Equations &equations);

/// The outputs of a phase together: rows and constants one below the other.
struct LinearOutputs {
  LinearOutputs() = default;
  /// In the present modes of the equations.
  LinearOutputs(const std::vector<Output> &outputs, const Equations &equations);
  void add(const LinearForm &form, ValueRange &range);

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

} // namespace vibroimpact::motion
