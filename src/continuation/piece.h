// Part of a branch between two nodes, on which F is smooth: the points on it and the zeros of
// tests.
//
// The point at the distance s from the beginning along the chord lies on the hyperplane normal to
// the chord; behind a graze the depth of the touch takes the place of s. A zero of a test along the
// way is found by the method of Alefeld, Potra and Shi (1995). Nothing is interpolated: what is
// located is a solution, accurate to rounding where the derivatives are.
#pragma once

#include "continuation/contact_side.h"

namespace vibroimpact::continuation {

/// Cubic polynomial through two points with their tangents, over the distance along the chord,
/// where du/ds = t / (t . chord).
class Hermite {
public:
  Hermite(const Vector &begin, const Vector &begin_tangent, const Vector &end,
          const Vector &end_tangent);
  Vector at(double share) const; ///< share of the chord
  /// A prediction of the curve's next point, in the hyperplane at the distance `step` along the
  /// tangent at the end: the cubic led on, which is off by step^4; where that is far from the
  /// tangent, off by step^2, the latter.
  Vector beyond(double step) const;
  const Vector &chord() const { return chord_; } ///< of length 1
  double length() const { return length_; }
  /// One unknown's slopes over the share have one sign at both ends and another one in between.
  bool turns_twice(Index unknown) const;

private:
  Vector begin_, end_, chord_;
  double length_;
  Vector begin_slope_, end_slope_; ///< by the share
};

class Piece {
public:
  /// Both nodes have the same chart, and tangents that point forward.
  Piece(const ScaledProblem &problem, const Settings &settings, Node begin, Node end);
  /// From a graze into contact where the depth grows, otherwise out of contact to the graze.
  Piece(const ScaledProblem &problem, const Settings &settings, Node begin, Node end,
        const ContactPath &contact);

  const Node &begin() const { return begin_; }
  const Node &end() const { return end_; }
  double length() const { return path_.length(); }
  /// NumericalError where Newton's method fails. `way`: 0 at the beginning, 1 at the end; in parts
  /// of the chord, or of the root of the depth.
  Node at(double way) const;
  /// The key turns twice although its slope has one sign at both ends, by the cubic through both.
  bool key_turns_twice() const;
  /// The zero of a test of opposite signs at the ends; none where the sign changes by a jump.
  std::optional<Node> zero_of(const std::function<double(const Node &)> &test) const;

private:
  Node on_chord(double way) const;
  Node in_contact(double way) const;

  const ScaledProblem &problem_;
  const Settings &settings_;
  Node begin_, end_;
  Hermite path_;
  std::optional<ContactPath> contact_;
};

} // namespace vibroimpact::continuation
