// What friction takes along the circumference of a contact in a circular clearance.
//
// The circumference is divided into n equal sectors about the first side's centre; sector 0 lies
// about the direction a_1 from which angles count, the others follow about the axis. With w = -s u
// the place of the touch (circular_gap.h), the border between sectors k - 1 and k at the angle
// phi_k = (2 k - 1) pi / n is passed at a zero of
//
//   cos phi_k w_2 - sin phi_k w_1,
//
// a polynomial along a step. What a step adds to the integrals of the state belongs to the sectors
// in which the contact is between these zeros, so that the sectors together have all of it. An
// impact of rigid sides takes its work at one place.
#pragma once

#include "motion/interval/step_view.h"

#include <vector>

namespace vibroimpact::analyses {

class SectorWork {
public:
  /// Of a contact with a circular gap and friction.
  SectorWork(std::size_t contact, std::size_t sectors) : contact_(contact), work_(sectors, 2) {
    clear();
  }

  void clear() { work_.setZero(); }
  void add(const motion::StepView &view);
  /// What an impact takes at once [J], at the angle from a_1 at which the sides meet [rad].
  void add_impact(double energy, double wear, double angle);
  /// Where the contact was at the end of the last step or at the last impact [rad].
  double last_angle() const { return last_angle_; }

  Index sectors() const { return work_.rows(); }
  std::size_t contact() const { return contact_; }
  /// Energy that friction has taken in each sector [J].
  Vector energy() const { return work_.col(0); }
  /// Integral of normal force times sliding speed [J].
  Vector wear() const { return work_.col(1); }
  /// Where each sector has its middle, from a_1 [rad].
  std::vector<double> angles() const;

private:
  struct Place;
  Place place(const motion::StepView &view) const;
  Index sector(const Place &place, double tau) const;
  Index sector(double angle) const;
  bool within(const Place &place, Index sector) const;
  std::vector<double> crossings(const Place &place) const;
  void divide(const motion::StepView &view, const Place &place, const RowVector &work);

  std::size_t contact_;
  Matrix work_; ///< sectors x (energy, wear)
  double last_angle_ = 0;
};

} // namespace vibroimpact::analyses
