// State and deviations as one system over a part of the motion, in numbers that are comparable.
//
// Entries: the scaled change of the state since the start, in units of its size, so that a short
// contact is not lost in the rounding of the whole; the scaled columns in units of theirs; and the
// integral of the divergence. The independent variable s goes from 0 to 1. Where a gap vanishes at
// the instant t_0, at the start or before it, s goes on evenly with |t - t_0|^(1/4), in which
// square roots and fourth roots of the penetration u are smooth.
//
// The slope of a force may be infinite where contact begins or ends (of Kuwabara-Kono u^(-1/2), of
// Tsuji u^(-3/4)). There s goes on with tau^(1/8), tau = |t - t_0|, so that slope times dt/ds is
// zero at t_0; and the slope needs the gap to its last digits, which the coordinates do not have.
// The mean gap rate r since t_0 is carried along as one more entry of the state,
//
//   gap = r tau,   dr/dtau = (gap' - r) / tau
//
// which begins with the gap rate.
#pragma once

#include "motion/variation/key_tangent.h"
#include "motion/variation/split_jacobian.h"

#include <optional>

namespace vibroimpact::motion {

struct JointInterval {
  double start = 0, end = 0;          ///< [s]; the end may be earlier
  Vector state;                       ///< at the start, with work integrals
  double far = 0;                     ///< another instant, at the end or beyond [s]
  Vector far_state;                   ///< of the motion there
  std::optional<double> zero{};       ///< when a gap vanishes; not between start and end [s]
  std::optional<std::size_t> steep{}; ///< the contact, where its slope is infinite there
  double length() const { return end - start; }
};

class JointRates {
public:
  /// Keeps references. The last columns belong to `keys`.
  JointRates(const JointInterval &interval, const Equations &equations,
             const std::vector<KeyTangent *> &keys, const Vector &scale, const Matrix &columns);

  Index n_rows() const { return n_; } ///< of the columns
  /// One more where the mean gap rate is carried along.
  Index n_states() const { return n_ + (interval_.steep ? 1 : 0); }
  Index n_columns() const { return sizes_.size(); }
  Matrix pack(const Matrix &columns) const;
  Matrix unpack(const Matrix &packed) const;

  struct Value {
    Vector state;    ///< d(change)/ds
    Matrix jacobian; ///< of deviations: n_rows() squared
    Matrix keys;     ///< n_rows() x keys: what keys add to the rates of their columns
  };
  /// The physical state at a change, with the work integrals of the start.
  Vector state_after(ConstVectorView change) const;
  /// At a change of the state.
  void evaluate(double s, ConstVectorView change, Value &value);
  /// The same without the Jacobian, of which the product with columns is taken. Returns its trace.
  double evaluate(double s, ConstVectorView change, Value &value,
                  const Eigen::Ref<const Matrix> &columns, Eigen::Ref<Matrix> product);
  double start() const { return interval_.start; }

private:
  double growth_by(const KeyTangent &key) const;
  Vector state_near(double time) const;
  /// What the gap of the steep contact differs by from that of the coordinates: slopes of its
  /// force.
  struct Carried {
    double by_gap = 0, by_gap_rate = 0;
    Vector response; ///< accelerations by the force
  };
  void evaluate_rates(double s, ConstVectorView change, Value &value);
  void evaluate_jacobian(double s, Value &value);
  void take_carried_gap(double s, double mean_rate, Value &value);
  double add_carried_slopes(const Eigen::Ref<const Matrix> &columns,
                            Eigen::Ref<Matrix> product) const;
  double root_of(double time) const;
  double root_at(double s) const;
  double time_at(double s) const;
  double rate_at(double s) const;

  const JointInterval &interval_;
  const Equations &equations_;
  const std::vector<KeyTangent *> &keys_;
  const Vector &scale_;
  Index n_ = 0; ///< of the physical state
  int power_ = 4;
  double first_rate_ = 0;                 ///< mean gap rate of the steep contact [m/s]
  double first_root_ = 0, root_span_ = 0; ///< of the time since the gap vanished
  double state_size_ = 1;
  RowVector sizes_; ///< of the columns
  Vector full_, full_rates_;
  Matrix jacobian_;
  contact::LawResponse by_state_, by_gap_;
  Carried carried_;
  std::optional<SplitJacobian> split_;
};

} // namespace vibroimpact::motion
