#include "motion/variation/joint_integration.h"

#include "common/error.h"
#include "common/signals.h"
#include "motion/variation/vanishing_gap.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace vibroimpact::motion {

namespace {

namespace odeint = boost::numeric::odeint;
// Its order follows the tolerance. Not one of Fehlberg's pairs: their error estimates vanish where
// the rates depend on time alone, as they nearly do where a stiffness grows with the root of a
// short penetration.
using Extrapolation = odeint::bulirsch_stoer<std::vector<double>>;

// Of the state, relative to itself: what changes less is near equilibrium, and its rates are
// differences of larger terms.
constexpr double least_change = 1e-3;
// A step that takes more evaluations of the rates finds no end.
constexpr long most_evaluations = 300000;
// Rates by keys have the rounding of differences of models, of about 1e-12, which is no error that
// shorter steps would make smaller.
constexpr double key_weight = 0.01;

// tau(s) with dtau/ds = 140 s^3 (1 - s)^3: roots of the time since the start and until the end
// become smooth, so that the order of the method shows.
double smooth_course(double s) { return s * s * s * s * (35 + s * (-84 + s * (70 - 20 * s))); }
double smooth_rate(double s) { return 140 * s * s * s * (1 - s) * (1 - s) * (1 - s); }

struct Interval {
  double start = 0, end = 0; ///< [s]
  Vector state;              ///< at the start
  bool smooth = false;       ///< times close to the ends count more
  double length() const { return end - start; }
};

// Entries: the scaled change of the state since the start, in units of its size, so that a short
// contact is not lost in the rounding of the whole; the scaled columns in units of theirs; and the
// integral of the divergence.
class JointRates {
public:
  JointRates(const Interval &interval, const Vector &end_state, const Equations &equations,
             const std::vector<KeyTangent *> &keys, const Vector &scale, const Matrix &columns)
      : interval_(interval), equations_(equations), keys_(keys), scale_(scale),
        full_(interval.state), full_rates_(equations.layout().size()) {
    const Index n = scale.size();
    equations.rates(interval.start, ConstVectorView(full_.data(), full_.size()),
                    VectorView(full_rates_.data(), full_rates_.size()));
    const Vector change = (end_state - interval.state).head(n).cwiseAbs() +
                          interval.length() * full_rates_.head(n).cwiseAbs();
    state_size_ =
        std::max(scale.cwiseProduct(change).maxCoeff(),
                 least_change * scale.cwiseProduct(interval.state.head(n)).cwiseAbs().maxCoeff());
    state_size_ = state_size_ > 0 ? state_size_ : 1;
    sizes_ = (scale.asDiagonal() * columns).cwiseAbs().colwise().maxCoeff();
    for (std::size_t k = 0; k < keys.size(); ++k) {
      double &size = sizes_[columns.cols() - static_cast<Index>(keys.size() - k)];
      const Vector rates = keys[k]->rates(equations, interval.start, full_);
      size = std::max(size, interval.length() * scale.cwiseProduct(rates).cwiseAbs().maxCoeff()) /
             key_weight;
    }
    // A reset can wipe a deviation out.
    sizes_ = (sizes_.array() > 0).select(sizes_, 1);
  }

  std::vector<double> pack(const Matrix &columns) const {
    const Index n = scale_.size();
    std::vector<double> x(static_cast<std::size_t>(n * (columns.cols() + 1) + 1), 0.0);
    Eigen::Map<Matrix>(x.data() + n, n, columns.cols()) =
        scale_.asDiagonal() * columns * sizes_.cwiseInverse().asDiagonal();
    return x;
  }

  Matrix columns(const std::vector<double> &x) const {
    const Index n = scale_.size();
    return scale_.cwiseInverse().asDiagonal() *
           Eigen::Map<const Matrix>(x.data() + n, n, sizes_.size()) * sizes_.asDiagonal();
  }

