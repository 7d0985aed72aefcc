#include "fold_by_hand.h"

#include "common/error.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::benchmarks {

namespace {

namespace odeint = boost::numeric::odeint;

constexpr double zeta0 = 0.01, zeta1 = 0.2, force = 0.52;
constexpr double event_tolerance = 1e-12; // [1], of an instant

/// y, v and their derivatives by y_0, v_0, lambda, mu.
using State = std::array<double, 10>;

struct Equations {
  double lambda = 1, mu = 1;
  int side = 0; ///< 1: at the right stop, -1: at the left one, 0: open

  void operator()(const State &x, State &rate, double t) const {
    const bool touching = side != 0;
    const double stiffness = touching ? 1 + mu : 1, damping = 2 * (zeta0 + (touching ? zeta1 : 0));
    rate[0] = x[1];
    rate[1] = force * std::sin(lambda * t) - damping * x[1] - stiffness * x[0] + mu * side;
    for (std::size_t j = 0; j < 4; ++j) {
      rate[2 + 2 * j] = x[3 + 2 * j];
      rate[3 + 2 * j] = -damping * x[3 + 2 * j] - stiffness * x[2 + 2 * j];
    }
    rate[7] += force * t * std::cos(lambda * t);
    if (touching)
      rate[9] -= x[0] - side;
  }
  // > 0 while the present phase holds.
  double guard(const State &x) const { return side == 0 ? 1 - std::abs(x[0]) : side * x[0] - 1; }
  // The velocity goes on, its rate jumps by that of the dashpot: over the time -dy / v by which the
  // change comes later.
  void pass(State &x) {
    const double sign = side == 0 ? -1 : 1;
    side = side == 0 ? (x[0] > 0 ? 1 : -1) : 0;
    for (std::size_t j = 0; j < 4; ++j)
      x[3 + 2 * j] += sign * 2 * zeta1 * x[2 + 2 * j];
  }
};

/// Half a period of the forcing, its end turned round by the symmetry, with derivatives.
struct HalfMap {
  Eigen::Vector2d image;
  Eigen::Matrix<double, 2, 4> slope; ///< by y_0, v_0, lambda, mu
};

HalfMap half_map(const Eigen::Vector4d &u, double tolerance) {
  Equations equations{.lambda = u[2], .mu = u[3]};
  State x{u[0], u[1], 1, 0, 0, 1, 0, 0, 0, 0};
  if (equations.guard(x) < 0)
    equations.side = x[0] > 0 ? 1 : -1;
  const double end = std::numbers::pi / u[2];
  auto stepper =
      odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<State>());
  stepper.initialize(x, 0, 0.05);
  while (stepper.current_time() < end) {
    if (stepper.current_time() + stepper.current_time_step() > end)
      stepper.initialize(stepper.current_state(), stepper.current_time(),
                         end - stepper.current_time());
    stepper.do_step(std::cref(equations));
    if (equations.guard(stepper.current_state()) >= 0)
      continue;
    double low = stepper.previous_time(), high = stepper.current_time();
    while (high - low > event_tolerance) {
      const double middle = (low + high) / 2;
      stepper.calc_state(middle, x);
      (equations.guard(x) < 0 ? high : low) = middle;
    }
    stepper.calc_state(high, x);
    const double step = stepper.current_time_step();
    equations.pass(x);
    stepper.initialize(x, high, step);
  }
  x = stepper.current_state();
  State rate;
  equations(x, rate, end);
  HalfMap map{.image = {-x[0], -x[1]}, .slope = {}};
  for (std::size_t j = 0; j < 4; ++j)
    map.slope.col(static_cast<Index>(j)) << -x[2 + 2 * j], -x[3 + 2 * j];
  // The end comes at pi / lambda.
  map.slope.col(2) += Eigen::Vector2d(rate[0], rate[1]) * (std::numbers::pi / (u[2] * u[2]));
  return map;
}

struct Bordered {
  Eigen::Vector2d v, w;
  double g = 0;
};

Bordered solve(const Eigen::Matrix2d &matrix, const Eigen::Vector2d &b, const Eigen::Vector2d &c) {
  Eigen::Matrix3d bordered;
  bordered << matrix, b, c.transpose(), 0;
  const Eigen::PartialPivLU<Eigen::Matrix3d> lu(bordered);
  const Eigen::Vector3d vg = lu.solve(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d wg = lu.transpose().solve(Eigen::Vector3d::UnitZ());
  return {.v = vg.head<2>(), .w = wg.head<2>(), .g = vg[2]};
}

class FoldWalk {
public:
  FoldWalk(const FoldPoint &start, double tolerance) : tolerance_(tolerance) {
    u_ << start.state, start.frequency, start.stiffness;
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(shifted(half_map(u_, tolerance_)),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    b_ = svd.matrixU().col(1);
    c_ = svd.matrixV().col(1);
    tangent_ = -Eigen::Vector4d::UnitW();
    correct(u_);
  }

  FoldPoint point() const { return {u_.head<2>(), u_[2], u_[3]}; }
  void step(double distance) { correct(u_ + distance * tangent_); }

private:
  static Eigen::Matrix2d shifted(const HalfMap &map) {
    return map.slope.leftCols<2>() - Eigen::Matrix2d::Identity();
  }

  // F = 0, g = 0 and the hyperplane through the guess; g_u = -w^T dJ v by two maps.
  void correct(const Eigen::Vector4d &guess) {
    constexpr double h = 1e-5;
    constexpr int most = 8;
    Eigen::Vector4d u = guess;
    for (int iteration = 0; iteration < most; ++iteration) {
      const HalfMap map = half_map(u, tolerance_);
      const Bordered bordered = solve(shifted(map), b_, c_);
      Eigen::Vector4d along = Eigen::Vector4d::Zero();
      along.head<2>() = bordered.v.normalized();
      const Eigen::RowVector4d gradient =
          -bordered.w.transpose() *
          (half_map(u + h * along, tolerance_).slope - half_map(u - h * along, tolerance_).slope) *
          (bordered.v.norm() / (2 * h));
      Eigen::Matrix<double, 3, 4> slope;
      slope << map.slope, gradient;
      slope(0, 0) -= 1;
      slope(1, 1) -= 1;
      Eigen::Matrix4d square;
      square << slope, tangent_.transpose();
      Eigen::Vector4d residual;
      residual << map.image - u.head<2>(), bordered.g, tangent_.dot(u - guess);
      const Eigen::PartialPivLU<Eigen::Matrix4d> lu(square);
      const Eigen::Vector4d correction = lu.solve(-residual);
      u += correction;
      if (correction.norm() > 10 * tolerance_)
        continue;
      u_ = u;
      tangent_ = lu.solve(Eigen::Vector4d::UnitW()).normalized();
      b_ = bordered.w.normalized();
      c_ = bordered.v.normalized();
      return;
    }
    throw NumericalError("Newton's method with odeint has not come to an end");
  }

  double tolerance_;
  Eigen::Vector4d u_, tangent_;
  Eigen::Vector2d b_, c_;
};

} // namespace

std::vector<FoldPoint> folds_by_hand(const FoldPoint &start, int count, double distance,
                                     double tolerance) {
  FoldWalk walk(start, tolerance);
  std::vector<FoldPoint> points{walk.point()};
  while (static_cast<int>(points.size()) < count) {
    walk.step(distance);
    points.push_back(walk.point());
  }
  return points;
}

} // namespace vibroimpact::benchmarks
