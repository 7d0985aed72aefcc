// The largest von Mises stress over time at each place of a body's elements, from its coordinates.
#pragma once

#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Over given instants, at the places of a CellStress.
struct StressEnvelope {
  Vector largest{}; ///< for each place [Pa]
  /// The largest of all: the place and the instant where it stands; negative without any place.
  Index place = -1;
  Index instant = -1;

  /// 0 without any place [Pa].
  double maximum() const { return place < 0 ? 0 : largest[place]; }
  /// Rows of so many components, for stresses whose von Mises stress is the envelope: uniaxial.
  Vector as_stress(Index components) const;
};

/// `coordinates`: instants x n. Takes a few MB beside its arguments, however many places and
/// instants there are.
StressEnvelope stress_envelope(const CellStress &stress, const Matrix &coordinates);

/// The middle of the cell that a place belongs to [m]; `of_cells`: of Recovery::cell_stress, else
/// the end of the line where the place lies.
Vector3 place_of_stress(const Recovery &recovery, bool of_cells, Index place);

} // namespace vibroimpact::reduction
