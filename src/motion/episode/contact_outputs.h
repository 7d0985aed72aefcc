// Extreme values of linear forms of the motion, and of the force, over a contact that was solved as
// a whole.
//
// In the time s = (t - t0) max|exponent| a form of the motion is a polynomial and integrals of the
// force (contact_episode.h), r = sum d_k s^k + sum g_k J_k / max|exponent|, with dJ_k/ds = J_(k-1),
// J_0 = int f ds, J_(-1) = f, J_(-2) = df/ds. Its derivatives and its integral are such sums too.
// Of a force that nowhere pulls 0 <= J_k(s) <= J_k at the end bounds the form, and most contacts
// end here: the bound lies within what was seen before. Otherwise R, the form or its integral, and
// three derivatives are known at the instants of ShownPoints, and between two of them extreme
// values are those of a polynomial of degree 7 for R or of its derivatives. Where the form sees
// the velocity of the contact, R is its integral, for its third derivative is not known.
//
// The force is the law of penetration and rate, and largest where its own rate
// F_u u' + F_u' u'' is zero. Next to both ends accelerations of what touches are such a force and a
// cubic for the rest.
#pragma once

#include "motion/episode/phase_episode.h"
#include "motion/interval/output.h"

#include <vector>

namespace vibroimpact::motion {

class ContactOutputs {
public:
  /// Whether the force has one direction, and its rate is finite at both ends of the contact that
  /// was passed last, as the values between two instants need it.
  static bool possible(const PhaseEpisode &contact);

  /// Keeps references to both. `tolerance`: relative, of the polynomials.
  ContactOutputs(const LinearOutputs &forms, const PhaseEpisode &contact, double tolerance);

  std::size_t bytes() const;
  /// The ranges grow by the contact that was passed last.
  void include();

private:
  struct Output {
    ForcedOutput form;
    ValueRange *range = nullptr;
    int integrated = 0;     ///< R is the form integrated so many times
    int differentiated = 0; ///< what is wanted is the form differentiated so many times
    int order() const { return integrated + differentiated; } ///< of R that is wanted
  };
  /// R and three derivatives.
  using Jet = std::array<double, 4>;

  void renew();
  Output output(std::size_t form) const;
  bool stays_inside(const Output &output, const double *free) const;
  void require_integrals();
  void set_forces();
  double derivative(const Output &output, const double *free, int order, Index instant) const;
  Jet jet(const Output &output, const double *free, Index instant) const;
  void include(const Output &output);
  void include_between(const Output &output, const double *free, Index instant);
  void include_force(ValueRange &range) const;
  void include_beside_force(const Output &output, const double *free, Index instant) const;
  std::optional<double> stationary(Index instant, const Bernstein &rest, double by_force) const;
  double length(Index instant) const { return times_[instant + 1] - times_[instant]; }

  const LinearOutputs &forms_;
  const PhaseEpisode &contact_;
  const int inner_points_;
  long version_ = -1;
  std::optional<Output> penetration_;
  std::vector<Output> outputs_;
  bool known_ = false; ///< the integrals are those of the present contact
  Vector times_;       ///< s of the instants
  /// J_(k - 2) in column k: instants x (terms + 2)
  Matrix integrals_;
  std::array<double, ContactEpisode::most_terms> free_penetration_{};
  Vector values_;
};

} // namespace vibroimpact::motion
