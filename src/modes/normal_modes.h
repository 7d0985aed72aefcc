// The lowest normal modes of K phi = omega^2 M phi, complete and accurate: block Lanczos finds
// them, refinement takes the round-off of the stiffness matrix out of the low ones, and an inertia
// count proves that none is missing and that the bounds of their errors hold.
#pragma once

#include "modes/rayleigh_ritz.h"

#include <array>
#include <optional>

namespace vibroimpact::modes {

struct Selection {
  int number = 5;                            ///< lowest modes; not used with a band
  std::optional<std::array<double, 2>> band; ///< lowest and highest angular frequency [rad/s]
};

struct NormalModes {
  /// omega^2 [rad^2/s^2], ascending; exactly 0 for rigid-body modes.
  Vector eigenvalues;
  /// Rows as in the matrices x modes, M-orthonormal, on every rank. The last mode of the selection
  /// may belong to a group of equal eigenvalues: then the whole group is there.
  Matrix shapes;
  Index first = 0; ///< the selected modes are first ... first + number - 1
  Index number = 0;
  /// Of the eigenvalues, relative, with 1e-14 for rounding; for rigid-body modes relative to a
  /// small shift of the spectrum.
  Vector error_bounds;
  double orthogonality_residual = 0;
};

/// Two eigenvalues closer than this, relative, are one multiple eigenvalue.
inline constexpr double multiplicity_tolerance = 1e-9;

/// The number of modes asked for exceeds the number there is.
class TooManyModes : public std::runtime_error {
public:
  explicit TooManyModes(int available);
  int available; ///< number of finite eigenvalues
};

/// Collective over the communicator of the matrices. Throws TooManyModes, and NumericalError when
/// modes stay missing.
NormalModes normal_modes(const EigenProblem &problem, const Selection &selection);

} // namespace vibroimpact::modes
