// Where a sequence of states, one per period, is going, long before it is there.
//
// Near a periodic motion the differences u_i = x_{i+1} - x_i obey a linear recurrence of few terms,
//
//   c_0 u_i + ... + c_{k-1} u_{i+k-1} + u_{i+k} = 0,
//
// whose coefficients least squares find from the last differences; the limit is the mean of the
// states with weights c_j / sum(c) (minimal polynomial extrapolation; Sidi, bib key sidi2017). The
// limit of a sequence that does not go there is of no use: an unstable periodic motion is the limit
// of the sequence run backward. So all zeros of the recurrence's polynomial must be well inside the
// unit circle.
#pragma once

#include "analyses/last_states.h"

#include <optional>

namespace vibroimpact::analyses {

class SequenceLimit {
public:
  /// `scale`: what makes the entries of a state comparable.
  explicit SequenceLimit(const Vector &scale);

  void add(const Eigen::Ref<const Vector> &state) { states_.add(state.cwiseProduct(scale_)); }
  /// Forgets all states.
  void clear() { states_.clear(); }

  /// The limit, from as few of the last states as describe the sequence; none where they do not, or
  /// where the limit is far away.
  std::optional<Vector> limit();
  /// Largest scaled entry of the last difference; two states are needed.
  double last_change() const { return states_.change(0, 1); }

private:
  std::optional<Vector> limit_of(const Vector &recurrence) const;
  std::optional<Vector> mean(const Vector &weights) const;
  bool add_direction(Index k);

  Vector scale_;
  LastStates states_; ///< scaled
  Matrix basis_;      ///< orthonormal, of the differences before the last one
  Matrix parts_;      ///< of these differences in the basis
  Vector wanted_;     ///< parts of the last difference
  Vector rest_;       ///< of the last difference
  Vector direction_;
};

/// Are all zeros of z^n + c_{n-1} z^{n-1} + ... + c_0 nearer to the origin than `radius`?
bool zeros_within(Vector coefficients, double radius);

} // namespace vibroimpact::analyses
