#include "contact/frictional_impact.h"

#include <cmath>
#include <limits>

namespace vibroimpact::contact {

namespace {

constexpr double rounding_of_impact = 1e-12;

// A number with its derivatives by the rates before the impact.
struct Tracked {
  double value = 0;
  Eigen::RowVector2d by = Eigen::RowVector2d::Zero();
};
Tracked operator+(const Tracked &x, const Tracked &y) { return {x.value + y.value, x.by + y.by}; }
Tracked operator-(const Tracked &x, const Tracked &y) { return {x.value - y.value, x.by - y.by}; }
Tracked operator*(double c, const Tracked &x) { return {c * x.value, c * x.by}; }
Tracked operator*(const Tracked &x, const Tracked &y) {
  return {x.value * y.value, x.value * y.by + y.value * x.by};
}
Tracked operator/(const Tracked &x, const Tracked &y) {
  const double quotient = x.value / y.value;
  return {quotient, (x.by - quotient * y.by) / y.value};
}
Tracked root(const Tracked &x) {
  const double value = std::sqrt(x.value);
  return {value, x.by / (2 * value)};
}

// In which the velocities are linear in the impulse.
struct Leg {
  double friction = 0;                  // tangential impulse per normal one
  double gap_slope = 0, slip_slope = 0; // dv_n/dp, dv_t/dp; stick: exactly no slip
};

class ImpactCourse {
public:
  explicit ImpactCourse(const PointImpact &impact)
      : impact_(impact), gap_rate_{impact.gap_rate, {1, 0}}, slip_rate_{impact.slip_rate, {0, 1}},
        leg_(impact.slip_rate == 0 ? beyond_stop()
                                   : slipping(std::copysign(1.0, impact.slip_rate))) {}

  PointImpulse run() {
    compress();
    if (impact_.restitution > 0)
      restore();
    PointImpulse made{.impulse = {normal_.value, tangential_.value},
                      .after = {gap_rate_.value, slip_rate_.value},
                      .rubbing = rubbing_};
    made.by_rates << normal_.by, tangential_.by;
    return made;
  }

private:
  Leg slipping(double sigma) const {
    const double share = sigma * impact_.friction;
    return {.friction = -share,
            .gap_slope = impact_.normal - share * impact_.coupling,
            .slip_slope = impact_.coupling - share * impact_.tangential};
  }

  // Where v_t = 0.
  Leg beyond_stop() const {
    if (std::abs(impact_.coupling) > impact_.friction * impact_.tangential)
      return slipping(std::copysign(1.0, impact_.coupling));
    const double held = -impact_.coupling / impact_.tangential;
    return {.friction = held, .gap_slope = impact_.normal + held * impact_.coupling};
  }

  // The normal impulse until v_t = 0.
  double until_stop() const {
    return slip_rate_.value * leg_.slip_slope < 0 ? -slip_rate_.value / leg_.slip_slope
                                                  : std::numeric_limits<double>::infinity();
  }

  void act(const Tracked &impulse) {
    const Tracked before = slip_rate_;
    const Tracked gap_rate = gap_rate_ + leg_.gap_slope * impulse;
    work_ = work_ + 0.5 * (impulse * (gap_rate_ + gap_rate));
    gap_rate_ = gap_rate;
    slip_rate_ = slip_rate_ + leg_.slip_slope * impulse;
    normal_ = normal_ + impulse;
    tangential_ = tangential_ + leg_.friction * impulse;
    rubbing_ += 0.5 * std::abs(before.value + slip_rate_.value) * impulse.value;
  }

  void stop() {
    act((-1 / leg_.slip_slope) * slip_rate_);
    slip_rate_ = {};
    leg_ = beyond_stop();
  }

  void compress() {
    const auto until_rest = [&] {
      return leg_.gap_slope > 0 ? -gap_rate_.value / leg_.gap_slope
                                : std::numeric_limits<double>::infinity();
    };
    while (gap_rate_.value < rounding_of_impact * impact_.gap_rate) {
      if (until_stop() <= (1 + rounding_of_impact) * until_rest())
        stop(); // both at once on a rail, where one velocity is all there is
      else
        act((-1 / leg_.gap_slope) * gap_rate_);
    }
    gap_rate_ = {};
  }

  // The normal impulse that is left in the present leg.
  Tracked remaining(const Tracked &at_compression, const Tracked &taken) const {
    const double e = impact_.restitution;
    if (impact_.hypothesis == RestitutionHypothesis::poisson)
      return (1 + e) * at_compression - normal_;
    const Tracked before{impact_.gap_rate, {1, 0}};
    if (impact_.hypothesis == RestitutionHypothesis::newton)
      return (1 / leg_.gap_slope) * ((-e) * before - gap_rate_);
    const Tracked owed = (-e * e) * taken - (work_ - taken);
    const Tracked speed = root(gap_rate_ * gap_rate_ + (2 * leg_.gap_slope) * owed);
    return 2 * (owed / (gap_rate_ + speed));
  }

  // A wedge that sticks, b^2 = a d, has no way back.
  void restore() {
    const Tracked compressed = normal_, taken = work_;
    while (leg_.gap_slope > rounding_of_impact * impact_.normal) {
      const Tracked rest = remaining(compressed, taken);
      if (until_stop() >= rest.value) {
        act(rest);
        return;
      }
      stop();
    }
  }

  const PointImpact &impact_;
  Tracked gap_rate_, slip_rate_;
  Tracked normal_{}, tangential_{}; // impulses
  Tracked work_{};                  // integral of v_n dp
  double rubbing_ = 0;
  Leg leg_;
};

} // namespace

PointImpulse impulse_at_point(const PointImpact &impact) {
  if (impact.gap_rate >= 0)
    return {.after = {impact.gap_rate, impact.slip_rate}};
  return ImpactCourse(impact).run();
}

} // namespace vibroimpact::contact
