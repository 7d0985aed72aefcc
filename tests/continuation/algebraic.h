// Problems in closed form for the tests of continuation.
#pragma once

#include "continuation/problem.h"

#include <functional>

namespace vibroimpact::continuation {

/// F(x, p) = 0 by a function.
class Algebraic : public Problem {
public:
  using Function = std::function<Evaluation(const Point &)>;
  Algebraic(Function function, Vector scales) : function_{std::move(function)}, scales_{scales} {}

  Vector scales() const override { return scales_; }
  Evaluation evaluate(const Point &point) override {
    ++evaluations;
    return function_(point);
  }
  bool is_map() const override { return false; }

  int evaluations = 0;

private:
  Function function_;
  Vector scales_;
};

/// P(x, p) with its derivatives.
struct Image {
  Vector value;
  Matrix by_state, by_keys;
};

/// P^m(x, p) - x.
class PowerOfMap : public Problem {
public:
  using Map = std::function<Image(const Vector &, const Vector &)>;
  PowerOfMap(Map map, Vector scales, int multiple = 1)
      : map_{std::move(map)}, scales_{scales}, multiple_{multiple} {}

  Vector scales() const override { return scales_; }
  Evaluation evaluate(const Point &point) override {
    const Image image = power(point, multiple_);
    const Index n = point.state.size();
    return {image.value - point.state, image.by_state - Matrix::Identity(n, n), image.by_keys, {}};
  }
  std::vector<ShorterReturn> shorter_returns(const Point &point) override {
    std::vector<ShorterReturn> returns;
    for (int divisor = 1; divisor < multiple_; ++divisor)
      if (multiple_ % divisor == 0)
        returns.push_back({divisor, power(point, divisor).value - point.state});
    return returns;
  }
  std::unique_ptr<Problem> doubled() override {
    return std::make_unique<PowerOfMap>(map_, scales_, 2 * multiple_);
  }

private:
  Image power(const Point &point, int exponent) const {
    const Index n = point.state.size();
    Image total{point.state, Matrix::Identity(n, n), Matrix::Zero(n, point.keys.size())};
    for (int i = 0; i < exponent; ++i) {
      const Image next = map_(total.value, point.keys);
      total.by_state = (next.by_state * total.by_state).eval();
      total.by_keys = (next.by_state * total.by_keys + next.by_keys).eval();
      total.value = next.value;
    }
    return total;
  }

  Map map_;
  Vector scales_;
  int multiple_;
};

inline Vector vector(std::initializer_list<double> values) {
  Vector result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.data());
  return result;
}

/// A scalar equation f = 0 with its slopes.
inline Evaluation scalar(double f, double by_state, double by_key) {
  return {vector({f}), vector({by_state}), vector({by_key}), {}};
}

/// x -> r x (1 - x)
inline Image logistic_map(const Vector &x, const Vector &r) {
  return {vector({r(0) * x(0) * (1 - x(0))}), vector({r(0) * (1 - 2 * x(0))}),
          vector({x(0) * (1 - x(0))})};
}

/// (x, y) -> (1 - a x^2 + y, b x), keys a and, if there are two, b; otherwise b = 0.3.
inline Image henon_map(const Vector &x, const Vector &keys) {
  const double a = keys(0), b = keys.size() > 1 ? keys(1) : 0.3;
  Image image{vector({1 - a * x(0) * x(0) + x(1), b * x(0)}), Matrix(2, 2),
              Matrix::Zero(2, keys.size())};
  image.by_state << -2 * a * x(0), 1, b, 0;
  image.by_keys(0, 0) = -x(0) * x(0);
  if (keys.size() > 1)
    image.by_keys(1, 1) = x(0);
  return image;
}

/// (x, y) -> (a x (1 - y), x)
inline Image delayed_logistic_map(const Vector &x, const Vector &a) {
  Image image{vector({a(0) * x(0) * (1 - x(1)), x(0)}), Matrix(2, 2), Matrix::Zero(2, a.size())};
  image.by_state << a(0) * (1 - x(1)), -a(0) * x(0), 1, 0;
  image.by_keys(0, 0) = x(0) * (1 - x(1));
  return image;
}

} // namespace vibroimpact::continuation
