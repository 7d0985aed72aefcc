#include "motion/variation/split_jacobian.h"

namespace vibroimpact::motion {

SplitJacobian::SplitJacobian(const Equations &equations, const Vector &scale)
    : equations_(equations), scale_(scale) {
  const StateLayout &layout = equations.layout();
  const model::Model &model = equations.model();
  const Index n = layout.n;
  const Vector of_rates = scale.segment(n, n).cwiseQuotient(model.mass());
  by_velocity_ = scale.head(n).cwiseQuotient(scale.segment(n, n));
  const Vector inverse = scale.head(2 * n).cwiseInverse();
  Matrix lower(n, 2 * n);
  lower << -model.stiffness().dense(), -model.damping().dense();
  lower = (of_rates.asDiagonal() * lower * inverse.asDiagonal()).eval();
  stiffness_ = lower.leftCols(n).diagonal();
  damping_ = lower.rightCols(n).diagonal();
  lower.leftCols(n).diagonal().setZero();
  lower.rightCols(n).diagonal().setZero();
  if (!lower.isZero(0))
    coupling_ = lower;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.inactive(c))
      continue;
    const RowVector &row = equations.contacts().pairs()[c].gap.row;
    acting_.push_back({.contact = c,
                       .by_gap = row.cwiseQuotient(scale.head(n).transpose()),
                       .by_gap_rate = row.cwiseQuotient(scale.segment(n, n).transpose()),
                       .response = of_rates.cwiseProduct(row.transpose())});
  }
}

double SplitJacobian::apply(double time, ConstVectorView state,
                            const Eigen::Ref<const Matrix> &columns,
                            Eigen::Ref<Matrix> product) const {
  const Index n = equations_.layout().n;
  product.topRows(n).noalias() = by_velocity_.asDiagonal() * columns.middleRows(n, n);
  product.middleRows(n, n) = stiffness_.asDiagonal() * columns.topRows(n) +
                             damping_.asDiagonal() * columns.middleRows(n, n);
  if (coupling_.size() > 0)
    product.middleRows(n, n).noalias() += coupling_ * columns.topRows(2 * n);
  product.bottomRows(product.rows() - 2 * n).setZero();
  double trace = damping_.sum();
  for (const Acting &acting : acting_)
    trace += add_contact(acting, time, state, columns, product);
  return trace;
}

double SplitJacobian::add_contact(const Acting &acting, double time, ConstVectorView state,
                                  const Eigen::Ref<const Matrix> &columns,
                                  Eigen::Ref<Matrix> product) const {
  const contact::ContactPair &pair = equations_.contacts().pairs()[acting.contact];
  pair.law->evaluate(equations_.modes()[acting.contact],
                     equations_.local_state(acting.contact, time, state), response_);
  const Index n = equations_.layout().n;
  const Index first = equations_.layout().internal() + pair.internal_offset;
  const int count = pair.n_internal();
  const RowVector gaps = acting.by_gap * columns.topRows(n);
  const RowVector gap_rates = acting.by_gap_rate * columns.middleRows(n, n);
  RowVector force = response_.force_by_gap * gaps + response_.force_by_gap_rate * gap_rates;
  double trace = response_.force_by_gap_rate * acting.by_gap_rate.dot(acting.response);
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    force += response_.force_by_internal[place] / scale_[first + i] * columns.row(first + i);
    RowVector rate = response_.internal_rate_by_gap[place] * gaps +
                     response_.internal_rate_by_gap_rate[place] * gap_rates;
    for (int j = 0; j < count; ++j)
      rate += response_.internal_rate_by_internal[static_cast<std::size_t>(i * count + j)] /
              scale_[first + j] * columns.row(first + j);
    product.row(first + i) = scale_[first + i] * rate;
    trace += response_.internal_rate_by_internal[static_cast<std::size_t>(i * count + i)];
  }
  product.middleRows(n, n).noalias() += acting.response * force;
  return trace;
}

} // namespace vibroimpact::motion
