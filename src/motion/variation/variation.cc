#include "motion/variation/variation.h"

#include "common/error.h"
#include "motion/segment/dense_state.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace vibroimpact::motion {

using contact::AffineForm;

namespace {

namespace odeint = boost::numeric::odeint;
// Not one of Fehlberg's pairs: their error estimates vanish where the rates depend on time alone,
// as they nearly do where a stiffness grows with the root of a short penetration.
using Stepper = odeint::runge_kutta_dopri5<std::vector<double>>;
using Checker =
    odeint::default_error_checker<double, Stepper::algebra_type, Stepper::operations_type>;
using Controlled = odeint::controlled_runge_kutta<Stepper>;

// d(scaled deviations)/d(tau) for odeint.
class LinearRates {
public:
  LinearRates(const StepView &view, const Equations &equations, const Vector &scale)
      : view_(view), equations_(equations), scale_(scale), motion_(view) {}

  void operator()(const std::vector<double> &x, std::vector<double> &dxdtau, double tau) {
    motion_.at(tau, state_);
    equations_.jacobian(view_.start() + tau * view_.length(),
                        ConstVectorView(state_.data(), state_.size()), jacobian_);
    const Index rows = scale_.size();
    const Index columns = static_cast<Index>(x.size()) / rows;
    const Eigen::Map<const Matrix> scaled(x.data(), rows, columns);
    Eigen::Map<Matrix> rates(dxdtau.data(), rows, columns);
    rates = view_.length() *
            (scale_.asDiagonal() * (jacobian_.topLeftCorner(rows, rows) *
                                    (scale_.cwiseInverse().asDiagonal() * scaled).eval()));
  }

private:
  const StepView &view_;
  const Equations &equations_;
  const Vector &scale_;
  DenseState motion_;
  Vector state_;
  Matrix jacobian_;
};

} // namespace

Variation::Variation(const Equations &equations, Vector scale, double tolerance)
    : equations_(equations), scale_(std::move(scale)), tolerance_(tolerance) {
  if (scale_.size() != equations.layout().physical_size())
    throw std::logic_error("a variation needs one scale for each physical state");
}

void Variation::set_columns(const Matrix &columns) { scaled_ = scale_.asDiagonal() * columns; }

Matrix Variation::columns() const { return scale_.cwiseInverse().asDiagonal() * scaled_; }

void Variation::step(const StepView &view) {
  const auto &modes = view.equations().modes();
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
  // Columns of equal size, so that one tolerance serves all. A reset can wipe a deviation out.
  RowVector sizes = scaled_.cwiseAbs().colwise().maxCoeff();
  sizes = (sizes.array() > 0).select(sizes, 1);
  const Matrix equal = scaled_ * sizes.cwiseInverse().asDiagonal();
  std::vector<double> x(equal.data(), equal.data() + equal.size());
  LinearRates rates(view, equations_, scale_);
  odeint::integrate_adaptive(Controlled(Checker(tolerance_, tolerance_)), std::ref(rates), x, 0.0,
                             1.0, 1.0);
  scaled_ = Eigen::Map<const Matrix>(x.data(), equal.rows(), equal.cols()) * sizes.asDiagonal();
  if (!scaled_.allFinite())
    throw NumericalError("the variation of the motion is no longer finite at t = " +
                         std::to_string(view.end()) + " s");
}

RowVector Variation::gradient(std::size_t contact, const AffineForm &form) const {
  const StateLayout &layout = equations_.layout();
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  RowVector gradient = RowVector::Zero(layout.physical_size());
  gradient.head(layout.n) = form.gap * pair.gap.row;
  gradient.segment(layout.velocity(), layout.n) = form.gap_rate * pair.gap.row;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    gradient[layout.internal() + pair.internal_offset + static_cast<Index>(i)] = form.internal[i];
  return gradient;
}

double Variation::rate_along(std::size_t contact, const AffineForm &form, const ContactEvent &event,
                             const Vector &rates) const {
  const StateLayout &layout = equations_.layout();
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  double rate = form.gap * event.gap_rate;
  if (form.gap_rate != 0)
    rate += form.gap_rate *
            equations_.gap_acceleration(
                contact, event.time, ConstVectorView(rates.data() + layout.velocity(), layout.n));
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    rate +=
        form.internal[i] * rates[layout.internal() + pair.internal_offset + static_cast<Index>(i)];
  return rate;
}

