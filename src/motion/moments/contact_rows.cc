#include "motion/moments/contact_rows.h"

namespace vibroimpact::motion {

ContactRows::ContactRows(const Equations &equations) {
  const auto &pairs = equations.contacts().pairs();
  const auto count = static_cast<Index>(pairs.size());
  rows.resize(count, equations.layout().n);
  base.setZero(count, static_cast<Index>(equations.model().sources().size()));
  clearances.resize(count);
  for (Index c = 0; c < count; ++c) {
    const contact::ContactPair &pair = pairs[static_cast<std::size_t>(c)];
    rows.row(c) = pair.gap.row;
    clearances[c] = pair.clearance;
    for (std::size_t s = 0; s < pair.gap.base_coefficients.size(); ++s)
      base(c, static_cast<Index>(s)) = pair.gap.base_coefficients[s];
  }
  flexibilities = rows.cwiseAbs2() * equations.model().mass().cwiseInverse();
  largest = rows.cwiseAbs().colwise().maxCoeff();
}

contact::LocalState ContactRows::local(Index contact, const Vector &of) const {
  const Index n = rows.cols();
  contact::LocalState state;
  state.gap = clearances[contact] + rows.row(contact).dot(of.head(n));
  state.gap_rate = rows.row(contact).dot(of.segment(n, n));
  for (Index s = 0; s < base.cols(); ++s) {
    state.gap += base(contact, s) * of[2 * n + 3 * s];
    state.gap_rate += base(contact, s) * of[2 * n + 3 * s + 1];
  }
  return state;
}

} // namespace vibroimpact::motion
