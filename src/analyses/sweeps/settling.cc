#include "analyses/sweeps/settling.h"

#include "analyses/sweeps/steadiness.h"
#include "analyses/sweeps/steady_orbit.h"
#include "common/error.h"
#include "periodic/forced_system.h"

#include <algorithm>

namespace vibroimpact::analyses {

using motion::Trajectory;

namespace {

void find_range(const std::vector<Vector> &states, SettledMotion &motion) {
  motion.lowest = motion.highest = states.front();
  for (const Vector &state : states) {
    motion.lowest = motion.lowest.cwiseMin(state);
    motion.highest = motion.highest.cwiseMax(state);
  }
}

double largest(const Vector &states, const Vector &scale) {
  return states.cwiseProduct(scale).cwiseAbs().maxCoeff();
}

// Newton's method is tried after so many periods at first, of which it takes one more itself: that
// the motion approaches what is found is seen in the last two.
constexpr long newton_at_once = 2;
// A search costs about as much as so many periods of few coordinates: waiting for them first takes
// at most about twice as long as the better of the two ways there, whatever the damping.
constexpr long newton_later = 20;
// Another periodic motion is tried when the state repeats itself so much better after its periods.
constexpr double better_repetition = 0.25;
// Of the derivative, for Newton's method and the multipliers.
constexpr double tangent_tolerance = 1e-7;
constexpr double arrived = 1e-9; // distance to a periodic motion, over its size, that is rounding

class Settling {
public:
  Settling(Trajectory &trajectory, double period, const Vector &scale, const SettlingRule &rule,
           SteadyOrbitSearch *search)
      : trajectory_(trajectory), period_(period), scale_(scale), rule_(rule), search_(search),
        steadiness_(scale, rule.longest_multiple, rule.tolerance),
        states_(scale.size(), 2 * rule.longest_multiple + 1),
        next_search_(std::max(rule.newton_after.value_or(0), rule.minimum - 3)) {
    states_.add(physical_state());
  }

  long cycles() const { return cycles_; }
  bool over() const;
  SettledMotion motion() const;
  void advance();

private:
  ConstVectorView physical_state() const;
  bool steady() const { return on_orbit_ || steadiness_.steady(); }
  void take(const Eigen::Ref<const Vector> &state);
  void look_for_orbit();
  bool can_search(long multiple) const {
    return cycles_ + SteadyOrbitSearch::most_periods * multiple <= rule_.maximum;
  }
  void search(long multiple);
  long better_multiple() const;
  bool approaches() const;
  double distance(Index age) const { return orbit_->norm(deviation(age)); }
  Vector deviation(Index age) const {
    return (states_[age] - orbit_->states.front()).cwiseProduct(search_->scale());
  }
  void go_to(const Vector &state);

