// What the errors of a step are measured against: nothing but the motion itself.
//
// A tolerance in metres fits one size of model only. Here every error is relative, to
//   a coordinate, its velocity   its own recent largest value, and a small part of what the energy
//                                of its body could make of it: v = sqrt(2 E / m). A mode that holds
//                                hardly any energy need not be followed to its last digit.
//   a contact that acts          the penetration and gap rate that it has reached itself, however
//                                large the coordinates are of which the gap is the difference
//   work, impulses               the energy that is turned over, the energy and momentum of the
//                                contact: where a base moves a body that is held, no coordinate
//                                shows the error
// each with what rounding makes of it, below which no step is good enough. Lengths, times and
// masses can be scaled by any power of two and the same steps follow.
//
// "Recent": the largest value of the phase, fading with each step.
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

class ErrorMeasure {
public:
  /// Keeps a reference. `absolute` [m]: errors of displacements below it do not count; may be 0.
  ErrorMeasure(const Equations &equations, double relative, double absolute);

  /// Another motion begins.
  void forget() { largest_turnover_ = 0; }
  /// A phase begins there.
  void begin(const EndPoint &start);
  /// No step yet has had any energy: there is nothing to measure errors against.
  bool at_rest() const { return largest_turnover_ == 0; }
  /// The measure of a step between these ends.
  void set_step(const EndPoint &start, const EndPoint &end);
  /// Error over tolerance, the largest of all, infinite where the end has energy from nowhere;
  /// `error`: one entry per state, the work integrals included.
  double of_step(const Vector &error) const;
  /// The same of the coordinates between the ends, n entries.
  double of_dense(const Vector &error) const;
  /// The step is taken.
  void accept();

  /// What the history of each source may err by as part of the gaps that it moves.
  const Vector &source_tolerances(double length);

private:
  struct OfContact {
    double gap = 0, gap_rate = 0, gap_acceleration = 0; ///< absolute values
    double energy = 0; ///< stored, and kinetic of the mass that meets
    double force = 0, impulse = 0;
    double sticking = 0; ///< force that holds the slip rate [N]
    double work = 0;     ///< dissipated
    double rounding = 0; ///< of the gap
    double speed = 0;    ///< that its energy could make of the mass that meets
  };
  struct Scales {
    Vector values;             ///< |x| of the physical part
    Vector energy;             ///< of each body, with that of its contacts
    std::vector<OfContact> of; ///< zero for contacts that do not act and are moved by no source
    double turnover = 0;       ///< energy and work
  };

  bool possible(const EndPoint &end, double available) const;
  void read(const EndPoint &point, Scales &scales) const;
  void read_contact(std::size_t contact, const EndPoint &point, Scales &scales) const;
  bool acts(std::size_t contact) const;
  double speed(Index coordinate) const;
  double noise(std::size_t contact) const;
  double reached(std::size_t contact, double length) const;
  double rounding_of_speed(double mass) const;
  double gap_tolerance(std::size_t contact, double length) const;
  double gap_rate_tolerance(std::size_t contact, double length) const;
  double displacement_tolerance(Index coordinate) const;
  double speed_tolerance(Index coordinate) const;
  void find_speed_tolerances();
  double work_at_rest() const;
  double negligible_work() const;
  double negligible_impulse(std::size_t contact) const;
  double energy_at(std::size_t contact) const;
  double of_contacts(const Vector &error) const;
  double of_work(const Vector &error) const;

  const Equations &equations_;
  double relative_;
  Vector absolute_;
  double absolute_gap_;
  std::vector<Index> body_;                ///< of each coordinate
  std::vector<double> mass_;               ///< that meets at each contact [kg]; 0 where nothing can
  std::vector<std::vector<Index>> bodies_; ///< of each contact
  std::vector<char> carried_;              ///< contacts whose gap a source moves
  Vector internal_scale_by_gap_;           ///< 1: an internal state that is a length
  std::vector<std::size_t> contact_of_internal_;
  Scales recent_, at_end_, present_;
  Vector speed_tolerances_;     ///< of each coordinate in the step, without the absolute ones
  double largest_turnover_ = 0; ///< of the motion; what is below its rounding does not count
  double length_ = 0;
  bool possible_ = true; ///< the step's end has no more energy than there can be
  Vector source_tolerances_;
};

} // namespace vibroimpact::motion
