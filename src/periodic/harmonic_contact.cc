#include "periodic/harmonic_contact.h"

#include "common/error.h"
#include "common/zero.h"
#include "continuation/harmonic_series.h"
#include "periodic/law_march.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vibroimpact::periodic {

namespace {

constexpr int most_changes = 64; // within an interval
constexpr int most_periods = 100;

/// A guard that falls through zero.
struct Fall {
  double phase = 0;
  const contact::Guard *guard = nullptr;
};

class Period {
public:
  Period(const LawMarch &march, const HarmonicGrid &grid, bool slopes)
      : march_{march}, grid_{grid}, slopes_{slopes} {}

  // Until the internal states and the mode are those of the beginning.
  ContactSeries run() {
    LawState state = march_.start();
    for (int period = 0; period < most_periods; ++period) {
      clear();
      const LawState begin = state;
      for (Index i = 0; i < grid_.intervals(); ++i)
        state = pass(i, std::move(state));
      if (state.repeats(begin))
        return std::move(series_);
    }
    throw NumericalError("the internal states of a contact do not repeat themselves within " +
                         std::to_string(most_periods) + " periods");
  }

private:
  void clear() {
    series_.force.setZero(grid_.coefficients());
    if (slopes_)
      series_.by_gap.setZero(grid_.coefficients(), grid_.coefficients());
    series_.largest = 0;
  }

  LawState pass(Index interval, LawState state) {
    const double end = grid_.begin(interval + 1);
    double at = grid_.begin(interval);
    for (int change = 0; change < most_changes; ++change) {
      const LawPart part = change == 0 ? march_.part(interval, state) : march_.part(at, end, state);
      const std::optional<Fall> fall = first_fall(part, state);
      if (!fall) {
        add(part);
        return part.end;
      }
      if (fall->phase > at) {
        const LawPart shorter = march_.part(at, fall->phase, state);
        add(shorter);
        state = shorter.end;
      }
      at = fall->phase;
      state = pass_guard(state, *fall);
    }
    throw NumericalError("a contact changes its mode without end");
  }

  void add(const LawPart &part) {
    if (!part.acts)
      return;
    for (Index k = 0; k < HarmonicGrid::nodes; ++k) {
      const Vector weight = part.length * HarmonicGrid::weights()(k) *
                            continuation::harmonic_projection(part.basis.col(k));
      series_.force += part.force(k) * weight.transpose();
      if (slopes_)
        series_.by_gap.noalias() += weight * part.force_slope.col(k).transpose();
    }
    series_.largest = std::max(series_.largest, largest(part.force));
  }

  // The vertex of the parabola through the largest value and its neighbours.
  static double largest(const Vector &force) {
    Index k = 0;
    const double most = force.maxCoeff(&k);
    if (k == 0 || k + 1 == force.size())
      return most;
    const Vector &place = HarmonicGrid::places();
    const double behind = (most - force(k - 1)) / (place(k) - place(k - 1));
    const double ahead = (force(k + 1) - most) / (place(k + 1) - place(k));
    const double curvature = (ahead - behind) / (place(k + 1) - place(k - 1));
    const double slope = ahead - curvature * (place(k + 1) - place(k));
    return curvature < 0 ? most - slope * slope / (4 * curvature) : most;
  }

  // The jump of the force moves with the instant of the change.
  LawState pass_guard(const LawState &before, const Fall &fall) {
    const LawPassage passage = march_.pass(before, fall.phase, *fall.guard);
    const Vector weight = continuation::harmonic_projection(
        continuation::harmonic_basis(fall.phase, grid_.harmonics()));
    if (slopes_)
      series_.by_gap.noalias() +=
          weight * ((passage.force_before - passage.force_after) * passage.phase_slope);
    series_.largest = std::max({series_.largest, passage.force_before, passage.force_after});
    return passage.after;
  }

  std::optional<Fall> first_fall(const LawPart &part, const LawState &state) const {
    std::optional<Fall> first;
    for (const contact::Guard &guard : march_.guards(state))
      if (const auto phase = fall_of(part, state, guard);
          phase && !(first && first->phase <= *phase))
        first = Fall{.phase = *phase, .guard = &guard};
    return first;
  }

  // At its start, nodes and end; a guard that is zero after a change may be below by rounding.
  std::optional<double> fall_of(const LawPart &part, const LawState &state,
                                const contact::Guard &guard) const {
    const Vector values = march_.guard_values(part, state, guard);
    if (values(0) < 0 && values(1) < 0)
      return part.begin;
    const auto value = [&](double phase) {
      return march_.guard_value(state, part.begin, phase, guard);
    };
    for (Index k = 1; k < values.size(); ++k) {
      const double left = part.place(k - 1), right = part.place(k);
      if (values(k) < 0)
        return zero(value, left, std::max(values(k - 1), 0.0), right, values(k));
      if (k + 1 < values.size() && dips(part, values, k))
        if (const Minimum lowest = minimum_between(value, left, part.place(k + 1));
            lowest.value < 0)
          return zero(value, left, values(k - 1), lowest.place, lowest.value);
    }
    return std::nullopt;
  }

  // Does the parabola through three values fall below a quarter of the middle one?
  static bool dips(const LawPart &part, const Vector &values, Index k) {
    const double a = values(k - 1), b = values(k), c = values(k + 1);
    if (!(b < a && b < c))
      return false;
    const double behind = part.place(k) - part.place(k - 1);
    const double ahead = part.place(k + 1) - part.place(k);
    const double curvature = ((c - b) / ahead + (a - b) / behind) / (ahead + behind);
    const double slope = (c - b) / ahead - curvature * ahead;
    return b - slope * slope / (4 * curvature) < b / 4;
  }

  template <typename Function>
  static double zero(const Function &value, double left, double at_left, double right,
                     double at_right) {
    if (at_left <= 0)
      return left;
    std::uintmax_t iterations = 80;
    const auto found =
        boost::math::tools::toms748_solve(value, left, right, at_left, at_right,
                                          boost::math::tools::eps_tolerance<double>(), iterations);
    return (found.first + found.second) / 2;
  }

  const LawMarch &march_;
  const HarmonicGrid &grid_;
  bool slopes_;
  ContactSeries series_;
};

} // namespace

ContactSeries contact_series(const contact::ContactPair &pair, const RowVector &gap,
                             double frequency, const HarmonicGrid &grid, bool slopes) {
  const LawMarch march(*pair.law, gap, frequency, grid);
  return Period(march, grid, slopes).run();
}

} // namespace vibroimpact::periodic
