// State and deviations as one system over a part of a step, in numbers that are comparable.
//
// Entries: the scaled change of the state since the start, in units of its size, so that a short
// contact is not lost in the rounding of the whole; the scaled columns in units of theirs; and the
// integral of the divergence. The independent variable s goes from 0 to 1. Where a gap vanishes at
// the instant t_0, at the start or before it, s goes on evenly with |t - t_0|^(1/4), in which
// square roots and fourth roots of the penetration are smooth.
#pragma once

#include "motion/variation/key_tangent.h"
#include "motion/variation/split_jacobian.h"

#include <optional>

namespace vibroimpact::motion {

struct Interval {
  double start = 0, end = 0;    ///< [s]; the end may be earlier
  Vector state;                 ///< at the start, with work integrals
  std::optional<double> zero{}; ///< when a gap vanishes; not between start and end [s]
  double length() const { return end - start; }
};

class JointRates {
public:
  /// Keeps references. The last columns belong to `keys`.
  JointRates(const Interval &interval, const Vector &end_state, const Equations &equations,
             const std::vector<KeyTangent *> &keys, const Vector &scale, const Matrix &columns);

  Index n_states() const { return scale_.size(); }
  Index n_columns() const { return sizes_.size(); }
  Matrix pack(const Matrix &columns) const;
  Matrix unpack(const Matrix &packed) const;

  struct Value {
    Vector state;    ///< d(change)/ds
    Matrix jacobian; ///< by the change
    Matrix keys;     ///< n_states() x keys: what keys add to the rates of their columns
  };
  /// At a change of the state.
  void evaluate(double s, ConstVectorView change, Value &value);
  /// The same without the Jacobian, of which the product with columns is taken. Returns its trace.
  double evaluate(double s, ConstVectorView change, Value &value,
                  const Eigen::Ref<const Matrix> &columns, Eigen::Ref<Matrix> product);
  double start() const { return interval_.start; }

private:
  void evaluate_rates(double s, ConstVectorView change, Value &value);
  void evaluate_jacobian(double s, Value &value);
  double root_at(double s) const;
  double time_at(double s) const;
  double rate_at(double s) const;

  const Interval &interval_;
  const Equations &equations_;
  const std::vector<KeyTangent *> &keys_;
  const Vector &scale_;
  double first_root_ = 0, root_span_ = 0; ///< of the time since the gap vanished
  double state_size_ = 1;
  RowVector sizes_; ///< of the columns
  Vector full_, full_rates_;
  Matrix jacobian_;
  std::optional<SplitJacobian> split_;
};

} // namespace vibroimpact::motion
