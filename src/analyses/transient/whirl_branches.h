// Modes of a system that turns, followed over its speed: from one speed to the next each goes on as
// the one whose shape resembles its own most. Where none resembles it, steps in between are taken.
#pragma once

#include "model/whirl.h"

#include <functional>
#include <vector>

namespace vibroimpact::analyses {

/// A vibration exp(lambda t).
struct WhirlState {
  std::complex<double> eigenvalue; ///< [1/s], imaginary part > 0
  ComplexVector shape;             ///< of the coordinates, of modal mass 1 kg
};

/// One for each mode; none from where it no longer vibrates.
using WhirlStates = std::vector<std::optional<WhirlState>>;

/// A speed at which something is true of a mode.
struct WhirlSpeed {
  double speed = 0; ///< [rad/s]
  std::size_t mode = 0;
  WhirlState state;
};

class WhirlBranches {
public:
  /// The lowest `modes` vibrations at the first of the speeds [rad/s], two or more that rise,
  /// followed through all; with all of the last frequency. By their frequencies at the second
  /// speed. NumericalError where eigenvalues do not converge.
  WhirlBranches(const model::WhirlingSystem &system, std::vector<double> speeds, std::size_t modes);

  const std::vector<double> &speeds() const { return speeds_; }
  std::size_t modes() const { return states_.front().size(); }
  const std::optional<WhirlState> &state(std::size_t speed, std::size_t mode) const {
    return states_[speed][mode];
  }
  /// Where frequencies cross `multiple` |speed|, by mode and then speed.
  std::vector<WhirlSpeed> critical(double multiple) const;
  /// Where decay becomes growth or growth decay, likewise. Rates within rounding of zero are
  /// neither.
  std::vector<WhirlSpeed> thresholds() const;

private:
  void sort_modes();
  std::vector<WhirlState> vibrations(double speed) const;
  double resemblance(const WhirlState &a, const WhirlState &b) const;
  WhirlStates follow(double from, const WhirlStates &states, double to, int divisions) const;
  std::pair<WhirlStates, double> matched(const WhirlStates &states, double speed) const;
  using Measure = std::function<double(double speed, const WhirlState &state)>;
  std::vector<WhirlSpeed> zeros(const Measure &measure) const;
  WhirlState between(double speed, const WhirlState &a, const WhirlState &b) const;

  const model::WhirlingSystem &system_;
  std::vector<double> speeds_;
  std::vector<WhirlStates> states_; ///< of each speed
};

} // namespace vibroimpact::analyses
