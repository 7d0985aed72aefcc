#include "periodic/touching.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using contact::ContactLaw;
using contact::Friction;
using contact::LocalState;
using contact::Mode;
using continuation::Touch;

namespace {

constexpr double same_force = 1e-6; // relative

double friction_force(const ContactLaw &law, int mode, const LocalState &state) {
  contact::LawResponse response;
  law.evaluate(mode, state, response);
  return response.tangential[0].force;
}

} // namespace

Touching::Touching(const GuardAtInstant &at)
    : at_{at}, law_{*at.pair().law}, from_{law_.modes()[at.mode()]},
      to_{law_.modes()[static_cast<std::size_t>(at.guard().target)]} {
  if (!from_.in_contact) {
    touch_of_contact();
  } else if (from_.friction == Friction::slip && to_.friction == Friction::stick) {
    touch_of_slip();
  } else if (from_.friction == Friction::stick && to_.friction == Friction::slip) {
    kind_ = GrazeKind::adding_sliding;
    if (from_.holds_slip && !slips_without_jump(law_, at_.guard(), at_.local()))
      touch_ = Touch::one_sided;
  }
}

void Touching::touch_of_contact() {
  if (law_.rigid())
    touch_ = Touch::square_root;
  else if (dashpot() != 0 && lets_go())
    touch_ = Touch::corner;
}

// A spring before the slider moves takes up what would be slip.
void Touching::touch_of_slip() {
  kind_ = GrazeKind::grazing_sliding;
  if (to_.holds_slip)
    touch_ = sticks_on() ? Touch::one_sided : Touch::corner;
}

bool Touching::slips_without_jump(const ContactLaw &law, const contact::Guard &limit,
                                  LocalState held) {
  double &force = held.tangential[0].force;
  force -= limit.indicator(held) / limit.indicator.tangential[0].force;
  return std::abs(friction_force(law, limit.target, held) - force) <= same_force * std::abs(force);
}

// There is no slip acceleration: the force that holds the sides is that of slip.
bool Touching::sticks_on() const {
  LocalState held = at_.local();
  held.tangential[0].force = friction_force(law_, static_cast<int>(at_.mode()), held);
  const double size = std::abs(held.tangential[0].force);
  return std::none_of(to_.guards.begin(), to_.guards.end(), [&](const contact::Guard &guard) {
    return guard.target == static_cast<int>(at_.mode()) &&
           guard.indicator(held) <= same_force * size;
  });
}

// -dF/d(gap rate) just behind the touch.
double Touching::dashpot() const {
  contact::LawResponse response;
  law_.evaluate(at_.guard().target, at_.local(), response);
  return -response.force_by_gap_rate;
}

// A guard ends the contact as soon as the sides part.
bool Touching::lets_go() const {
  LocalState parting = at_.local();
  parting.gap_rate += 1;
  return std::any_of(to_.guards.begin(), to_.guards.end(), [&](const contact::Guard &guard) {
    return guard.indicator(parting) < guard.indicator(at_.local());
  });
}

Vector Touching::jump() const {
  if (kind_ == GrazeKind::grazing_sliding && touch_ != Touch::smooth)
    return stop();
  return touch_ == Touch::corner ? impulse() : Vector();
}

// Of the dashpot on the way in.
Vector Touching::impulse() const {
  const motion::StateLayout &layout = at_.equations().layout();
  Vector jump = Vector::Zero(layout.physical_size());
  const RowVector row = at_.equations().row_along(at_.contact(), 0, at_.time(), at_.state());
  const Matrix response = at_.equations().response_to(Matrix(row), at_.time(), at_.state());
  jump.segment(layout.velocity(), layout.n) = -dashpot() * response.col(0);
  const std::vector<contact::AffineForm> &reset = at_.guard().reset;
  for (std::size_t i = 0; i < reset.size() && at_.form().gap != 0; ++i)
    jump[layout.internal() + at_.pair().internal_offset + static_cast<Index>(i)] =
        reset[i].gap / at_.form().gap;
  return jump;
}

// The slip rate is taken off, beside what else is held.
Vector Touching::stop() const {
  motion::Equations equations = at_.equations();
  equations.set_mode(at_.contact(), at_.guard().target);
  const motion::ActiveConstraints &holding = equations.holding();
  Vector rates = Vector::Zero(holding.size());
  rates[holding.place(at_.contact(), 1)] = 1 / at_.form().tangential[0].rate;
  const motion::StateLayout &layout = equations.layout();
  Vector jump = Vector::Zero(layout.physical_size());
  jump.segment(layout.velocity(), layout.n) = -holding.response() * holding.forces(rates);
  return jump;
}

} // namespace vibroimpact::periodic
