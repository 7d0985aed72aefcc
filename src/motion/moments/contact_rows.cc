#include "motion/moments/contact_rows.h"

namespace vibroimpact::motion {

ContactRows::ContactRows(const Equations &equations) : places(1, 0) {
  const auto &pairs = equations.contacts().pairs();
  for (const contact::ContactPair &pair : pairs)
    places.push_back(places.back() + pair.n_directions());
  rows.resize(places.back(), equations.layout().n);
  base.setZero(places.back(), static_cast<Index>(equations.model().sources().size()));
  offsets.resize(places.back());
  speeds.resize(places.back());
  for (std::size_t c = 0; c < pairs.size(); ++c)
    for (int d = 0; d < pairs[c].n_directions(); ++d) {
      const contact::Direction along = pairs[c].along(d);
      const Index row = places[c] + d;
      rows.row(row) = along.projection->row;
      offsets[row] = along.offset;
      speeds[row] = along.speed;
      for (std::size_t s = 0; s < along.projection->base_coefficients.size(); ++s)
        base(row, static_cast<Index>(s)) = along.projection->base_coefficients[s];
    }
  flexibilities = rows.cwiseAbs2() * equations.model().mass().cwiseInverse();
  largest = rows.cwiseAbs().colwise().maxCoeff();
}

contact::LocalState ContactRows::local(std::size_t contact, const Vector &of) const {
  const Index n = rows.cols();
  contact::LocalState state;
  for (Index d = 0; d < directions(contact); ++d) {
    const Index row = places[contact] + d;
    double position = offsets[row] + rows.row(row).dot(of.head(n));
    double rate = speeds[row] + rows.row(row).dot(of.segment(n, n));
    for (Index s = 0; s < base.cols(); ++s) {
      position += base(row, s) * of[2 * n + 3 * s];
      rate += base(row, s) * of[2 * n + 3 * s + 1];
    }
    if (d == 0) {
      state.gap = position;
      state.gap_rate = rate;
    } else {
      state.tangential[static_cast<std::size_t>(d - 1)] = {.slip = position, .slip_rate = rate};
    }
  }
  return state;
}

} // namespace vibroimpact::motion
