// Maps that are affine while a guard is above zero, and get an impulse below.
#pragma once

#include "algebraic.h"

namespace vibroimpact::continuation {

/// P(x, p) = A x + B p + c f(d) with the depth d = max(0, -g), g = a.x + b.p + g0, and one of
///     corner: f = d,   smooth: f = d^(3/2),   square root: f = sqrt d.
class PiecewiseMap : public Problem {
public:
  Matrix by_state, by_keys; ///< A, B
  Vector impulse;           ///< c
  RowVector guard_by_state, guard_by_keys;
  double guard_constant = 0;
  Touch touch = Touch::corner;

  Vector scales() const override { return Vector::Ones(impulse.size() + by_keys.cols()); }
  double guard(const Point &at) const {
    return guard_by_state.dot(at.state) + guard_by_keys.dot(at.keys) + guard_constant;
  }
  Evaluation evaluate(const Point &at) override {
    Evaluation result = extend(at, {}).smooth;
    const double depth = -guard(at);
    if (depth <= 0)
      return result;
    const double exponent = touch == Touch::corner ? 1 : touch == Touch::smooth ? 1.5 : 0.5;
    const double slope = exponent * std::pow(depth, exponent - 1);
    result.residual += impulse * std::pow(depth, exponent);
    result.by_state -= impulse * slope * guard_by_state;
    result.by_keys -= impulse * slope * guard_by_keys;
    result.pattern = {1};
    return result;
  }
  std::vector<Graze> grazes_near(const Point &) override {
    std::vector<Graze> grazes;
    if (offers_extension)
      grazes.push_back({.name = "the stop"});
    return grazes;
  }
  Extension extend(const Point &at, const Graze &) override {
    Extension result;
    const Index n = at.state.size();
    result.smooth.by_state = by_state - Matrix::Identity(n, n);
    result.smooth.by_keys = by_keys;
    result.smooth.residual = result.smooth.by_state * at.state + by_keys * at.keys;
    result.smooth.pattern = {0};
    result.value = guard(at);
    result.by_state = guard_by_state;
    result.by_keys = guard_by_keys;
    result.touch = touch;
    if (touch == Touch::corner && tells_jump)
      result.jump = -impulse;
    return result;
  }

  bool offers_extension = true, tells_jump = true;
};

/// x -> p + a x + c f(x): the guard is -x.
inline PiecewiseMap scalar_map(double a, double c, Touch touch) {
  PiecewiseMap map;
  map.by_state = vector({a});
  map.by_keys = vector({1});
  map.impulse = vector({c});
  map.guard_by_state = RowVector::Constant(1, -1);
  map.guard_by_keys = RowVector::Zero(1);
  map.touch = touch;
  return map;
}

} // namespace vibroimpact::continuation
