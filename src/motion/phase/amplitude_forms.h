// Linear forms of the rows of a phase [y, then s, s', s'' of each source], evaluated on its
// amplitudes, all of them at once.
#pragma once

#include "motion/phase/exact_phase.h"
#include "motion/system/linear_system.h"

#include <vector>

namespace vibroimpact::motion {

class AmplitudeForms {
public:
  /// Keeps a reference to the phase.
  AmplitudeForms(const ExactPhase &phase, std::vector<LinearRow> forms);

  /// Takes over the present inputs of the phase.
  void renew();
  /// At these amplitudes, each of which is known to `rounding`, by groups.
  void evaluate(const double *amplitudes, const double *rounding);

  std::size_t size() const { return forms_.size(); }
  double value(std::size_t form) const { return values_[form]; }
  /// What rounding may hide of a value, that of the amplitudes included.
  double hidden(std::size_t form) const { return hidden_[form]; }
  std::size_t bytes() const;

private:
  void arrange();
  void set_column(Index coordinate);

  const ExactPhase &phase_;
  std::vector<LinearRow> forms_;
  long arrangement_ = -1, generation_ = -1;
  ChangeView view_;
  AlignedArray constants_, columns_, magnitudes_, constant_sizes_;
  AlignedArray values_, hidden_;
};

} // namespace vibroimpact::motion
