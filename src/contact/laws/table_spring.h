// A spring between two ends that follows a table, in both directions.
//
//   T = f(e)                   e  elongation [m], the gap of the pair
//                              T  tension [N], the force with the opposite sign
//
// f is a line through the points of the table, continued straight beyond the first and the last
// one. A table that is zero over some elongations has free play there. Each segment is a mode, in
// which the law is affine; the ends never part. Stored energy: the integral of f from 0 to e.
#pragma once

#include "contact/contact_law.h"
#include "contact/laws/force_curve.h"

namespace vibroimpact::contact {

class TableSpring : public ContactLaw {
public:
  explicit TableSpring(ForceCurve tension);

  std::string name() const override { return "table of a connection"; }
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  bool may_pull() const override { return true; }

private:
  ForceCurve tension_;
  double energy_at_zero_; ///< of the area from the first point on [J]
};

} // namespace vibroimpact::contact
