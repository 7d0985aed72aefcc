#include "continuation/contact_side.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

ContactSide::ContactSide(const ScaledProblem &problem, const LocatedGraze &graze,
                         const Settings &settings)
    : problem_{problem}, graze_{graze}, settings_{settings},
      steepness_{graze.at.gradient.norm()}, normal_{graze.at.gradient.transpose() / steepness_} {
  const Index m = normal_.size();
  across_ = orthonormalised(normal_, Basis::whole).basis.rightCols(m - 1);
}

double depth_at(const ScaledProblem &problem, const LocatedGraze &graze, const Vector &u) {
  return -problem.extend(u, graze.chart, graze.graze).value / graze.at.gradient.norm();
}

// Newton's method along the normal. The last correction is below rounding of the depth, or does not
// become smaller since the evaluations are no more exact.
ContactSide::OnSurface ContactSide::at_depth(double depth, Vector u) const {
  constexpr int most = 10;
  constexpr double done = 1e-10, stalled = 0.1, least_slope = 0.1;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most; ++i) {
    const LinearisedExtension at = problem_.extend(u, graze_.chart, graze_.graze);
    const double excess = at.value / steepness_ + depth;
    const double slope = at.gradient.dot(normal_) / steepness_;
    if (slope < least_slope)
      break;
    if (std::abs(excess) <= done * depth ||
        (std::abs(excess) <= stalled * depth && std::abs(excess) >= before / 2))
      return {std::move(u), at.gradient};
    u -= excess / slope * normal_;
    before = std::abs(excess);
  }
  throw NumericalError("the depth of the touch of " + graze_.graze.name + " cannot be set");
}

Node ContactSide::at(double y, const Vector &guess, double largest, Depth depth) const {
  OnSurface point;
  Linearisation at;
  const auto system = [&](const Vector &sideways) {
    point = at_depth(y * y, guess + across_ * sideways);
    at = problem_.evaluate(point.u, graze_.chart);
    // Along the surface of equal depth, du = (1 - n g_u / (g_u n)) dw.
    const Matrix along =
        across_ - normal_ * (point.gradient * across_) / point.gradient.dot(normal_);
    return SquareSystem{at.residual, at.slope * along};
  };
  const Converged converged =
      newton(system, Vector::Zero(across_.cols()), largest, settings_, Until::rounding);
  const Vector ahead = (depth == Depth::grows ? -1.0 : 1.0) * point.gradient.transpose();
  Node node = make_node(problem_, point.u, graze_.chart, std::move(at), ahead);
  node.iterations = converged.iterations;
  return node;
}

ContactPath::ContactPath(ContactSide side, const Node &far, double y, Depth depth, bool to_graze)
    : side_{std::move(side)}, depth_{depth}, y_{y} {
  constexpr double corrected = 0.5; // of the length, at most
  largest_ = corrected * (far.u - side_.graze().u).norm();
  slope_ = (far.u - side_.graze().u) / y_;
  curve_ = Vector::Zero(slope_.size());
  constexpr double near = 0.9;
  const Vector chord = slope_, inner = (at(near).u - side_.graze().u) / (near * y_);
  curve_ = (chord - inner) / ((1 - near) * y_);
  slope_ -= curve_ * y_;
  // At a root of 1e-5 rounding of unknowns of size one changes the depth by a millionth.
  constexpr double least_root = 1e-5;
  if (!to_graze)
    first_ = std::min(least_root / y_, 0.5);
}

Node ContactPath::at(double share) const {
  const double y = share * y_;
  return side_.at(y, side_.graze().u + y * (slope_ + y * curve_), largest_, depth_);
}

} // namespace vibroimpact::continuation
