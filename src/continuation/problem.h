// What continuation asks of the equations it follows: F(x, p) = 0, with x in R^n and one key p
// along a branch, two along a locus. Everything is in the problem's own units.
//
// F may be piecewise smooth: a pattern tells which piece a point lies in. Where F is P(x, p) - x
// with a map P, such as that of a period, the eigenvalues of dP/dx are the multipliers.
#pragma once

#include "common/error.h"
#include "common/linear_algebra.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::continuation {

struct Point {
  Vector state; ///< x, n
  Vector keys;  ///< p, one along a branch, two along a locus
  /// Which coordinates the state is given in, where a problem has several, such as the phase at
  /// which a motion is observed. Equal numbers mean equal coordinates.
  double chart = 0;
};

/// Equal patterns: F is smooth between the points. For a motion, its sequence of contact changes.
using Pattern = std::vector<int>;

struct Evaluation {
  Vector residual; ///< F, n
  Matrix by_state; ///< dF/dx, n x n
  Matrix by_keys;  ///< dF/dp, n x keys
  Pattern pattern{};
  /// How far this point is from where its chart loses smoothness, in parts of the whole; for a
  /// motion, the time between the section and the nearest contact change over the period.
  double chart_margin = std::numeric_limits<double>::infinity();
};

/// The same point in another chart: x' with dx'/dx (n x n) and dx'/dp (n x keys).
struct Transfer {
  Point point;
  Matrix by_state, by_keys;
};

/// What becomes of F where a guard just touches zero.
enum class Touch {
  smooth,      ///< F is once differentiable; derivatives run as the square root of the depth
  corner,      ///< derivatives jump by a matrix of rank one
  square_root, ///< derivatives are unbounded
  one_sided    ///< F jumps: solutions on one side have none close by on the other
};

/// Two pieces of F meet where the least value of a guard is zero. Made and read by the problem
/// only.
struct Graze {
  int guard = 0;       ///< which one, by the problem's own count
  double position = 0; ///< which of its minima, such as an instant in parts of the period
  double ignored = 0;  ///< depth below zero up to which the extension overlooks it
  int kind = 0;        ///< of a located one: that of its extension
  std::string name;    ///< for messages and results
};

/// F extended smoothly from the side on which the guard stays above zero to the other side.
struct Extension {
  Evaluation smooth{}; ///< of the extended F
  double value = 0;    ///< least value of the guard; > 0: not touched
  RowVector by_state;  ///< of the value, n
  RowVector by_keys;   ///< of the value, one for each key
  Touch touch = Touch::smooth;
  int kind = 0; ///< for results, by the problem's own count
  /// Where the touch is a corner: derivatives of F behind it are those of `smooth` plus this times
  /// those of the value; n, otherwise empty.
  Vector jump{};
};

/// How far a solution of the map P^m misses to be one of P^multiple, a proper divisor of m.
struct ShorterReturn {
  int multiple = 1;
  Vector displacement; ///< P^multiple(x) - x, n
};

class Problem {
public:
  virtual ~Problem() = default;

  /// What counts as one of each unknown, n + keys positive numbers: one for each kind of coordinate
  /// and the range or size of each key. The same as long as the problem lives.
  virtual Vector scales() const = 0;
  /// NumericalError where there is no value: the step is shortened. Others, Interrupted among them,
  /// pass.
  virtual Evaluation evaluate(const Point &point) = 0;
  /// Is F = P(x, p) - x with a map P? Without one there are no multipliers, and folds, branch
  /// points and grazes are the only special points.
  virtual bool is_map() const { return true; }
  /// Of a map that is a power: all proper divisors of its multiple.
  virtual std::vector<ShorterReturn> shorter_returns(const Point &) { return {}; }
  /// P(P(x, p), p) - x, whose branches begin at flips of this one; no map: null.
  virtual std::unique_ptr<Problem> doubled() { return nullptr; }

  /// The chart in which this point is furthest from where its chart ends.
  virtual double best_chart(const Point &point) { return point.chart; }
  virtual Transfer transfer(const Point &point, double chart);

  /// Minima of guards that may touch zero close to this solution, the nearest first; none where F
  /// is smooth everywhere. Minima below zero count as well: those are contacts about to be lost.
  virtual std::vector<Graze> grazes_near(const Point &) { return {}; }
  /// NumericalError where the guard has no such minimum.
  virtual Extension extend(const Point &point, const Graze &graze);
  /// For a curve of grazes: F extended over this one, as a problem whose charts keep away from
  /// where it grazes too; null where the charts of this problem will do.
  virtual std::unique_ptr<Problem> extended(const Graze &) { return nullptr; }

  /// What values depend on beside the point, and change where points are evaluated one after the
  /// other along a curve; none: the point alone.
  virtual std::vector<double> remembered() const { return {}; }
  /// Goes on as the problem did that remembered this.
  virtual void remember(const std::vector<double> & /*numbers*/) {}

  /// Multipliers up to one and this count as no larger than one. Not zero: of motions without
  /// losses, whose multipliers are one in absolute value but for rounding unless they are unstable,
  /// and none of them comes to cross the unit circle as a pair.
  virtual double neutral_margin() const { return 0; }
};

} // namespace vibroimpact::continuation
