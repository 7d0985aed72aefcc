// What periodic motions take with Boost.odeint: the map of a forced motion over its period by the
// method of odeint_side.h, its derivative by forward differences, and Newton's method with it.
#pragma once

#include "odeint_side.h"

#include "common/error.h"

#include <Eigen/LU>

namespace vibroimpact::benchmarks {

template <class System> class OdeintMap {
public:
  using State = typename System::State;

  /// `system` with all contacts open. `length` [s]; `sign` -1 turns the end of half a period back;
  /// `step` of the differences of each entry.
  OdeintMap(System system, double length, double sign, const Tolerance &tolerance, Vector step)
      : system_(std::move(system)), length_(length), sign_(sign), tolerance_(tolerance),
        step_(std::move(step)) {}

  Vector operator()(const Vector &from) const {
    State start;
    std::copy(from.begin(), from.end(), start.begin());
    System system = system_;
    for (std::size_t i = 0; i < System::contacts; ++i)
      if (system.guard(i, start) < 0)
        system.pass(i, start);
    constexpr double event_tolerance = 1e-12; // [s]
    OdeintMotion<System> motion(system, start, length_, event_tolerance, tolerance_, false);
    motion();
    const State &end = motion.end_state();
    return sign_ * ConstVectorView(end.data(), static_cast<Index>(end.size()));
  }

  Matrix derivative(const Vector &from, const Vector &image) const {
    Matrix by_state(from.size(), from.size());
    for (Index j = 0; j < from.size(); ++j) {
      Vector beside = from;
      beside[j] += step_[j];
      by_state.col(j) = ((*this)(beside)-image) / step_[j];
    }
    return by_state;
  }

private:
  System system_;
  double length_;
  double sign_;
  Tolerance tolerance_;
  Vector step_;
};

struct OdeintOrbit {
  Vector state;
  Matrix by_state; ///< of the map
};

/// Newton's method until a step is below `exact` of the state. NumericalError.
template <class Map> OdeintOrbit odeint_orbit(const Map &map, Vector state, double exact) {
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Vector image = map(state);
    const Matrix by_state = map.derivative(state, image);
    const Matrix matrix = Matrix::Identity(state.size(), state.size()) - by_state;
    const Vector step = matrix.partialPivLu().solve(image - state);
    state += step;
    if (step.cwiseAbs().maxCoeff() <= exact * state.cwiseAbs().maxCoeff())
      return {.state = state, .by_state = by_state};
  }
  throw NumericalError("Newton's method with odeint has not come to an end");
}

} // namespace vibroimpact::benchmarks
