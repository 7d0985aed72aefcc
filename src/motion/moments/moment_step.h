// A step of many contacts at once, through all changes of their modes.
//
// The modes are those of the system without contact forces. With the force of each contact over the
// step as a polynomial (contact_course.h) the coordinates at the nodes and the end follow
// (moment_flow.h), from these the gaps, and from the gaps the forces: the sweeps of this
// fixed-point iteration end when what they change is below the tolerance. No change of a contact
// ends a step, and none needs a decomposition.
//
// Errors are measured in the energy norm, |(q, v)|^2 = q K q + v M v, relative to the largest norm
// of the motion so far. Two are estimated: what the polynomial lacks, its next coefficient taken
// for as large as its last one, through the response of the coordinates to P_m; and for contacts
// that change what the last coefficient does to the gap within the step, which the moments do not
// see:
//   e1 = |h J_m L W^T a_(m-1)|,   e2 = h |W^T a_(m-1)|_changing rho / (2 m),
// rho the rate at which the sweeps converge. A third is that of the gaps of contacts with a force,
// over ten times the tolerance of the deepest penetration so far, since light parts of a body show
// there first: how far the polynomial misses the motion in the middle of the step, and what the
// force that is lacking makes of the gap by itself,
//
//   h^2 |a_(m-1)| W M^-1 W^T max|integral of the integral of P_m(2 x - 1)|,
//
// the last factor being at most (2 / ((2 m + 1) (2 m + 3)) + 2 / ((2 m + 1) (2 m - 1))) / 4.
#pragma once

#include "motion/moments/contact_course.h"
#include "motion/moments/contact_rows.h"
#include "motion/moments/moment_flow.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

/// The tables of a step: of the nodes, then of the end and of the middle.
using MomentTables = std::array<MomentTable, n_moments + 2>;

class MomentStep {
public:
  /// Keeps a reference. The model must be linear, holds() says what else.
  MomentStep(const Equations &equations, double tolerance);

  /// True where such steps can be taken at all: no law is rigid or holds the
  /// slip, and internal states follow the motion (ContactCourse::holds).
  static bool holds(const Equations &equations);

  /// A motion begins.
  void begin();
  /// Under the present excitation. True when tables made before mean nothing now.
  bool take(const Excitation &excitation);
  /// The step begins there, with the contacts in these modes, perhaps at a contact change whose
  /// instant is known to `uncertainty` [s].
  void start(const Vector &state, const Excitation &excitation, double time,
             const std::vector<int> &modes, double uncertainty);
  /// The same where the last step ended.
  void go_on(const Excitation &excitation, double time);

  MomentTables tables(double h) const;
  /// Error of a step over its tolerance; nothing where the sweeps do not converge.
  std::optional<double> attempt(double h, const MomentTables &tables);

  /// Of the last attempt, ascending; contacts that stayed open throughout are not among them.
  const std::vector<std::size_t> &listed() const { return list_; }
  /// Those with a force at some instant.
  std::vector<std::size_t> acting() const;
  const ContactCourse &course(std::size_t contact) const { return courses_[contact]; }
  /// What forces lack within the step, for rows_at(); behind the last move_change().
  void sum_lacks();
  /// Of the motion as it is shown; where the step leads to stays.
  void move_change(std::size_t contact, std::size_t stretch, double x) {
    courses_[contact].move_change(stretch, x);
  }
  /// The internal states of a contact in a stretch at the part x of the step, among those of all.
  void set_internal(std::size_t contact, const CourseStretch &stretch, double x, double *all) const;
  /// y and sources, r = columns x, at a part of the step (phase/exact_phase.h).
  Vector rows_at(double x) const;
  Vector rows_at_end() const { return phase_->columns() * ends_.back(); }
  /// What a projection sees, by the values at the nodes and at both ends.
  DirectionCurve curve_of(const model::Projection &projection) const;
  /// Likewise a coordinate by itself.
  DirectionCurve coordinate(Index j) const;
  /// Do these polynomials meet the motion in the middle, to the tolerance in the energy norm? They
  /// do not where a free motion goes over many periods of a mode.
  bool resolved() const;
  /// States of all laws at the start.
  const Vector &internal() const { return internal_; }
  double length() const { return h_; }
  const ContactRows &contact_rows() const { return contacts_; }
  /// |(q, v)| and the largest so far.
  double norm(const Vector &rows) const;
  double largest_norm() const { return largest_; }

private:
  void make_phase();
  void find_start();
  void take_list(std::vector<std::size_t> list);
  bool open_at_start(std::size_t contact) const;
  std::vector<std::size_t> within_reach() const;
  void sweep(const MomentTables &tables);
  void find_paths();
  DirectionCurve curve(Index listed) const;
  std::span<const double> internal_of(std::size_t contact) const;
  bool find_forces();
  void choose_list();
  double way() const;
  double error(const MomentTable &end, double rate) const;
  double gap_error(const MomentTable &middle);
  double deepest() const;

  const Equations &equations_;
  double tolerance_, fastest_; ///< highest frequency [rad/s]
  ContactRows contacts_;
  std::unique_ptr<ExactPhase> phase_;
  std::unique_ptr<MomentFlow> flow_;
  std::vector<int> modes_;             ///< at the start of the step
  std::vector<ContactCourse> courses_; ///< of each contact
  ContactRows::RowMatrix moments_;     ///< rows x n_moments
  std::vector<std::size_t> all_, list_;
  std::vector<Index> listed_rows_;
  ContactRows::RowMatrix packed_;               ///< listed rows, and more
  Vector start_, start_rows_;                   ///< coordinates; y and sources
  Vector start_positions_, start_rates_;        ///< of each row; rates without those of surfaces
  Vector internal_;                             ///< states of all laws at the start
  double gap_rounding_ = 0, rate_rounding_ = 0; ///< of these
  Matrix loads_;                                ///< coordinates x n_moments
  std::array<Vector, n_moments + 1> ends_;      ///< coordinates at the nodes and the end
  Matrix positions_, first_positions_;          ///< q there and v at the end; of the first sweep
  Matrix sources_;                              ///< s, s', s'' of each there
  ContactRows::RowMatrix paths_;                ///< listed rows x the same
  double h_ = 0, largest_ = 0, slack_ = 0, deepest_ = 0;
  mutable contact::LawResponse response_;
};

} // namespace vibroimpact::motion
