// A stop that crushes: a table for loading, a steeper line for unloading, and a residual
// penetration that stays.
//
//   loading     F = f(u), and p = u - f(u) / K grows     u  penetration [m]
//   between     F = K (u - p), elastic                   p  residual penetration [m]
//   unloading   F = g(u), and p = u - g(u) / K falls     K  unloading stiffness [N/m]
//
// Without an unloading curve g = 0: the sides part at u = p, the next contact begins there, and the
// stop goes on along its loading curve where an impact drives it deeper than all before. A free
// mass that reaches u_m leaves p = u_m - f(u_m) / K behind. With an unloading curve the stop comes
// back along it: one impact that loads up to u_m takes the area between the two curves and the line
// from one to the other. Where g is zero up to some penetration, that much stays.
//
// Stored energy: what the stop gives back when it is let go, the area below the way to zero;
// dissipated power (F - g(w)) p' on the loading curve, w the penetration where the line through the
// present place meets the unloading curve. Elsewhere nothing is dissipated. Rate-independent.
//
// p is an internal state of the law. Modes, within an interval of p in which both curves are
// straight:
//   open       apart, p stays
//   elastic    on the line, between the curves
//   loading    on the loading curve, left where the motion turns
//   falling    on the line as long as the rate has not turned again: there the loading curve would
//              be met by a double zero
//   unloading  on the unloading curve, left where the motion turns
//   rising     on the line, likewise
#pragma once

#include "contact/contact_law.h"
#include "contact/laws/crush_curves.h"

namespace vibroimpact::contact {

class CrushableTable : public ContactLaw {
public:
  explicit CrushableTable(CrushCurves curves);

  std::string name() const override { return "table"; }
  std::vector<InternalState> internal_states() const override;
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;

private:
  void evaluate_line(int mode, const LocalState &state, LawResponse &response) const;
  void evaluate_curve(int mode, const LocalState &state, LawResponse &response) const;

  CrushCurves curves_;
};

} // namespace vibroimpact::contact
