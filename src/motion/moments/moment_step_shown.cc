// What a step of many contacts shows of the motion within it.
#include "motion/moments/moment_step.h"

namespace vibroimpact::motion {

DirectionCurve MomentStep::curve_of(const model::Projection &projection) const {
  const Index n = equations_.layout().n;
  const auto carried = [&](const auto &sources, Index derivative) {
    double sum = 0;
    for (Index s = 0; s < contacts_.base.cols(); ++s)
      sum +=
          projection.base_coefficients[static_cast<std::size_t>(s)] * sources[3 * s + derivative];
    return sum;
  };
  const auto of_sources = start_rows_.tail(start_rows_.size() - 2 * n);
  PathValues values{.start = projection.row.dot(start_rows_.head(n)) + carried(of_sources, 0),
                    .start_rate =
                        projection.row.dot(start_rows_.segment(n, n)) + carried(of_sources, 1)};
  const auto at = [&](Index i) {
    return projection.row.dot(positions_.col(i)) + carried(sources_.col(i), 0);
  };
  for (std::size_t i = 0; i < n_moments; ++i)
    values.nodes[i] = at(static_cast<Index>(i));
  values.end = at(n_moments);
  values.end_rate =
      projection.row.dot(positions_.col(n_moments + 1)) + carried(sources_.col(n_moments), 1);
  return {values, h_, 0};
}

DirectionCurve MomentStep::coordinate(Index j) const {
  PathValues values{.start = start_rows_[j],
                    .start_rate = start_rows_[equations_.layout().n + j],
                    .end = positions_(j, n_moments),
                    .end_rate = positions_(j, n_moments + 1)};
  for (std::size_t i = 0; i < n_moments; ++i)
    values.nodes[i] = positions_(j, static_cast<Index>(i));
  return {values, h_, 0};
}

bool MomentStep::resolved() const {
  constexpr double x = 0.5;
  const Index n = equations_.layout().n;
  Vector coordinates;
  flow_->move(flow_->table(h_, x), start_, loads_, coordinates);
  Vector rows = phase_->columns() * coordinates;
  for (Index j = 0; j < n; ++j) {
    const DirectionCurve seen = coordinate(j);
    rows[j] -= seen.position(x);
    rows[n + j] -= seen.rate(x);
  }
  return norm(rows) <= tolerance_ * largest_;
}

void MomentStep::sum_lacks() {
  for (const std::size_t c : list_)
    if (courses_[c].changes())
      for (Index d = 0; d < contacts_.directions(c); ++d)
        courses_[c].sum_lacks(*equations_.contacts().pairs()[c].law, static_cast<std::size_t>(d),
                              moments_.row(contacts_.first(c) + d).data(), response_);
}

// Within the step the motion under the true forces deviates from that under their polynomials: to
// first order by what the difference of the two makes of free masses.
Vector MomentStep::rows_at(double x) const {
  Vector coordinates;
  flow_->move(flow_->table(h_, x), start_, loads_, coordinates);
  Vector rows = phase_->columns() * coordinates;
  const Index n = equations_.layout().n;
  for (const std::size_t c : list_) {
    if (!courses_[c].changes())
      continue;
    for (Index d = 0; d < contacts_.directions(c); ++d) {
      const Index row = contacts_.first(c) + d;
      const auto lacking =
          courses_[c].lacking(*equations_.contacts().pairs()[c].law, static_cast<std::size_t>(d),
                              moments_.row(row).data(), x, response_);
      const Vector response =
          contacts_.rows.row(row).transpose().cwiseQuotient(equations_.model().mass());
      rows.head(n) += h_ * h_ * lacking[1] * response;
      rows.segment(n, n) += h_ * lacking[0] * response;
    }
  }
  return rows;
}

} // namespace vibroimpact::motion
