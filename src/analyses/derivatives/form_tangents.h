// How quantities of a motion change with a key at a fixed time, and along the motion.
//
// A quantity that is linear in the motion, m = r y + c (tangent_point.h), changes by
//
//   dm/dp = r dy/dp + dr/dp y + dc/dp,     m' = r y'
//
// where dr/dp and dc/dp follow from the rows of systems at neighbouring values of the key, as they
// do for the model (motion::KeyTangent). The force of a law that is not linear is F(g, g', z; p):
//
//   dF/dp = F_g dg/dp + F_g' dg'/dp + F_z dz/dp + F_p,     F_p at a fixed local state
//
// so that its slope where contact begins is that of the law, on whichever side a neighbour lies.
#pragma once

#include "analyses/derivatives/tangent_point.h"
#include "analyses/recorders/observables.h"

#include <functional>
#include <vector>

namespace vibroimpact::analyses {

/// Value, derivative by the key at a fixed time, derivative by time. NaN: not known in closed form.
struct Tangent {
  double value = 0, change = 0, rate = 0;

  /// Of the value where the instant itself moves by dt/dp.
  double with(double delay) const { return change + (rate == 0 ? 0 : rate * delay); }
};

/// Of a quantity where the motion stands.
using TangentOf = std::function<Tangent(const TangentPoint &)>;

/// A form in the present modes of the equations, of the system (0) or one of its neighbours (1...).
using FormMaker =
    std::function<motion::LinearForm(std::size_t system, const motion::Equations &equations)>;

/// An affine form of the local state of a contact, by its law.
using FormOfLaw = std::function<contact::AffineForm(const contact::ContactLaw &law)>;

class FormTangents {
public:
  /// Keeps copies of the neighbours and a reference to the system.
  FormTangents(const System &system, const std::vector<motion::KeyNeighbour> &neighbours);

  /// Of what is linear in the motion, and of forces of contacts. Refers to the forms.
  TangentOf of(const Observable &observed);
  Tangent gap(std::size_t contact, const TangentPoint &at);
  Tangent gap_rate(std::size_t contact, const TangentPoint &at);
  /// Normal force in the present mode. NaN where a gap is held in a phase that is not linear.
  Tangent force(std::size_t contact, const TangentPoint &at);
  /// dt/dp of an event from the point just before it, dt = -(dg/dp) / g' of its guard.
  double delay(const motion::ContactEvent &event, const TangentPoint &before);
  /// d(impulses)/dp of the contacts of a collision from the jump of the velocities and its
  /// derivative, M dv = W^T i.
  Vector impulses(const motion::Collision &collision, const Vector &jump,
                  const Vector &change_of_jump) const;

private:
  struct Near {
    System system;
    motion::Equations equations;
    std::vector<Observable> observables;
    double weight = 0;
    Near(System of, double weight)
        : system(std::move(of)), equations(system.model, system.contacts),
          observables(analyses::observables({}, system)), weight(weight) {}
  };
  Tangent linear(const FormMaker &make, const TangentPoint &at);
  Tangent contact_form(std::size_t contact, const FormOfLaw &form, const TangentPoint &at);
  Tangent nonlinear_force(std::size_t contact, const TangentPoint &at);

  const System &system_;
  std::vector<std::unique_ptr<Near>> near_;
};

} // namespace vibroimpact::analyses
