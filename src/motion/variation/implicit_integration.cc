#include "motion/variation/implicit_integration.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "motion/variation/radau.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace vibroimpact::motion {

namespace {

constexpr int most_iterations = 15;
constexpr long most_steps = 20000;
constexpr double shortest_step = 1e-12; // of the whole

struct Outcome {
  Vector change;
  Matrix columns;
  double divergence = 0;
};

// A step of one method.
class Step {
public:
  Step(const RadauMethod &method, JointRates &rates) : method_(method), rates_(rates) {}

  // Nothing where Newton's method does not converge.
  std::optional<Outcome> operator()(double s, double h, const Vector &change,
                                    const Matrix &columns) {
    const Index n = rates_.n_states();
    Vector stages = change.replicate(method_.nodes.size(), 1);
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_iterations; ++i) {
      linearise(s, h, stages);
      const Vector move = lu_.solve(residual(h, change, stages));
      stages += move;
      const double size = move.cwiseAbs().maxCoeff();
      if (!std::isfinite(size) || (i > 3 && size > before))
        return std::nullopt;
      const double rounding = 1e-15 * std::max(1.0, stages.cwiseAbs().maxCoeff());
      if (size <= 8 * rounding || (size <= 1e-11 && size > 0.1 * before)) {
        linearise(s, h, stages);
        return Outcome{.change = stages.tail(n),
                       .columns = columns_at_end(h, columns),
                       .divergence = divergence(h)};
      }
      before = size;
    }
    return std::nullopt;
  }

private:
  void linearise(double s, double h, const Vector &stages) {
    const Index n = rates_.n_states();
    const Index count = method_.nodes.size();
    values_.resize(static_cast<std::size_t>(count));
    Matrix matrix = Matrix::Identity(n * count, n * count);
    for (Index j = 0; j < count; ++j) {
      JointRates::Value &value = values_[static_cast<std::size_t>(j)];
      rates_.evaluate(s + h * method_.nodes[j], ConstVectorView(stages.data() + j * n, n), value);
      for (Index i = 0; i < count; ++i)
        matrix.block(i * n, j * n, n, n) -= h * method_.coefficients(i, j) * value.jacobian;
    }
    lu_.compute(matrix);
  }

  Vector residual(double h, const Vector &change, const Vector &stages) const {
    const Index n = rates_.n_states();
    Vector residual(stages.size());
    for (Index i = 0; i < method_.nodes.size(); ++i) {
      auto own = residual.segment(i * n, n);
      own = change - stages.segment(i * n, n);
      for (Index j = 0; j < method_.nodes.size(); ++j)
        own += h * method_.coefficients(i, j) * values_[static_cast<std::size_t>(j)].state;
    }
    return residual;
  }

  Matrix columns_at_end(double h, const Matrix &columns) const {
    const Index n = rates_.n_states();
    const Index count = method_.nodes.size();
    Matrix right = columns.replicate(count, 1);
    for (Index i = 0; i < count; ++i)
      for (Index j = 0; j < count; ++j) {
        const Matrix &keys = values_[static_cast<std::size_t>(j)].keys;
        right.block(i * n, columns.cols() - keys.cols(), n, keys.cols()) +=
            h * method_.coefficients(i, j) * keys;
      }
    return lu_.solve(right).bottomRows(n);
  }

  double divergence(double h) const {
    double sum = 0;
    for (Index j = 0; j < method_.nodes.size(); ++j)
      sum += h * method_.coefficients(method_.nodes.size() - 1, j) *
             values_[static_cast<std::size_t>(j)].jacobian.trace();
    return sum;
  }

  const RadauMethod &method_;
  JointRates &rates_;
  std::vector<JointRates::Value> values_;
  LuFactors<Matrix> lu_;
};

// A bound of the norm, sqrt(|A|_1 |A|_inf).
double largest_row(const Matrix &matrix, const Vector &mass) {
  const Vector root = mass.cwiseSqrt().cwiseInverse();
  const Matrix size = (root.asDiagonal() * matrix * root.asDiagonal()).cwiseAbs();
  return std::sqrt(size.rowwise().sum().maxCoeff() * size.colwise().sum().maxCoeff());
}

