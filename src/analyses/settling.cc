#include "analyses/settling.h"

#include "analyses/sequence_limit.h"
#include "analyses/steadiness.h"
#include "common/error.h"

#include <algorithm>
#include <optional>

namespace vibroimpact::analyses {

using motion::Trajectory;

namespace {

void find_range(const LastStates &states, Index count, SettledMotion &motion) {
  motion.lowest = motion.highest = states[0];
  for (Index i = 1; i < std::min(count, states.count()); ++i) {
    motion.lowest = motion.lowest.cwiseMin(states[i]);
    motion.highest = motion.highest.cwiseMax(states[i]);
  }
}

double largest(const Vector &states, const Vector &scale) {
  return states.cwiseProduct(scale).cwiseAbs().maxCoeff();
}

class Settling {
public:
  Settling(Trajectory &trajectory, double period, const Vector &scale, const SettlingRule &rule)
      : trajectory_(trajectory), period_(period), scale_(scale), rule_(rule),
        steadiness_(scale, rule.longest_multiple, rule.tolerance), sequence_(scale),
        states_(scale.size(), 2 * rule.longest_multiple + 1), extrapolates_(rule.extrapolates) {
    begin(physical_state());
  }

  long cycles() const { return cycles_; }
  bool steady() const { return steadiness_.steady(); }
  bool over() const;
  SettledMotion motion() const;
  void advance();

private:
  ConstVectorView physical_state() const;
  void begin(const Eigen::Ref<const Vector> &state);
  void extrapolate();
  bool leap(const Vector &state);

  Trajectory &trajectory_;
  double period_;
  const Vector &scale_;
  const SettlingRule &rule_;
  Steadiness steadiness_;
  SequenceLimit sequence_;
  LastStates states_;
  long cycles_ = 0;
  bool extrapolates_;
  Vector left_;            ///< where the last leap began; empty after another period
  double left_change_ = 0; ///< over the last period before it
};

bool Settling::over() const {
  if (cycles_ >= rule_.maximum)
    return true;
  const bool hopeless =
      rule_.without_approach > 0 && steadiness_.without_approach() >= rule_.without_approach;
  return cycles_ >= rule_.minimum && (steady() || hopeless);
}

ConstVectorView Settling::physical_state() const {
  return {trajectory_.state().data(), trajectory_.layout().physical_size()};
}

void Settling::begin(const Eigen::Ref<const Vector> &state) {
  states_.clear();
  states_.add(state);
  sequence_.clear();
  sequence_.add(state);
}

void Settling::advance() {
  ++cycles_;
  trajectory_.advance(static_cast<double>(cycles_) * period_);
  states_.add(physical_state());
  steadiness_.add(physical_state());
  if (extrapolates_)
    extrapolate();
}

// A leap that does not bring the motion nearer is taken back, and is the last.
void Settling::extrapolate() {
  sequence_.add(physical_state());
  if (left_.size() > 0 && !(sequence_.last_change() <= left_change_)) {
    extrapolates_ = false;
    leap(left_);
    return;
  }
  left_.resize(0);
  if (steady())
    return;
  if (const std::optional<Vector> limit = sequence_.limit()) {
    left_ = states_[0];
    left_change_ = sequence_.last_change();
    if (!leap(*limit)) {
      extrapolates_ = false;
      leap(left_);
    }
  }
}

// False: no motion can start there.
bool Settling::leap(const Vector &state) {
  try {
    trajectory_.start({.time = static_cast<double>(cycles_) * period_, .physical = state});
  } catch (const NumericalError &) {
    return false;
  }
  begin(state);
  steadiness_.clear();
  steadiness_.add(state);
  return true;
}

SettledMotion Settling::motion() const {
  SettledMotion motion;
  motion.cycles = cycles_;
  motion.state = {.time = 0, .physical = states_[0]};
  motion.multiple = steadiness_.multiple();
  find_range(states_, motion.steady() ? motion.multiple : states_.count(), motion);
  return motion;
}

} // namespace

void declare_settling(parameters::Section &section) {
  using namespace parameters;
  section
      .integer("Minimum settling cycles", "5", Range{.lower = 0, .upper = 1e9}, "",
               "Periods before the motion can be judged steady, at most Settling cycles.")
      .integer("Settling cycles", "200", Range{.lower = 0, .upper = 1e9}, "",
               "Periods after which it is recorded, steady or not.")
      .quantity("Steadiness tolerance", "1e-6", dimension::none, Range{.lower = 0, .upper = 1}, "",
                "Relative distance to the periodic motion at which it counts as steady; 0 always "
                "takes all settling cycles.")
      .boolean(
          "Extrapolate", "false",
          "Go straight to the motion that the last periods lead to, once they tell where, and on "
          "from there. The motion that is recorded must be steady by itself as ever. Off, the "
          "motion goes through its whole transient as a real one does.")
      .integer("Cycles without approach", "0", Range{.lower = 0, .upper = 1e9}, "",
               "Periods that bring the motion no nearer to repeating itself, after which it is "
               "recorded as not steady without waiting for all Settling cycles, since it is mostly "
               "chaotic. One that would settle later is lost. 0: it always gets all of them.")
      .integer("Longest period", "4", Range{.lower = 1, .upper = 1000}, "",
               "Longest period looked for, in forcing periods.");
}

SettlingRule read_settling(const parameters::Values &section) {
  const long maximum = section.integer("Settling cycles");
  const long minimum = section.integer("Minimum settling cycles");
  if (minimum > maximum && section.given("Minimum settling cycles"))
    section.reject("Minimum settling cycles",
                   "Minimum settling cycles must be at most Settling cycles.");
  return {.minimum = std::min(minimum, maximum),
          .maximum = maximum,
          .tolerance = section.quantity("Steadiness tolerance"),
          .longest_multiple = section.integer("Longest period"),
          .extrapolates = section.boolean("Extrapolate"),
          .without_approach = section.integer("Cycles without approach")};
}

SettledMotion settle(Trajectory &trajectory, double period, const Vector &scale,
                     const SettlingRule &rule,
                     const std::function<void(long periods)> &after_period) {
  Settling settling(trajectory, period, scale, rule);
  while (!settling.over()) {
    settling.advance();
    if (after_period)
      after_period(settling.cycles());
  }
  return settling.motion();
}

double relative_distance(const SettledMotion &a, const SettledMotion &b, const Vector &scale) {
  const double size = std::max({largest(a.lowest, scale), largest(a.highest, scale),
                                largest(b.lowest, scale), largest(b.highest, scale)});
  const double difference =
      std::max(largest(a.lowest - b.lowest, scale), largest(a.highest - b.highest, scale));
  return size > 0 ? difference / size : 0;
}

} // namespace vibroimpact::analyses
