#include "motion/interval/guard_curves.h"

#include "common/error.h"
#include "motion/interval/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

// Every other division halves an interval at least; after so many it is as short as the spacing of
// doubles next to the end.
constexpr int deepest_guard_interval = 110;

// Far more than any motion needs; nothing is searched for ever.
constexpr long most_divisions = 1000000;

struct Piece {
  double from, to;
  Jet at_from, at_to;
  int depth;
};

enum class Finding { positive, negative, falls, rises, in_rounding, unknown };

class FallSearch {
public:
  FallSearch(const GuardCurves &curves, Index guard, double end, const GuardStart &start)
      : curves_(curves), guard_(guard), begin_(start.until), end_(end), shift_(start.shift),
        margin_(curves.rounding(guard)), leaves_zero_(start.zero) {
    // A zero is not below zero, whatever the rounding of this evaluation makes of it.
    if (leaves_zero_)
      shift_ = std::max(shift_, -curves.at(guard, 0).value);
  }

  FirstDownCrossing run();

private:
  void divide(const Piece &whole);
  Jet at(double time) const;
  bool proven_positive(const Piece &piece, double bound) const;
  Finding examine(const Piece &piece) const;
  Finding by_ends(const Piece &piece) const;
  bool pass(const Piece &piece, Finding finding);
  double split_point(const Piece &piece) const;
  double fall_between(double lower, double upper) const;
  double refine(double lower, double upper) const;

  const GuardCurves &curves_;
  Index guard_;
  double begin_;
  double end_;
  double shift_;
  double margin_;
  bool leaves_zero_;
  std::optional<double> entered_{}; // the guard came within its rounding of zero after this
  double reached_ = 0;              // and was there at this instant
  FirstDownCrossing result_{};
};

Jet FallSearch::at(double time) const {
  Jet jet = curves_.at(guard_, time);
  jet.value += shift_;
  return jet;
}

// The cheap test that almost all steps pass.
bool FallSearch::proven_positive(const Piece &piece, double bound) const {
  const double h = piece.to - piece.from;
  const Jet &a = piece.at_from;
  const Jet &b = piece.at_to;
  const double lowest = std::min(
      {a.value, a.value + h / 5 * a.rate, a.value + h * (0.4 * a.rate + h / 20 * a.acceleration),
       b.value - h * (0.4 * b.rate - h / 20 * b.acceleration), b.value - h / 5 * b.rate, b.value});
  return lowest > margin_ + bound / 46080;
}

Finding FallSearch::by_ends(const Piece &piece) const {
  if (piece.at_to.value < -margin_)
    return Finding::falls;
  return piece.at_to.value > margin_ ? Finding::rises : Finding::in_rounding;
}

Finding FallSearch::examine(const Piece &piece) const {
  const double h = piece.to - piece.from;
  const double bound =
      curves_.sixth_derivative(guard_, piece.from, piece.to) * h * h * h * h * h * h;
  if (proven_positive(piece, bound))
    return Finding::positive;
  if (!std::isfinite(bound) || !std::isfinite(piece.at_from.value + piece.at_to.value))
    throw NumericalError("a gap is no longer finite");
  const Jet &a = piece.at_from;
  const Jet &b = piece.at_to;
  const Bernstein p =
      Bernstein::quintic(h, {a.value, a.rate, a.acceleration}, {b.value, b.rate, b.acceleration});
  const double lowest = p.with_middle(-bound / 14400).lower_bound();
  const double highest = p.with_middle(bound / 14400).upper_bound();
  if (lowest > margin_)
    return Finding::positive;
  if (highest < -margin_)
    return Finding::negative;
  if (lowest >= -margin_ && highest <= margin_)
    return Finding::in_rounding;
  // |f' - p'| <= M h^5 / (5! 2^4); here by the fraction of the interval.
  const Bernstein slope = p.derivative();
  const bool monotonic = slope.upper_bound() < -bound / 1920 || slope.lower_bound() > bound / 1920;
  const bool indivisible = piece.depth == deepest_guard_interval ||
                           h <= 4 * std::numeric_limits<double>::epsilon() * end_;
  return monotonic || indivisible ? by_ends(piece) : Finding::unknown;
}