// With M^(1/2) q as coordinates, eigenvalues z of linear bodies with contacts have
//   |z|^2 <= |z| |C| + |K|,   |z| <= (|C| + sqrt(|C|^2 + 4 |K|)) / 2,
// where a contact adds at most its slopes times w M^-1 w^T, w its gap row, to the norms. Infinite
// where this does not hold: internal states with rates, gaps that are held, other models.
double bound_of_eigenvalues(const Equations &equations, double time, const Vector &state) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const model::Model &model = equations.model();
  if (!model.linear() || !equations.holding().empty())
    return none;
  double stiffness = largest_row(model.stiffness().dense(), model.mass());
  double damping = largest_row(model.damping().dense(), model.mass());
  contact::LawResponse response;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.inactive(c))
      continue;
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    pair.law->evaluate(equations.modes()[c],
                       equations.local_state(c, time, ConstVectorView(state.data(), state.size())),
                       response);
    for (const std::vector<double> *rates :
         {&response.internal_rate_by_gap, &response.internal_rate_by_gap_rate,
          &response.internal_rate_by_internal})
      if (std::any_of(rates->begin(), rates->end(), [](double rate) { return rate != 0; }))
        return none;
    const double mobility = 1 / equations.contacts().effective_mass(c, model);
    stiffness += std::abs(response.force_by_gap) * mobility;
    damping += std::abs(response.force_by_gap_rate) * mobility;
  }
  const double bound = (damping + std::sqrt(damping * damping + 4 * stiffness)) / 2;
  return std::isfinite(bound) ? bound : none;
}

// Where all is slow a bound is enough.
RateScales scales_at(const Equations &equations, double time, const Vector &state,
                     const Vector &scale, double slow) {
  if (const double bound = bound_of_eigenvalues(equations, time, state); bound < slow)
    return {.radius = bound, .decay = bound};
  Matrix jacobian;
  equations.jacobian(time, ConstVectorView(state.data(), state.size()), jacobian);
  const Index n = scale.size();
  const Matrix scaled =
      scale.asDiagonal() * jacobian.topLeftCorner(n, n) * scale.cwiseInverse().asDiagonal();
  if (!scaled.allFinite())
    return {.radius = slow, .decay = slow};
  const double bound = std::min(scaled.cwiseAbs().rowwise().sum().maxCoeff(),
                                scaled.cwiseAbs().colwise().sum().maxCoeff());
  if (bound < slow)
    return {.radius = bound, .decay = bound};
  const ComplexVector values = eigenvalues(scaled);
  return {.radius = values.cwiseAbs().maxCoeff(),
          .decay = std::max(0.0, -values.real().minCoeff())};
}

} // namespace

RateScales rate_scales(const JointInterval &interval, const Equations &equations,
                       const Vector &scale) {
  const double slow = 10 / std::abs(interval.length());
  const RateScales first = scales_at(equations, interval.start, interval.state, scale, slow);
  const RateScales last = scales_at(equations, interval.far, interval.far_state, scale, slow);
  return {.radius = std::min(first.radius, last.radius),
          .decay = std::min(first.decay, last.decay)};
}

double integrate_implicitly(JointRates &rates, double tolerance, Matrix &columns) {
  static const RadauMethod fine(7);
  static const RadauMethod coarse(5);
  Step fine_step(fine, rates);
  Step coarse_step(coarse, rates);
  Vector change = Vector::Zero(rates.n_states());
  double divergence = 0;
  double h = 1;
  double s = 0;
  for (long steps = 0; s < 1; ++steps) {
    if (!(h > shortest_step) || steps > most_steps)
      throw NumericalError("the variation of the motion finds no step at t = " +
                           std::to_string(rates.start()) + " s");
    const bool last = s + h >= 1 - 1e-13;
    const double length = last ? 1 - s : h;
    const auto end = fine_step(s, length, change, columns);
    const auto compared = end ? coarse_step(s, length, change, columns) : std::nullopt;
    double error = std::numeric_limits<double>::infinity();
    if (compared) {
      const double size = std::max(1.0, end->columns.cwiseAbs().maxCoeff());
      error = std::max((end->change - compared->change).cwiseAbs().maxCoeff(),
                       (end->columns - compared->columns).cwiseAbs().maxCoeff() / size) /
              tolerance;
    }
    // Of order 6 where rates are fast, of 10 where they are not.
    const double factor =
        std::isfinite(error) ? 0.9 * std::pow(std::max(error, 1e-9), -1.0 / 6) : 0.2;
    if (error <= 1) {
      change = end->change;
      columns = end->columns;
      divergence += end->divergence;
      s = last ? 1 : s + length;
    }
    h = length * std::clamp(factor, 0.1, 4.0);
  }
  return divergence;
}

} // namespace vibroimpact::motion
