// Energies and impulses over a contact that was solved as a whole.
//
// What the contact itself does follows from the integrals of its force, but for the way of sliding.
// The powers of loads, dampers and other contacts are products of linear forms of the motion, those
// of the linear phase, and are smooth but for t^(n + 1) at both ends: m points of a Gauss rule
// leave about m^-7 of a Hertz contact's share, 1e-6 of it with 10.
#pragma once

#include "motion/episode/phase_episode.h"

#include <vector>

namespace vibroimpact::motion {

class ContactWork {
public:
  /// `powers`: of the phase of the contact. Keeps references. `tolerance`: relative, of the motion.
  ContactWork(const PowerForms &powers, const PhaseEpisode &contact, const Equations &equations,
              double tolerance);

  std::size_t bytes() const { return static_cast<std::size_t>(factors_.nonZeros()) * 12; }
  /// Adds the integrals over the contact that was passed last and began at `time` to the entries of
  /// `state`. In place of the integral of |power| stands the absolute value of the integral, which
  /// is never larger.
  void add(double time, Vector &state);

private:
  void renew();
  int points() const;
  void add_powers(Vector &state);
  double work_of_bases(double time) const;
  double sliding_speed(const double *amplitudes);
  void add_friction(Vector &state) const;

  const PowerForms &powers_;
  const PhaseEpisode &contact_;
  const Equations &equations_;
  const double tolerance_;
  long version_ = -1;
  std::vector<Index> products_; ///< of the powers, without those of the contact itself
  PhaseEpisode::Rows factors_;  ///< amplitudes to both factors of each
  Vector constants_, values_;
  Amplitudes amplitudes_;
  double sliding_way_ = 0; ///< over the present contact [m]
  contact::LawResponse response_;
};

} // namespace vibroimpact::motion