  Trajectory &trajectory_;
  double period_;
  const Vector &scale_;
  const SettlingRule &rule_;
  SteadyOrbitSearch *search_; ///< none: the motion settles by itself
  Steadiness steadiness_;
  LastStates states_;
  long cycles_ = 0;
  long next_search_;
  std::optional<SteadyOrbit> orbit_;
  long since_ = 0; ///< periods of the motion since the search for it began
  bool on_orbit_ = false;
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

void Settling::take(const Eigen::Ref<const Vector> &state) {
  states_.add(state);
  steadiness_.add(state);
  ++since_;
}

void Settling::advance() {
  ++cycles_;
  trajectory_.advance(static_cast<double>(cycles_) * period_);
  take(physical_state());
  if (search_ && !steady())
    look_for_orbit();
}

// What has been found is looked for anew when the motion does not approach it for as long as it
// took to find it.
void Settling::look_for_orbit() {
  if (cycles_ >= next_search_ && can_search(1)) {
    orbit_.reset();
    search(1);
    if (const long multiple = better_multiple(); !orbit_ && multiple > 1 && can_search(multiple))
      search(multiple);
    next_search_ = 2 * cycles_;
  }
  if (orbit_ && approaches()) {
    on_orbit_ = true;
    go_to(orbit_->states.front());
  }
}

void Settling::search(long multiple) {
  const Vector from = states_[0];
  SteadyOrbitSearch::Result result = search_->run(from, cycles_, multiple);
  since_ = 0;
  for (const Vector &state : result.carried)
    take(state);
  cycles_ += result.periods;
  orbit_ = std::move(result.orbit);
  go_to(states_[0]);
}

// The least number of periods after which the state repeats itself nearly best; 1 where that is
// hardly better than after one.
long Settling::better_multiple() const {
  const auto change = [&](Index k) {
    return (states_[0] - states_[k]).cwiseProduct(scale_).cwiseAbs().maxCoeff();
  };
  const Index longest = std::min<Index>(rule_.longest_multiple, (states_.count() - 1) / 2);
  Index best = 1;
  for (Index k = 2; k <= longest; ++k)
    if (change(k) < better_repetition * change(best))
      best = k;
  return best;
}

// In the last two periods of the periodic motion.
bool Settling::approaches() const {
  const Index k = orbit_->multiple();
  if (since_ % k != 0 || states_.count() <= 2 * k)
    return false;
  const double size = orbit_->states.front().cwiseProduct(search_->scale()).cwiseAbs().maxCoeff();
  if (deviation(0).cwiseAbs().maxCoeff() <= arrived * size)
    return true;
  const double contraction = 0.5 * (1 + orbit_->norm.contraction());
  return distance(0) <= contraction * distance(k) && distance(k) <= contraction * distance(2 * k);
}

void Settling::go_to(const Vector &state) {
  trajectory_.start({.time = static_cast<double>(cycles_) * period_, .physical = state});
}

SettledMotion Settling::motion() const {
  SettledMotion motion;
  motion.cycles = cycles_;
  motion.state = {.time = 0, .physical = physical_state()};
  if (on_orbit_) {
    motion.multiple = orbit_->multiple();
    find_range(orbit_->states, motion);
    return motion;
  }
  motion.multiple = steadiness_.multiple();
  std::vector<Vector> last;
  const Index count = motion.steady() ? motion.multiple : states_.count();
  for (Index i = 0; i < std::min(count, states_.count()); ++i)
    last.emplace_back(states_[i]);
  find_range(last, motion);
  return motion;
}

std::optional<long> newton_after(const std::string &method) {
  if (method == "transient")
    return std::nullopt;
  return method == "Newton" ? newton_at_once : newton_later;
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
                "Relative distance to the periodic motion at which it counts as steady; 0 takes "
                "all settling cycles, unless a motion repeats itself bit for bit.")
      .choice("Settling method", "automatic", {"automatic", "transient", "Newton"},
              "How the steady motion is reached: by waiting until the transient has decayed, as "
              "that of a real system does; by Newton's method after 2 periods; or automatic, by "
              "Newton's method where the transient has not decayed after 20 periods. What Newton's "
              "method finds counts only where it is stable and the motion is seen to approach it; "
              "else the transient goes on, as it does for rotors and for excitations that do not "
              "repeat themselves.")
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
          .newton_after = newton_after(section.choice("Settling method")),
          .without_approach = section.integer("Cycles without approach")};
}

SettledMotion Settler::operator()(double period, const Vector &scale, const SettlingRule &rule,
                                  const std::function<void(long periods)> &after_period) {
  std::optional<SteadyOrbitSearch> search;
  if (rule.newton_after && rule.tolerance > 0 && repeats(period))
    search.emplace(trajectory_, lineariser((scale.array() > 0).select(scale, 1)), scale_, period);
  Settling settling(trajectory_, period, scale, rule, search ? &*search : nullptr);
  while (!settling.over()) {
    settling.advance();
    if (after_period)
      after_period(settling.cycles());
  }
  return settling.motion();
}

// False for motions that do not repeat themselves after the period, whatever they do.
bool Settler::repeats(double period) const {
  const model::Model &model = trajectory_.equations().model();
  const bool runs_up = std::any_of(model.spins().begin(), model.spins().end(),
                                   [](const model::Spin &spin) { return !spin.speed.constant(); });
  return model.rotors().empty() && !runs_up && !periodic::source_without_period(model, period);
}

// What one has done before must leave no trace in what it does next.
motion::Lineariser &Settler::lineariser(const Vector &scale) {
  if (!lineariser_ || scale_ != scale) {
    scale_ = scale;
    lineariser_.emplace(trajectory_,
                        motion::VariationAccuracy{.scale = scale_, .tolerance = tangent_tolerance});
  }
  return *lineariser_;
}

double relative_distance(const SettledMotion &a, const SettledMotion &b, const Vector &scale) {
  const double size = std::max({largest(a.lowest, scale), largest(a.highest, scale),
                                largest(b.lowest, scale), largest(b.highest, scale)});
  const double difference =
      std::max(largest(a.lowest - b.lowest, scale), largest(a.highest - b.highest, scale));
  return size > 0 ? difference / size : 0;
}

} // namespace vibroimpact::analyses
