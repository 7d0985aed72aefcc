// Which stable periodic motion a start leads to.
//
// The state is looked at once per period. It is decided as soon as it lies in the trapping ball of
// a motion that is known. Motions not yet known are noticed by recurrence: the state is compared
// with that of the last power of two of periods (Brent's rule, no memory needed); when it returns
// to within 1e-4, Newton's method finds the motion, and its multipliers say whether it attracts.
#pragma once

#include "periodic/trapping_ball.h"

#include <complex>
#include <optional>
#include <vector>

namespace vibroimpact::periodic {

/// A periodic motion that Newton's method has found: a fixed point of the map's power, scaled.
struct FoundMotion {
  Vector state;
  long multiple = 1; ///< periods after which it repeats itself, and no sooner
  Matrix by_state;   ///< derivative of the power
};

struct Attractor {
  FoundMotion motion;
  std::vector<Vector> states; ///< of its `multiple` periods, the first one motion.state
  Eigen::VectorXcd multipliers;
  TrappingBall ball; ///< about motion.state, of the map's power
};

enum class Outcome {
  decided,
  undecided, ///< neither known nor repeating within the periods
  failed     ///< the motion ended with a numerical failure
};

struct Decision {
  Outcome outcome = Outcome::undecided;
  std::size_t attractor = 0; ///< of those known, where decided
  long periods = 0;          ///< looked at
};

struct AttractorSettings {
  long most_periods = 1000;
  long longest_multiple = 16; ///< of a motion that is looked for
  double largest = 0;         ///< size of the region of interest, scaled; of no ball is more tested
};

class Attractors {
public:
  /// Newton's method from a state that nearly returns after so many periods; nothing where it finds
  /// no motion or an unstable one.
  using Newton = std::function<std::optional<FoundMotion>(const Vector &state, long multiple)>;

  Attractors(StateMap map, Newton newton, const AttractorSettings &settings)
      : map_(std::move(map)), newton_(std::move(newton)), settings_(settings) {}

  /// Follows a motion; one that leads to a stable motion not yet known adds it to the list.
  Decision follow(const Vector &start) { return follow(start, map_, 1); }
  /// By another map that comes near this one, such as an interpolated one, within this share of
  /// the balls. New motions are still those of the map itself.
  Decision follow(const Vector &start, const StateMap &map, double share);

  const std::vector<Attractor> &list() const { return list_; }
  /// Those at these places of the present list, in this order.
  void choose(const std::vector<std::size_t> &places);
  /// The first ones only.
  void keep(std::size_t count) {
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(count), list_.end());
  }

private:
  std::optional<std::size_t> trapped(const Vector &state, double share) const;
  std::optional<std::size_t> nearest(const Vector &state, double distance) const;
  std::optional<std::size_t> recognise(const Vector &state, long multiple, double size);
  std::size_t add(const FoundMotion &motion);

  StateMap map_;
  Newton newton_;
  AttractorSettings settings_;
  std::vector<Attractor> list_;
};

} // namespace vibroimpact::periodic
