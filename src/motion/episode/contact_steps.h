// A contact that was solved as a whole, as steps with polynomials for those who observe the motion.
//
// The steps end at the Gauss-Lobatto points of the contact and twice more next to its ends
// (ForceTools::shown), where state, rates and the third derivative are known, so that observers see
// polynomials of degree 7: their number follows the tolerance to the power -1/8. Next to the ends
// the motion goes like t^(n + 2), which costs the velocity 1e-2 h^(n + 1) in a step of length h
// there: 1e-8 of the speed for a Hertz force.
#pragma once

#include "motion/episode/contact_work.h"
#include "motion/interval/observer.h"

namespace vibroimpact::motion {

class ContactSteps {
public:
  /// `tolerance`: relative, of the polynomials. Keeps a reference; the modes of the equations are
  /// those of the contact when it is used.
  ContactSteps(const Equations &equations, double tolerance);
  /// Gauss-Lobatto points between the ends of a contact.
  static int inner_points(double tolerance);

  /// Shows the contact that was passed last and began at `time`; `state` is that with its work
  /// integrals then, and at the end of the contact afterwards. `work`: none where nobody wants
  /// these integrals. Returns how many steps.
  int show(const PhaseEpisode &contact, double time, ContactWork *work, Vector &state,
           const Audience &audience);

private:
  void fill(const PhaseEpisode &contact, double time, const double *amplitudes, EndPoint &point);
  void add_bent_force(const PhaseEpisode &contact, EndPoint &point) const;
  void find_points(const PhaseEpisode &contact, double time, const Vector &state);
  void smooth_position(const EndPoint &neighbour, EndPoint &point) const;
  void smooth_positions();
  void set_integrals(double time, const Vector &state, ContactWork *work);

  const Equations &equations_;
  const int inner_points_;
  std::vector<EndPoint> points_;
  Amplitudes amplitudes_;
  Vector rows_;
  contact::LawResponse response_;
};

} // namespace vibroimpact::motion
