// A step of many contacts as others see a motion: smooth parts between contact changes.
//
// Each part is shown as steps whose ends have the true accelerations and whose Hermite polynomials
// meet the motion in the middle to the tolerance, in the energy norm; others are halved.
#pragma once

#include "motion/interval/step_view.h"
#include "motion/moments/moment_step.h"

#include <functional>

namespace vibroimpact::motion {

class MomentViews {
public:
  /// Keeps references. tolerance: relative.
  MomentViews(Equations &equations, const MomentStep &step, double tolerance);

  /// The step is another one.
  void begin() { acting_ = step_.acting(); }
  /// What is known at the part x of the step, which begins at `time`, in the present modes of the
  /// equations. The integrals in the state stay.
  void fill(double time, double x, EndPoint &point) const;

  /// From just before the change of a contact to just behind it, where the equations are.
  void pass(std::size_t contact, int from, double x, EndPoint &point) const;

  struct Motion {
    Vector position, velocity;
  };
  /// By the quintic of each coordinate, at tau in [0, 1]: what a step view sees.
  static Motion between(const EndPoint &start, const EndPoint &end, double tau);

  using Show = std::function<void(const EndPoint &start, const EndPoint &end)>;
  /// From start to end, at the parts `from` and `to` of the step.
  void show(double time, double from, const EndPoint &start, double to, const EndPoint &end,
            const Show &show) const;

private:
  double force(std::size_t contact, int mode, double x) const;
  void halve(double time, double from, const EndPoint &start, double to, const EndPoint &end,
             int depth, const Show &show) const;
  double missed(const EndPoint &start, const EndPoint &middle, const EndPoint &end) const;

  Equations &equations_;
  const MomentStep &step_;
  double tolerance_;
  std::vector<std::size_t> acting_;
  mutable contact::LawResponse response_;
};

} // namespace vibroimpact::motion
