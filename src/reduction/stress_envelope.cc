#include "reduction/stress_envelope.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::reduction {

namespace {

// Stresses of so many places at so many instants at a time: 3 * 256 * 512 numbers are 3 MB.
constexpr Index place_block = 256;
constexpr Index instant_block = 512;

/// Squares, for a block of places (rows: their components) and instants (columns).
Matrix squares(const Matrix &stress, Index components) {
  Matrix squared(stress.rows() / components, stress.cols());
  for (Index t = 0; t < stress.cols(); ++t)
    for (Index p = 0; p < squared.rows(); ++p)
      squared(p, t) = squared_von_mises(&stress(components * p, t), components);
  return squared;
}

/// Squares in `envelope.largest`; `best` is the largest of all so far.
void take(const Matrix &squared, Index first_place, Index first_instant, double &best,
          StressEnvelope &envelope) {
  for (Index p = 0; p < squared.rows(); ++p) {
    Index instant = 0;
    const double largest = squared.row(p).maxCoeff(&instant);
    double &own = envelope.largest[first_place + p];
    own = std::max(own, largest);
    if (largest > best) {
      best = largest;
      envelope.place = first_place + p;
      envelope.instant = first_instant + instant;
    }
  }
}

/// The cell whose places a place is among.
std::size_t cell_of(const CellStress &stress, Index place) {
  const auto after = std::upper_bound(stress.first.begin(), stress.first.end(), place);
  return static_cast<std::size_t>(after - stress.first.begin()) - 1;
}

} // namespace

Vector StressEnvelope::as_stress(Index components) const {
  Vector stress = Vector::Zero(components * largest.size());
  for (Index p = 0; p < largest.size(); ++p)
    stress[components * p] = largest[p];
  return stress;
}

StressEnvelope stress_envelope(const CellStress &stress, const Matrix &coordinates) {
  const Index components = stress.components;
  const Index places = stress.rows.rows() / components;
  const Index instants = coordinates.rows();
  StressEnvelope envelope{.largest = Vector::Zero(places)};
  double best = -1;
  for (Index p = 0; p < places; p += place_block)
    for (Index t = 0; t < instants; t += instant_block) {
      const Matrix block =
          stress.rows.middleRows(components * p, components * std::min(place_block, places - p)) *
          coordinates.middleRows(t, std::min(instant_block, instants - t)).transpose();
      take(squares(block, components), p, t, best, envelope);
    }
  envelope.largest = envelope.largest.cwiseSqrt();
  return envelope;
}

Vector3 place_of_stress(const Recovery &recovery, bool of_cells, Index place) {
  if (of_cells) {
    const structure::Cell &cell = recovery.cells[cell_of(recovery.cell_stress, place)];
    Vector3 middle = Vector3::Zero();
    for (const int node : cell.nodes())
      middle += recovery.nodes.col(node) / cell.size;
    return middle;
  }
  const std::size_t line = cell_of(recovery.line_stress, place);
  const Index first = recovery.line_stress.first[line];
  const Index count = recovery.line_stress.first[line + 1] - first;
  const std::size_t end = 2 * (place - first) < count ? 0 : 1;
  return recovery.nodes.col(recovery.lines[line][end]);
}

} // namespace vibroimpact::reduction
