// The way from one linear phase into the next, amplitudes to amplitudes: the state goes on but for
// the internal states that the guard resets, and so do the inputs.
#pragma once

#include "integration/flight_phase.h"

#include <vector>

namespace vibroimpact::integration {

class PhaseChange {
public:
  /// Through a guard of `from`. Both phases have the same sources; keeps references to them.
  PhaseChange(const FlightPhase &from, std::size_t guard, const FlightPhase &to);

  /// The frequencies of the inputs are others.
  void renew();

  /// The amplitudes of all groups of the next phase from those of the present one at the guard.
  void apply(const Amplitudes &from, Amplitudes &to) const;

private:
  void find(Index column, const Vector &state);

  const FlightPhase &phase_, &next_;
  std::size_t guard_;
  Matrix transposed_; ///< columns of `from` x columns of the modes of `to`
  Vector constant_;   ///< columns of the modes of `to`
  const std::vector<ExponentialBasis::Group> &from_, &to_;
  std::size_t first_input_ = 0; ///< of the sources, in `from`
  std::size_t n_modes_ = 0;     ///< groups of `to`
  bool has_constant_ = false;   ///< `to` has an input of its own
};

} // namespace vibroimpact::integration
