#include "motion/variation/joint_rates.h"

#include "common/signals.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Of the state, relative to itself: what changes less is near equilibrium, and its rates are
// differences of larger terms.
constexpr double least_change = 1e-3;
// Of a column: the inverse of a smaller one could overflow.
constexpr double least_size = 1e-200;
// Rates by keys have the rounding of differences of models, of about 1e-12, which is no error that
// shorter steps would make smaller.
constexpr double key_weight = 0.01;

double fourth_root(double x) { return std::sqrt(std::sqrt(std::abs(x))); }

} // namespace

JointRates::JointRates(const Interval &interval, const Vector &end_state,
                       const Equations &equations, const std::vector<KeyTangent *> &keys,
                       const Vector &scale, const Matrix &columns)
    : interval_(interval), equations_(equations), keys_(keys), scale_(scale), full_(interval.state),
      full_rates_(equations.layout().size()) {
  if (interval.zero) {
    first_root_ = fourth_root(interval.start - *interval.zero);
    root_span_ = fourth_root(interval.end - *interval.zero) - first_root_;
  }
  if (SplitJacobian::is_possible(equations))
    split_.emplace(equations, scale);
  const Index n = scale.size();
  equations.rates(interval.start, ConstVectorView(full_.data(), full_.size()),
                  VectorView(full_rates_.data(), full_rates_.size()));
  const Vector change = (end_state - interval.state).head(n).cwiseAbs() +
                        std::abs(interval.length()) * full_rates_.head(n).cwiseAbs();
  state_size_ =
      std::max(scale.cwiseProduct(change).maxCoeff(),
               least_change * scale.cwiseProduct(interval.state.head(n)).cwiseAbs().maxCoeff());
  state_size_ = state_size_ > 0 ? state_size_ : 1;
  sizes_ = (scale.asDiagonal() * columns).cwiseAbs().colwise().maxCoeff();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    double &size = sizes_[columns.cols() - static_cast<Index>(keys.size() - k)];
    const Vector rates = keys[k]->rates(equations, interval.start, full_);
    size = std::max(size,
                    std::abs(interval.length()) * scale.cwiseProduct(rates).cwiseAbs().maxCoeff()) /
           key_weight;
  }
  // A reset can wipe a deviation out, and a stiff contact lets one die out.
  sizes_ = (sizes_.array() > least_size).select(sizes_, 1);
}

Matrix JointRates::pack(const Matrix &columns) const {
  return scale_.asDiagonal() * columns * sizes_.cwiseInverse().asDiagonal();
}

Matrix JointRates::unpack(const Matrix &packed) const {
  return scale_.cwiseInverse().asDiagonal() * packed * sizes_.asDiagonal();
}

double JointRates::root_at(double s) const { return first_root_ + s * root_span_; }

double JointRates::time_at(double s) const {
  if (!interval_.zero)
    return interval_.start + interval_.length() * s;
  return *interval_.zero + std::copysign(std::pow(root_at(s), 4), interval_.length());
}

double JointRates::rate_at(double s) const {
  if (!interval_.zero)
    return interval_.length();
  return std::copysign(4 * std::pow(root_at(s), 3) * root_span_, interval_.length());
}

void JointRates::evaluate(double s, ConstVectorView change, Value &value) {
  evaluate_rates(s, change, value);
  evaluate_jacobian(s, value);
}

double JointRates::evaluate(double s, ConstVectorView change, Value &value,
                            const Eigen::Ref<const Matrix> &columns, Eigen::Ref<Matrix> product) {
  evaluate_rates(s, change, value);
  if (!split_) {
    evaluate_jacobian(s, value);
    product.noalias() = value.jacobian * columns;
    return value.jacobian.trace();
  }
  const double rate = rate_at(s);
  const double trace =
      split_->apply(time_at(s), ConstVectorView(full_.data(), full_.size()), columns, product);
  product *= rate;
  return rate * trace;
}

void JointRates::evaluate_jacobian(double s, Value &value) {
  const Index n = n_states();
  equations_.jacobian(time_at(s), ConstVectorView(full_.data(), full_.size()), jacobian_);
  value.jacobian = rate_at(s) * (scale_.asDiagonal() * jacobian_.topLeftCorner(n, n) *
                                 scale_.cwiseInverse().asDiagonal());
}

void JointRates::evaluate_rates(double s, ConstVectorView change, Value &value) {
  leave_if_stopped();
  const Index n = n_states();
  const double rate = rate_at(s);
  const double time = time_at(s);
  full_.head(n) =
      interval_.state.head(n) + state_size_ * scale_.cwiseInverse().cwiseProduct(change);
  const ConstVectorView state(full_.data(), full_.size());
  equations_.rates(time, state, VectorView(full_rates_.data(), full_rates_.size()));
  value.state = rate / state_size_ * scale_.cwiseProduct(full_rates_.head(n));
  value.keys.resize(n, static_cast<Index>(keys_.size()));
  for (std::size_t k = 0; k < keys_.size(); ++k)
    value.keys.col(static_cast<Index>(k)) =
        rate / sizes_[n_columns() - static_cast<Index>(keys_.size() - k)] *
        scale_.cwiseProduct(keys_[k]->rates(equations_, time, full_));
}

} // namespace vibroimpact::motion