Vector Variation::rates(double time, const Vector &state) const {
  Vector rates(state.size());
  equations_.rates(time, ConstVectorView(state.data(), state.size()),
                   VectorView(rates.data(), rates.size()));
  return rates;
}

// Only internal states of the contact itself are reset.
void Variation::reset(const ContactEvent &event, const Vector &before, Matrix &deviations,
                      Vector &reset_rates) const {
  const Matrix old = deviations;
  const Index first =
      equations_.layout().internal() + equations_.contacts().pairs()[event.contact].internal_offset;
  for (std::size_t i = 0; i < event.guard->reset.size(); ++i) {
    const AffineForm &form = event.guard->reset[i];
    const Index row = first + static_cast<Index>(i);
    deviations.row(row) = gradient(event.contact, form) * old;
    reset_rates[row] = rate_along(event.contact, form, event, before);
  }
}

// The velocities alone are reset, by all contacts that take an impulse.
void Variation::collide(const ContactEvent &event) {
  if (!equations_.model().rotors().empty())
    throw NumericalError("the growth of deviations through rigid impacts is not known for models "
                         "with rotors, whose inertia changes with the position");
  const Collision &collision = *event.collision;
  const StateLayout &layout = equations_.layout();
  for (std::size_t c = 0; c < collision.modes_before.size(); ++c)
    equations_.set_mode(c, collision.modes_before[c]);
  const Vector before = rates(event.time, *event.before);
  Matrix deviations = columns();
  const RowVector guard = gradient(event.contact, event.guard->indicator) * deviations;
  const double guard_rate = rate_along(event.contact, event.guard->indicator, event, before);
  Vector accelerations(static_cast<Index>(collision.contacts.size()));
  for (Index k = 0; k < accelerations.size(); ++k)
    accelerations[k] =
        equations_.gap_acceleration(collision.contacts[static_cast<std::size_t>(k)], event.time,
                                    ConstVectorView(before.data() + layout.velocity(), layout.n));
  for (std::size_t c = 0; c < collision.modes_after.size(); ++c)
    equations_.set_mode(c, collision.modes_after[c]);
  Vector change = rates(event.time, *event.state) - before;
  if (!collision.contacts.empty()) {
    const Matrix impulses = collision.response * collision.impulse_by_rate;
    auto velocities = deviations.middleRows(layout.velocity(), layout.n);
    velocities += impulses * (collision.rows * velocities).eval();
    change.segment(layout.velocity(), layout.n) -= impulses * accelerations;
  }
  jump(change, deviations, guard, guard_rate);
  tangential_events_ += collision.unique ? 0 : 1;
}

// d+ = R_x d- + (f+ - R') (g_x d-) / g'; `deviations` is R_x d-, `change` f+ - R'.
void Variation::jump(const Vector &change, Matrix &deviations, const RowVector &guard,
                     double guard_rate) {
  if (guard_rate != 0)
    deviations += change.head(deviations.rows()) * (guard / guard_rate);
  else
    ++tangential_events_;
  set_columns(deviations);
}

// A collision of several contacts comes as several events, of which the first tells all.
void Variation::event(const ContactEvent &event) {
  if (event.guard->action == contact::GuardAction::impact) {
    if (event.collision)
      collide(event);
    return;
  }
  equations_.set_mode(event.contact, event.from);
  const Vector before = rates(event.time, *event.before);
  equations_.set_mode(event.contact, event.to);
  const Vector after = rates(event.time, *event.state);
  if (event.guard->indicator.normal_force != 0)
    return; // let go without force: nothing jumps

  Matrix deviations = columns();
  const RowVector guard = gradient(event.contact, event.guard->indicator) * deviations;
  const double guard_rate = rate_along(event.contact, event.guard->indicator, event, before);
  Vector reset_rates = before;
  reset(event, before, deviations, reset_rates);
  jump(after - reset_rates, deviations, guard, guard_rate);
}

} // namespace vibroimpact::motion
