// The way from one linear phase into the next, amplitudes to amplitudes: the state goes on but for
// the internal states that the guard resets, and so do the inputs.
#pragma once

#include "motion/interval/phase_forms.h"
#include "motion/phase/exact_phase.h"

#include <vector>

namespace vibroimpact::motion {

class ExactChange {
public:
  /// Keeps references to both phases and to the resets, which all belong to the guard passed.
  ExactChange(const ExactPhase &from, const std::vector<PhaseForms::Reset> &resets,
              const ExactPhase &to);

  /// Takes over the present inputs of both phases, which must be the same.
  void renew();

  const ChangeView &view() const { return view_; }
  std::size_t bytes() const { return bytes_of(columns_, magnitudes_); }

private:
  using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  void arrange();
  void set_constant();
  void set_column(Index coordinate);
  void set_state(Index coordinate);

  const ExactPhase &from_, &to_;
  const std::vector<PhaseForms::Reset> &resets_;
  long from_arrangement_ = -1, to_arrangement_ = -1;
  long generation_ = -1;
  LongVector state_; ///< behind the change, of one coordinate
  ChangeView view_;
  AlignedArray constant_, columns_, magnitudes_, constant_sizes_;
};

} // namespace vibroimpact::motion
