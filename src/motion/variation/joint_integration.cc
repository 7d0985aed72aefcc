#include "motion/variation/joint_integration.h"

#include "common/error.h"
#include "motion/variation/implicit_integration.h"
#include "motion/variation/observable_columns.h"
#include "motion/variation/vanishing_gap.h"

#include <Eigen/LU>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace vibroimpact::motion {

namespace {

namespace odeint = boost::numeric::odeint;
// Its order follows the tolerance. Not one of Fehlberg's pairs: their error estimates vanish where
// the rates depend on time alone, as they nearly do where a stiffness grows with the root of a
// short penetration.
using Extrapolation = odeint::bulirsch_stoer<std::vector<double>>;

// Times the fastest decay: longer, and an explicit method takes its steps by stability.
constexpr double stiff_length = 30;
// The same, over which deviations may grow on the way back from the end.
constexpr double length_of_return = 2;
// A step that takes more evaluations of the rates finds no end.
constexpr long most_evaluations = 300000;
// As one list of numbers, for the explicit method: the change of the state, the columns, and the
// integral of the divergence.
class ExplicitRates {
public:
  explicit ExplicitRates(JointRates &rates) : rates_(rates) {}

  std::vector<double> list(const Matrix &packed) const {
    const Index n = rates_.n_states();
    std::vector<double> x(static_cast<std::size_t>(n * (packed.cols() + 1) + 1), 0.0);
    Eigen::Map<Matrix>(x.data() + n, n, packed.cols()) = packed;
    return x;
  }
  Matrix packed(const std::vector<double> &x) const {
    const Index n = rates_.n_states();
    return Eigen::Map<const Matrix>(x.data() + n, n, rates_.n_columns());
  }

  void operator()(const std::vector<double> &x, std::vector<double> &dxds, double s) {
    if (++evaluations_ > most_evaluations)
      throw NumericalError("the variation of the motion takes too many steps at t = " +
                           std::to_string(rates_.start()) + " s");
    const Index n = rates_.n_states();
    Eigen::Map<Matrix> columns(dxds.data() + n, n, rates_.n_columns());
    dxds.back() =
        rates_.evaluate(s, ConstVectorView(x.data(), n), value_,
                        Eigen::Map<const Matrix>(x.data() + n, n, rates_.n_columns()), columns);
    Eigen::Map<Vector>(dxds.data(), n) = value_.state;
    columns.rightCols(value_.keys.cols()) += value_.keys;
  }

private:
  JointRates &rates_;
  JointRates::Value value_;
  long evaluations_ = 0;
};

// The instant about which a gap vanishes, where that is within the duration before `time` (or after
// it, for a negative one): the nearest one.
std::optional<double> zero_of_gap(const Equations &equations, double time, const Vector &state,
                                  double duration) {
  double nearest = std::abs(duration);
  bool found = false;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.inactive(c) || equations.mode(c).affine || equations.mode(c).holds_gap)
      continue;
    const contact::LocalState local =
        equations.local_state(c, time, ConstVectorView(state.data(), state.size()));
    const double elapsed = local.gap / local.gap_rate;
    if (std::isfinite(elapsed) && std::copysign(elapsed, duration) == elapsed &&
        std::abs(elapsed) <= nearest) {
      nearest = std::abs(elapsed);
      found = true;
    }
  }
  if (!found)
    return std::nullopt;
  return time - std::copysign(nearest, duration);
}

struct Joint {
  const Equations &equations;
  const std::vector<KeyTangent *> &keys;
  const VariationAccuracy &accuracy;
  LinearFlow *free = nullptr;
};

double integrate_explicitly(const Joint &joint, const Interval &interval, double radius,
                            JointRates &rates, Matrix &packed) {
  ExplicitRates explicit_rates(rates);
  std::vector<double> x = explicit_rates.list(packed);
  const double first_step = 1 / std::max(1.0, radius * std::abs(interval.length()));
  try {
    odeint::integrate_adaptive(Extrapolation(joint.accuracy.tolerance, joint.accuracy.tolerance),
                               std::ref(explicit_rates), x, 0.0, 1.0, first_step);
  } catch (const odeint::odeint_error &) {
    throw NumericalError("the variation of the motion finds no step at t = " +
                         std::to_string(interval.start) + " s");
  }
  packed = explicit_rates.packed(x);
  return x.back();
}

double integrate_all(const Joint &joint, const Interval &interval, const Vector &end_state,
                     const RateScales &scales, Matrix &columns) {
  JointRates rates(interval, end_state, joint.equations, joint.keys, joint.accuracy.scale, columns);
  Matrix packed = rates.pack(columns);
  const double divergence =
      scales.decay * interval.length() > stiff_length
          ? integrate_implicitly(rates, joint.accuracy.tolerance, packed)
          : integrate_explicitly(joint, interval, scales.radius, rates, packed);
  columns = rates.unpack(packed);
  return divergence;
}

