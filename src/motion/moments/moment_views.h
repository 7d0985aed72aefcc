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
  void begin();
  /// What is known at the part x of the step, which begins at `time`, behind the changes passed so
  /// far. The integrals in the state stay.
  void fill(double time, double x, EndPoint &point) const;

  /// From just before the next change of a contact to just behind it.
  void pass(std::size_t contact, double x, EndPoint &point);

  struct Motion {
    Vector position, velocity;
  };
  /// By the quintic of each coordinate, at tau in [0, 1]: what a step view sees.
  Motion between(const EndPoint &start, const EndPoint &end, double tau) const;

  using Show = std::function<void(const EndPoint &start, const EndPoint &end)>;
  /// From start to end, at the parts `from` and `to` of the step.
  void show(double time, double from, const EndPoint &start, double to, const EndPoint &end,
            const Show &show) const;

private:
  void add(std::size_t contact, std::size_t stretch, double x, double factor, Vector &rates) const;
  void halve(double time, double from, const EndPoint &start, double to, const EndPoint &end,
             int depth, const Show &show) const;
  double missed(const EndPoint &start, const EndPoint &middle, const EndPoint &end) const;

  Equations &equations_;
  const MomentStep &step_;
  double tolerance_;
  std::vector<std::size_t> acting_;
  std::vector<std::size_t> stretches_; ///< of each contact, the present one
  mutable contact::LawResponse response_;
};

} // namespace vibroimpact::motion
