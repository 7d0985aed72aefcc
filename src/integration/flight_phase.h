// A linear phase for the kernel of flights: its guards as sums of exponentials, and the
// way from the state to the amplitudes and back.
#pragma once

#include "integration/exponential_basis.h"
#include "integration/guard_sums.h"
#include "integration/phase_forms.h"

#include <vector>

namespace vibroimpact::integration {

class FlightPhase {
public:
  /// Keeps a reference to the forms. `inverse`: from y less the response to the inputs to the
  /// columns of the modes.
  FlightPhase(const PhaseForms &forms, ExponentialBasis basis, Matrix inverse);

  /// The same phase under inputs of other frequencies, described by `basis`.
  void renew(const ExponentialBasis &basis);

  const PhaseForms &forms() const { return forms_; }
  const ExponentialBasis &basis() const { return basis_; }
  const Matrix &inverse() const { return inverse_; }
  Index size() const { return inverse_.rows(); }
  std::size_t n_groups() const { return basis_.groups.size(); }

  /// y and the sources: size() + 3 sources entries.
  void rows(const Amplitudes &amplitudes, Vector &rows) const;
  /// Amplitudes of the modes from y, when those of the inputs are in place.
  void find_modes(const Vector &y, Amplitudes &amplitudes);

  const GuardSums &sums() const { return sums_; }

private:
  void set_coefficients(std::size_t first);
  double size_behind(Index guard, const ExponentialBasis::Group &group) const;

  const PhaseForms &forms_;
  ExponentialBasis basis_;
  Matrix inverse_;
  GuardSums sums_;
  Vector rest_;
  std::vector<Complex> exponents_; ///< of the inputs, while they are renewed
};

} // namespace vibroimpact::integration
