#include "periodic/shooting.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <cmath>
#include <sstream>

namespace vibroimpact::periodic {

namespace {

constexpr long most_iterations = 20;
constexpr long most_map_periods = 60; // of the map that the motion goes on for by itself
constexpr double shares[] = {1, 0.5, 0.25, 0.125}; // of a step, one after the other
constexpr double decrease = 0.25;    // of the residual, of that which the step should bring
constexpr double exact = 1e-12;      // a step over the size of the motion that ends the sequence
constexpr double near_length = 1e-7; // below which it must shrink by
constexpr double still_going = 0.1;  // or has come as near as it can
constexpr double quadratic = 1e-4;   // steps below which Newton's method needs no damping

class Newton {
public:
  Newton(const StroboscopicMap &map, const Section &section, const Vector &start)
      : map_(map), section_(section) {
    point_ = evaluate(start);
  }

  FixedPoint run() {
    double last = std::numeric_limits<double>::infinity();
    for (; point_.iterations < most_iterations; ++point_.iterations) {
      const Vector step = newton_step();
      const double length = map_.norm(step) / size();
      if (length <= exact || (length <= near_length && length >= still_going * last))
        return point_;
      last = length;
      advance(step, length);
    }
    fail("after " + std::to_string(most_iterations) + " iterations");
  }

private:
  FixedPoint evaluate(const Vector &state) const {
    FixedPoint point{.state = state, .image = map_.image(section_, state)};
    point.residual = map_.norm(point.image.state - state) / size_of(point);
    return point;
  }

  double size_of(const FixedPoint &point) const {
    const double size = std::max(map_.norm(point.state), map_.norm(point.image.state));
    return size > 0 ? size : 1;
  }
  double size() const { return size_of(point_); }

  // In scaled entries, which are of one size.
  Vector newton_step() const {
    const Vector &s = map_.scale();
    const Matrix matrix = Matrix::Identity(map_.size(), map_.size()) -
                          s.asDiagonal() * point_.image.by_state * s.cwiseInverse().asDiagonal();
    const Vector step =
        solve_fully_pivoted(matrix, s.asDiagonal() * (point_.image.state - point_.state));
    if (!step.allFinite())
      fail("where a multiplier is 1");
    return step.cwiseQuotient(s);
  }

  void advance(const Vector &step, double length) {
    for (const double share : shares) {
      try {
        FixedPoint next = evaluate(point_.state + share * step);
        if (length < quadratic ||
            next.residual * size_of(next) < (1 - decrease * share) * point_.residual * size()) {
          keep(std::move(next));
          return;
        }
      } catch (const NumericalError &) { // a shorter step may stay where motions go through
      }
    }
    fail("since an eighth of its step does not bring the motion nearer");
  }

  void keep(FixedPoint next) {
    next.iterations = point_.iterations;
    point_ = std::move(next);
  }

  [[noreturn]] void fail(const std::string &why) const {
    std::ostringstream text;
    text << "Newton's method has found no periodic motion of multiple " << section_.multiple()
         << ": it ends " << why << ", " << point_.residual
         << " of the motion away from repeating itself; a start that is nearer to it may help";
    throw NumericalError(text.str());
  }

  const StroboscopicMap &map_;
  const Section &section_;
  FixedPoint point_;
};

} // namespace

// Ever more periods between two attempts: a motion near a stable one settles.
FixedPoint find_fixed_point(const StroboscopicMap &map, const Section &section,
                            const Vector &start) {
  Vector state = start;
  for (long gone = 0, next = 4;; next *= 2) {
    try {
      return Newton(map, section, state).run();
    } catch (const NumericalError &) {
      if (gone + next > most_map_periods)
        throw;
    }
    for (long period = 0; period < next; ++period, ++gone)
      state =
          map.mirrored(section, map.carry(section.phase, section.phase + section.length(), state));
  }
}

} // namespace vibroimpact::periodic