// The only fall, or one of several that rounding cannot tell apart, between an instant at which the
// guard is not below zero and one at which it is: bisection, with Newton steps where these stay
// inside.
double FallSearch::refine(double lower, double upper) const {
  constexpr double resolution = 2 * std::numeric_limits<double>::epsilon();
  double time = 0.5 * (lower + upper);
  for (int i = 0; i < 200 && upper - lower > resolution * upper; ++i) {
    const Jet jet = at(time);
    (jet.value > 0 ? lower : upper) = time;
    const double newton = time - jet.value / jet.rate;
    const bool inside = newton > lower && newton < upper;
    const double next = inside ? newton : 0.5 * (lower + upper);
    if (std::abs(next - time) <= resolution * time || next <= lower || next >= upper)
      break;
    time = next;
  }
  return time;
}

// A guard that rises from zero by less than its rounding, and then falls, falls as late as its
// values say: at the start itself, the mode to which the contact changes could send it back.
double FallSearch::fall_between(double lower, double upper) const {
  if (at(lower).value > 0)
    return refine(lower, upper);
  double between = upper;
  for (int halvings = 0; halvings < std::numeric_limits<double>::digits; ++halvings) {
    between = lower + 0.5 * (between - lower);
    if (at(between).value > 0)
      return refine(between, upper);
  }
  return lower;
}

// Where the slopes at both ends suggest a minimum, every other time; else the middle.
double FallSearch::split_point(const Piece &piece) const {
  const double h = piece.to - piece.from;
  const double from = piece.at_from.rate;
  const double to = piece.at_to.rate;
  const bool at_minimum = piece.depth % 2 == 0 && from < 0 && to > 0;
  const double part = at_minimum ? from / (from - to) : 0.5;
  return piece.from + std::clamp(part, 0.05, 0.95) * h;
}

// True when the search is over.
bool FallSearch::pass(const Piece &piece, Finding finding) {
  if (piece.from == begin_ && piece.at_from.value < -margin_) {
    result_.time = 0;
    return true;
  }
  const bool began_in_rounding = piece.from == begin_ && piece.at_from.value <= margin_;
  if (!entered_ && began_in_rounding) {
    entered_ = piece.from;
    reached_ = piece.from;
  }
  if (finding == Finding::negative || finding == Finding::falls) {
    const double lower = entered_.value_or(piece.from);
    const double upper = finding == Finding::falls ? piece.to : piece.from;
    result_.time = fall_between(lower, upper);
    return true;
  }
  if (finding == Finding::in_rounding) {
    if (!entered_)
      reached_ = piece.to;
    entered_ = entered_.value_or(piece.from);
    return false;
  }
  if (entered_ && !leaves_zero_ && !result_.touch)
    result_.touch = reached_;
  leaves_zero_ = false;
  entered_.reset();
  return false;
}

FirstDownCrossing FallSearch::run() {
  if (begin_ >= end_)
    return result_;
  const Piece whole{
      .from = begin_, .to = end_, .at_from = at(begin_), .at_to = at(end_), .depth = 0};
  if (examine(whole) != Finding::positive)
    divide(whole);
  return result_;
}

// From left to right, until the first fall.
void FallSearch::divide(const Piece &whole) {
  std::array<Piece, deepest_guard_interval + 2> stack;
  std::size_t count = 0;
  stack[count++] = whole;
  for (long divisions = 0; count > 0; ++divisions) {
    if (divisions > most_divisions)
      throw NumericalError(
          "a contact change could not be distinguished from none by any division of the step");
    const Piece piece = stack[--count];
    const Finding finding = examine(piece);
    if (finding == Finding::unknown) {
      const double middle = split_point(piece);
      const Jet between = at(middle);
      stack[count++] = {middle, piece.to, between, piece.at_to, piece.depth + 1};
      stack[count++] = {piece.from, middle, piece.at_from, between, piece.depth + 1};
    } else if (pass(piece, finding)) {
      break;
    }
  }
}

} // namespace

FirstDownCrossing first_down_crossing(const GuardCurves &curves, Index guard, double end,
                                      const GuardStart &start) {
  return FallSearch(curves, guard, end, start).run();
}

} // namespace vibroimpact::motion