  void operator()(const std::vector<double> &x, std::vector<double> &dxdtau, double s) {
    leave_if_stopped();
    if (++evaluations_ > most_evaluations)
      throw NumericalError("the variation of the motion takes too many steps at t = " +
                           std::to_string(interval_.start) + " s");
    const Index n = scale_.size();
    const double h = interval_.length() * (interval_.smooth ? smooth_rate(s) : 1);
    const double time =
        interval_.start + interval_.length() * (interval_.smooth ? smooth_course(s) : s);
    full_.head(n) =
        interval_.state.head(n) +
        state_size_ * scale_.cwiseInverse().cwiseProduct(Eigen::Map<const Vector>(x.data(), n));
    const ConstVectorView state(full_.data(), full_.size());
    equations_.rates(time, state, VectorView(full_rates_.data(), full_rates_.size()));
    equations_.jacobian(time, state, jacobian_);
    Eigen::Map<Vector>(dxdtau.data(), n) =
        h / state_size_ * scale_.cwiseProduct(full_rates_.head(n));
    const Eigen::Map<const Matrix> scaled(x.data() + n, n, sizes_.size());
    Eigen::Map<Matrix> rates(dxdtau.data() + n, n, sizes_.size());
    rates = h * (scale_.asDiagonal() * (jacobian_.topLeftCorner(n, n) *
                                        (scale_.cwiseInverse().asDiagonal() * scaled).eval()));
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      const Index column = sizes_.size() - static_cast<Index>(keys_.size() - k);
      rates.col(column) +=
          h / sizes_[column] * scale_.cwiseProduct(keys_[k]->rates(equations_, time, full_));
    }
    dxdtau.back() = h * jacobian_.topLeftCorner(n, n).trace();
  }

private:
  const Interval &interval_;
  const Equations &equations_;
  const std::vector<KeyTangent *> &keys_;
  const Vector &scale_;
  long evaluations_ = 0;
  double state_size_ = 1;
  RowVector sizes_; ///< of the columns
  Vector full_, full_rates_;
  Matrix jacobian_;
};

// Can a gap vanish within the duration from here, in either direction?
bool near_contact(const Equations &equations, double time, const Vector &state, double duration) {
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.inactive(c) || equations.mode(c).affine)
      continue;
    const contact::LocalState local =
        equations.local_state(c, time, ConstVectorView(state.data(), state.size()));
    if (std::abs(local.gap) <= std::abs(local.gap_rate) * duration)
      return true;
  }
  return false;
}

double integrate(const Interval &interval, const Vector &end_state, const Equations &equations,
                 const std::vector<KeyTangent *> &keys, const VariationAccuracy &accuracy,
                 Matrix &columns) {
  JointRates rates(interval, end_state, equations, keys, accuracy.scale, columns);
  std::vector<double> x = rates.pack(columns);
  try {
    odeint::integrate_adaptive(Extrapolation(accuracy.tolerance, accuracy.tolerance),
                               std::ref(rates), x, 0.0, 1.0, 1.0);
  } catch (const odeint::odeint_error &) {
    throw NumericalError("the variation of the motion finds no step at t = " +
                         std::to_string(interval.start) + " s");
  }
  columns = rates.columns(x);
  return x.back();
}

} // namespace

double integrate_beside(const StepView &view, const Equations &equations,
                        const std::vector<KeyTangent *> &keys, const VariationAccuracy &accuracy,
                        Matrix &columns) {
  const double h = view.length();
  Interval interval{.start = view.start(),
                    .end = view.end(),
                    .state = view.start_state(),
                    .smooth = near_contact(equations, view.start(), view.start_state(), h) ||
                              near_contact(equations, view.end(), view.end_state(), h)};
  double divergence = 0;
  const auto first = vanishing_gap(equations, view.start(), view.start_state(), h);
  if (first) {
    interval.start = first->duration < h ? view.start() + first->duration : view.end();
    const ShortInterval part{.contact = first->contact,
                             .zero = view.start(),
                             .other = interval.start,
                             .state_at_zero = view.start_state()};
    interval.state = state_at_other(equations, part);
    divergence += cross(equations, keys, part, columns);
  }
  const auto last = vanishing_gap(equations, view.end(), view.end_state(), h);
  if (last)
    interval.end = std::max(interval.start, view.end() - last->duration);
  if (interval.end > interval.start)
    divergence += integrate(interval, view.end_state(), equations, keys, accuracy, columns);
  if (last && view.end() > interval.end)
    divergence += cross(equations, keys,
                        {.contact = last->contact,
                         .zero = view.end(),
                         .other = interval.end,
                         .state_at_zero = view.end_state()},
                        columns);
  return divergence;
}

} // namespace vibroimpact::motion