// The last columns belong to the keys.
double integrate(const Joint &joint, const Interval &interval, const Vector &end_state,
                 const RateScales &scales, Matrix &columns) {
  const auto n_keys = static_cast<Index>(joint.keys.size());
  const Index n = columns.cols() - n_keys;
  std::optional<ObservableColumns> split;
  if (joint.free && scales.decay * std::abs(interval.length()) <= stiff_length)
    split = observable_columns(joint.equations, *joint.free, joint.accuracy.scale,
                               interval.length(), columns.leftCols(n));
  if (!split)
    return integrate_all(joint, interval, end_state, scales, columns);
  const Index k = split->basis.cols();
  Matrix observed(columns.rows(), k + n_keys);
  observed << split->basis, columns.rightCols(n_keys);
  const double divergence = integrate_all(joint, interval, end_state, scales, observed);
  columns.leftCols(n) = observed.leftCols(k) * split->coefficients + split->rest;
  columns.rightCols(n_keys) = observed.rightCols(n_keys);
  return divergence;
}

// From the end to the start: d(start) = P d(end) + g, solved for d(end).
double integrate_from_end(const Joint &joint, const Interval &reversed, const Vector &start_state,
                          const RateScales &scales, Matrix &columns) {
  const Vector &scale = joint.accuracy.scale;
  const Index n = scale.size();
  const auto n_keys = static_cast<Index>(joint.keys.size());
  Matrix back = Matrix::Zero(n, n + n_keys);
  back.leftCols(n).diagonal() = scale.cwiseInverse();
  const double divergence = integrate(joint, reversed, start_state, scales, back);
  columns.rightCols(n_keys) -= back.rightCols(n_keys);
  const Matrix scaled = scale.asDiagonal() * back.leftCols(n);
  columns = (scale.cwiseInverse().asDiagonal() *
             scaled.partialPivLu().solve(scale.asDiagonal() * columns))
                .eval();
  return -divergence;
}

// Where a gap vanishes at the end or soon after, the error of the state there is no small part of
// the gap, and a slope that grows beyond all bounds sees it: the last part is integrated from the
// end, whose gap is known.
double integrate_part(const Joint &joint, const Interval &interval, const Vector &end_state,
                      std::optional<double> zero_at_end, Matrix &columns) {
  const RateScales scales = rate_scales(interval, end_state, joint.equations, joint.accuracy.scale);
  if (!zero_at_end)
    return integrate(joint, interval, end_state, scales, columns);
  const double length = interval.length();
  const double last = std::min(0.5 * length, length_of_return / std::max(scales.decay, 1 / length));
  Interval first = interval;
  first.end = interval.end - last;
  const Interval second{
      .start = interval.end, .end = first.end, .state = end_state, .zero = zero_at_end};
  const double divergence = integrate(joint, first, end_state, scales, columns);
  return divergence + integrate_from_end(joint, second, interval.state, scales, columns);
}

} // namespace

double integrate_beside(const StepView &view, const Equations &equations,
                        const std::vector<KeyTangent *> &keys, const VariationAccuracy &accuracy,
                        LinearFlow *free, Matrix &columns) {
  const double h = view.length();
  std::optional<double> zero_at_end = zero_of_gap(equations, view.end(), view.end_state(), -h);
  Interval interval{.start = view.start(),
                    .end = view.end(),
                    .state = view.start_state(),
                    .zero = zero_of_gap(equations, view.start(), view.start_state(), h)};
  Vector end_state = view.end_state();
  double divergence = 0;
  const auto first = vanishing_gap(equations, view.start(), view.start_state(), h);
  if (first) {
    interval.start = first->duration < h ? view.start() + first->duration : view.end();
    const ShortInterval part{.contact = first->contact,
                             .zero = view.start(),
                             .other = interval.start,
                             .state_at_zero = view.start_state()};
    interval.state = state_at_other(equations, part);
    interval.zero = view.start();
    divergence += cross(equations, keys, part, columns);
  }
  const auto last = vanishing_gap(equations, view.end(), view.end_state(), h);
  const ShortInterval end_part{.contact = last ? last->contact : 0,
                               .zero = view.end(),
                               .other = last ? std::max(interval.start, view.end() - last->duration)
                                             : view.end(),
                               .state_at_zero = view.end_state()};
  if (last) {
    interval.end = end_part.other;
    end_state = state_at_other(equations, end_part);
    zero_at_end = view.end();
  }
  if (interval.end > interval.start)
    divergence += integrate_part({equations, keys, accuracy, free}, interval, end_state,
                                 zero_at_end, columns);
  if (last && view.end() > interval.end)
    divergence += cross(equations, keys, end_part, columns);
  return divergence;
}

} // namespace vibroimpact::motion
