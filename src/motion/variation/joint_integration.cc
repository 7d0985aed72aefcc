#include "motion/variation/joint_integration.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "motion/variation/implicit_integration.h"
#include "motion/variation/observable_columns.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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
// Of the model's own time scale: where a slope is infinite it still falls there.
constexpr double short_time = 1e-4;
// Of a part that begins or ends with a contact change: so far from it its gap may be found to
// vanish. A force with a fourth root of the penetration would keep 1e-4 of what it grows to.
constexpr double location_of_event = 1e-6;
// Of an instant at which a gap was found to vanish, relative to itself.
constexpr double rounding_of_time = 4 * std::numeric_limits<double>::epsilon();
// A step that takes more evaluations of the rates finds no end.
constexpr long most_evaluations = 300000;
// As one list of numbers, for the explicit method: the change of the state, the columns, and the
// integral of the divergence.
class ExplicitRates {
public:
  explicit ExplicitRates(JointRates &rates) : rates_(rates) {}

  std::vector<double> list(const Matrix &packed) const {
    const Index n = rates_.n_states();
    std::vector<double> x(static_cast<std::size_t>(n + packed.size() + 1), 0.0);
    Eigen::Map<Matrix>(x.data() + n, packed.rows(), packed.cols()) = packed;
    return x;
  }
  Matrix packed(const std::vector<double> &x) const {
    return Eigen::Map<const Matrix>(x.data() + rates_.n_states(), rates_.n_rows(),
                                    rates_.n_columns());
  }

  void operator()(const std::vector<double> &x, std::vector<double> &dxds, double s) {
    if (++evaluations_ > most_evaluations)
      throw NumericalError("the variation of the motion takes too many steps at t = " +
                           std::to_string(rates_.start()) + " s");
    const Index n = rates_.n_states();
    const Index rows = rates_.n_rows();
    Eigen::Map<Matrix> columns(dxds.data() + n, rows, rates_.n_columns());
    dxds.back() =
        rates_.evaluate(s, ConstVectorView(x.data(), n), value_,
                        Eigen::Map<const Matrix>(x.data() + n, rows, rates_.n_columns()), columns);
    Eigen::Map<Vector>(dxds.data(), n) = value_.state;
    columns.rightCols(value_.keys.cols()) += value_.keys;
  }

private:
  JointRates &rates_;
  JointRates::Value value_;
  long evaluations_ = 0;
};

// About the instant at which a gap vanishes.
struct ZeroOfGap {
  double instant = 0;
  std::optional<std::size_t> steep{}; ///< the contact, where the slope of its force is infinite
};

// Does the slope of the force fall without bounds as the gap grows from zero?
bool is_steep(const Equations &equations, std::size_t c, contact::LocalState local,
              double duration) {
  const auto slope_after = [&](double dt) {
    contact::LawResponse response;
    local.gap = -std::abs(local.gap_rate) * dt;
    equations.contacts().pairs()[c].law->evaluate(equations.modes()[c], local, response);
    return std::abs(response.force_by_gap);
  };
  const double dt =
      std::min(duration, short_time / std::max(equations.model().highest_frequency(), 1.0));
  return slope_after(dt / 4) > 1.2 * slope_after(dt);
}

// Within the duration before `time` (or after it, for a negative one): the nearest one.
std::optional<ZeroOfGap> zero_of_gap(const Equations &equations, double time, const Vector &state,
                                     double duration, bool at_event) {
  const double same = std::max(rounding_of_time * std::abs(time),
                               at_event ? location_of_event * std::abs(duration) : 0);
  double nearest = std::abs(duration);
  std::optional<ZeroOfGap> found;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.inactive(c) || equations.mode(c).affine || equations.mode(c).holds_gap)
      continue;
    const contact::LocalState local =
        equations.local_state(c, time, ConstVectorView(state.data(), state.size()));
    double elapsed = local.gap / local.gap_rate;
    if (std::abs(local.gap) <= equations.rounding(c, {.gap = 1}, time, state) ||
        std::abs(elapsed) <= same)
      elapsed = std::copysign(0.0, duration);
    if (!std::isfinite(elapsed) || std::copysign(elapsed, duration) != elapsed ||
        std::abs(elapsed) > nearest)
      continue;
    nearest = std::abs(elapsed);
    found = {.instant = time - elapsed, .steep = {}};
    if (is_steep(equations, c, local, std::abs(duration)))
      found->steep = c;
  }
  return found;
}

struct Joint {
  const Equations &equations;
  const std::vector<KeyTangent *> &keys;
  const VariationAccuracy &accuracy;
  LinearFlow *free = nullptr;
};

struct Integrated {
  double divergence = 0;
  Vector end_state; ///< with the work integrals of the start
};

Integrated integrate_all(const Joint &joint, const JointInterval &interval, double radius,
                         Matrix &columns) {
  JointRates rates(interval, joint.equations, joint.keys, joint.accuracy.scale, columns);
  ExplicitRates explicit_rates(rates);
  std::vector<double> x = explicit_rates.list(rates.pack(columns));
  const double first_step = 1 / std::max(1.0, radius * std::abs(interval.length()));
  try {
    odeint::integrate_adaptive(Extrapolation(joint.accuracy.tolerance, joint.accuracy.tolerance),
                               std::ref(explicit_rates), x, 0.0, 1.0, first_step);
  } catch (const odeint::odeint_error &) {
    throw NumericalError("the variation of the motion finds no step at t = " +
                         std::to_string(interval.start) + " s");
  }
  columns = rates.unpack(explicit_rates.packed(x));
  return {.divergence = x.back(),
          .end_state = rates.state_after(ConstVectorView(x.data(), rates.n_states()))};
}

// The last columns belong to the keys.
Integrated integrate_explicitly(const Joint &joint, const JointInterval &interval, double radius,
                                Matrix &columns) {
  const auto n_keys = static_cast<Index>(joint.keys.size());
  const Index n = columns.cols() - n_keys;
  std::optional<ObservableColumns> split;
  if (joint.free)
    split = observable_columns(joint.equations, *joint.free, joint.accuracy.scale,
                               interval.length(), columns.leftCols(n));
  if (!split)
    return integrate_all(joint, interval, radius, columns);
  const Index k = split->basis.cols();
  Matrix observed(columns.rows(), k + n_keys);
  observed << split->basis, columns.rightCols(n_keys);
  Integrated integrated = integrate_all(joint, interval, radius, observed);
  columns.leftCols(n) = observed.leftCols(k) * split->coefficients + split->rest;
  columns.rightCols(n_keys) = observed.rightCols(n_keys);
  return integrated;
}

double integrate_stiff(const Joint &joint, const JointInterval &interval, Matrix &columns) {
  JointRates rates(interval, joint.equations, joint.keys, joint.accuracy.scale, columns);
  Matrix packed = rates.pack(columns);
  const double divergence = integrate_implicitly(rates, joint.accuracy.tolerance, packed);
  columns = rates.unpack(packed);
  return divergence;
}

// Where the slope of a force is infinite at the start, the first instants are taken explicitly.
double integrate(const Joint &joint, const JointInterval &interval, const RateScales &scales,
                 Matrix &columns) {
  if (scales.decay * interval.length() <= stiff_length)
    return integrate_explicitly(joint, interval, scales.radius, columns).divergence;
  if (!interval.steep)
    return integrate_stiff(joint, interval, columns);
  JointInterval first = interval;
  first.end = interval.start + stiff_length / scales.decay;
  Integrated begun = integrate_explicitly(joint, first, scales.radius, columns);
  JointInterval rest = interval;
  rest.start = first.end;
  rest.state = std::move(begun.end_state);
  rest.steep.reset();
  return begun.divergence + integrate_stiff(joint, rest, columns);
}

// From the end to the start: d(start) = P d(end) + g, solved for d(end).
double integrate_from_end(const Joint &joint, const JointInterval &reversed,
                          const RateScales &scales, Matrix &columns) {
  const Vector &scale = joint.accuracy.scale;
  const Index n = scale.size();
  const auto n_keys = static_cast<Index>(joint.keys.size());
  Matrix back = Matrix::Zero(n, n + n_keys);
  back.leftCols(n).diagonal() = scale.cwiseInverse();
  const double divergence = integrate(joint, reversed, scales, back);
  columns.rightCols(n_keys) -= back.rightCols(n_keys);
  const Matrix scaled = scale.asDiagonal() * back.leftCols(n);
  columns = (scale.cwiseInverse().asDiagonal() *
             LuFactors<Matrix>(scaled).solve(Matrix(scale.asDiagonal() * columns)))
                .eval();
  return -divergence;
}

// Where a gap vanishes at the end or soon after, the error of the state there is no small part of
// the gap, and a slope that grows beyond all bounds sees it: the last part is integrated from the
// end, whose gap is known.
double integrate_part(const Joint &joint, const JointInterval &interval,
                      const std::optional<ZeroOfGap> &zero_at_end, Matrix &columns) {
  const RateScales scales = rate_scales(interval, joint.equations, joint.accuracy.scale);
  if (!zero_at_end)
    return integrate(joint, interval, scales, columns);
  const double length = interval.length();
  const double last = std::min(0.5 * length, length_of_return / std::max(scales.decay, 1 / length));
  JointInterval first = interval;
  first.end = interval.end - last;
  const JointInterval second{.start = interval.end,
                             .end = first.end,
                             .state = interval.far_state,
                             .far = interval.start,
                             .far_state = interval.state,
                             .zero = zero_at_end->instant,
                             .steep = zero_at_end->steep};
  const double divergence = integrate(joint, first, scales, columns);
  return divergence + integrate_from_end(joint, second, scales, columns);
}

} // namespace

double integrate_beside(const SmoothPart &part, const Equations &equations,
                        const std::vector<KeyTangent *> &keys, const VariationAccuracy &accuracy,
                        LinearFlow *free, Matrix &columns) {
  const double h = part.length();
  JointInterval interval{.start = part.start,
                         .end = part.end,
                         .state = part.start_state,
                         .far = part.end,
                         .far_state = part.end_state};
  if (const auto zero = zero_of_gap(equations, part.start, part.start_state, h, part.from_event)) {
    interval.zero = zero->instant;
    interval.steep = zero->steep;
  }
  return integrate_part({equations, keys, accuracy, free}, interval,
                        zero_of_gap(equations, part.end, part.end_state, -h, part.to_event),
                        columns);
}

} // namespace vibroimpact::motion
