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
// Of a key that acts on nothing but bodies at rest: what the state changes by when the key goes to
// its neighbours, over the change of the state in the part. Less is rounding.
constexpr double least_effect = 1e-12;

// Since the gap vanished.
double mean_gap_rate(const Equations &equations, const JointInterval &interval) {
  const contact::LocalState local =
      equations.local_state(*interval.steep, interval.start,
                            ConstVectorView(interval.state.data(), interval.state.size()));
  return interval.zero == interval.start ? local.gap_rate
                                         : local.gap / (interval.start - *interval.zero);
}

} // namespace

JointRates::JointRates(const JointInterval &interval, const Equations &equations,
                       const std::vector<KeyTangent *> &keys, const Vector &scale,
                       const Matrix &columns)
    : interval_(interval), equations_(equations), keys_(keys), scale_(scale), n_(scale.size()),
      full_(interval.state), full_rates_(equations.layout().size()) {
  if (interval.steep) {
    power_ = 8;
    first_rate_ = mean_gap_rate(equations, interval);
  }
  if (interval.zero) {
    first_root_ = root_of(interval.start - *interval.zero);
    root_span_ = root_of(interval.end - *interval.zero) - first_root_;
  }
  if (SplitJacobian::is_possible(equations))
    split_.emplace(equations, scale);
  const Index n = n_;
  equations.rates(interval.start, ConstVectorView(full_.data(), full_.size()),
                  VectorView(full_rates_.data(), full_rates_.size()));
  const Vector change = (interval.far_state - interval.state).head(n).cwiseAbs() +
                        std::abs(interval.length()) * full_rates_.head(n).cwiseAbs();
  state_size_ =
      std::max(scale.cwiseProduct(change).maxCoeff(),
               least_change * scale.cwiseProduct(interval.state.head(n)).cwiseAbs().maxCoeff());
  state_size_ = state_size_ > 0 ? state_size_ : 1;
  sizes_ = (scale.asDiagonal() * columns).cwiseAbs().colwise().maxCoeff();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    double &size = sizes_[columns.cols() - static_cast<Index>(keys.size() - k)];
    size = std::max({size, growth_by(*keys[k]), least_effect * state_size_ / keys[k]->reach()}) /
           key_weight;
  }
  // A reset can wipe a deviation out, and a stiff contact lets one die out.
  sizes_ = (sizes_.array() > least_size).select(sizes_, 1);
}

// How large a column becomes by the key alone. At either end a contact may have no force yet.
double JointRates::growth_by(const KeyTangent &key) const {
  double growth = 0;
  for (const double part : {0.0, 0.5, 1.0}) {
    const double time = interval_.start + part * interval_.length();
    const Vector rates = key.rates(equations_, time, state_near(time));
    growth = std::max(growth, scale_.head(n_).cwiseProduct(rates).cwiseAbs().maxCoeff());
  }
  return std::abs(interval_.length()) * growth;
}

// By the cubic through coordinates and velocities at both known instants. A straight line would
// miss a contact that lasts from one to the other.
Vector JointRates::state_near(double time) const {
  const Vector &first = interval_.state;
  const Vector &last = interval_.far_state;
  const double h = interval_.far - interval_.start;
  const double t = (time - interval_.start) / h;
  const Index n = equations_.layout().n;
  const auto q = [n](const Vector &state) { return state.head(n); };
  const auto v = [n](const Vector &state) { return state.segment(n, n); };
  const Vector change = q(last) - q(first);
  const Vector bend = h * (v(first) + v(last)) - 2 * change;     // of t^3
  const Vector turn = 3 * change - h * (2 * v(first) + v(last)); // of t^2
  Vector state = (1 - t) * first + t * last;
  state.head(n) = q(first) + t * (h * v(first) + t * (turn + t * bend));
  state.segment(n, n) = v(first) + t / h * (2 * turn + 3 * t * bend);
  return state;
}

Matrix JointRates::pack(const Matrix &columns) const {
  return scale_.asDiagonal() * columns * sizes_.cwiseInverse().asDiagonal();
}

Matrix JointRates::unpack(const Matrix &packed) const {
  return scale_.cwiseInverse().asDiagonal() * packed * sizes_.asDiagonal();
}

double JointRates::root_of(double time) const { return std::pow(std::abs(time), 1.0 / power_); }

double JointRates::root_at(double s) const { return first_root_ + s * root_span_; }

double JointRates::time_at(double s) const {
  if (!interval_.zero)
    return interval_.start + interval_.length() * s;
  return *interval_.zero + std::copysign(std::pow(root_at(s), power_), interval_.length());
}

double JointRates::rate_at(double s) const {
  if (!interval_.zero)
    return interval_.length();
  return std::copysign(power_ * std::pow(root_at(s), power_ - 1) * root_span_, interval_.length());
}

Vector JointRates::state_after(ConstVectorView change) const {
  Vector state = interval_.state;
  state.head(n_) += state_size_ * change.head(n_).cwiseQuotient(scale_);
  return state;
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
  double trace =
      split_->apply(time_at(s), ConstVectorView(full_.data(), full_.size()), columns, product);
  if (interval_.steep)
    trace += add_carried_slopes(columns, product);
  product *= rate;
  return rate * trace;
}

void JointRates::evaluate_jacobian(double s, Value &value) {
  const Index n = n_rows();
  equations_.jacobian(time_at(s), ConstVectorView(full_.data(), full_.size()), jacobian_);
  if (interval_.steep) {
    const RowVector &row = equations_.contacts().pairs()[*interval_.steep].gap.row;
    const Index v = equations_.layout().velocity();
    auto accelerations = jacobian_.middleRows(v, row.size());
    accelerations.leftCols(row.size()) += carried_.by_gap * carried_.response * row;
    accelerations.middleCols(v, row.size()) += carried_.by_gap_rate * carried_.response * row;
  }
  value.jacobian = rate_at(s) * (scale_.asDiagonal() * jacobian_.topLeftCorner(n, n) *
                                 scale_.cwiseInverse().asDiagonal());
}

void JointRates::evaluate_rates(double s, ConstVectorView change, Value &value) {
  leave_if_stopped();
  const Index n = n_rows();
  const double rate = rate_at(s);
  const double time = time_at(s);
  full_.head(n) = interval_.state.head(n) + state_size_ * change.head(n).cwiseQuotient(scale_);
  const ConstVectorView state(full_.data(), full_.size());
  equations_.rates(time, state, VectorView(full_rates_.data(), full_rates_.size()));
  value.keys.resize(n, static_cast<Index>(keys_.size()));
  for (std::size_t k = 0; k < keys_.size(); ++k)
    value.keys.col(static_cast<Index>(k)) = keys_[k]->rates(equations_, time, full_);
  value.state.resize(n_states());
  if (interval_.steep)
    take_carried_gap(s, first_rate_ * (1 + change[n]), value);
  value.state.head(n) = rate / state_size_ * scale_.cwiseProduct(full_rates_.head(n));
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    auto column = value.keys.col(static_cast<Index>(k));
    column = (rate / sizes_[n_columns() - static_cast<Index>(keys_.size() - k)] *
              scale_.cwiseProduct(column))
                 .eval();
  }
}

// Its force and slopes instead of those of the gap that the coordinates have.
void JointRates::take_carried_gap(double s, double mean_rate, Value &value) {
  const std::size_t c = *interval_.steep;
  const contact::ContactPair &pair = equations_.contacts().pairs()[c];
  const int mode = equations_.modes()[c];
  const double time = time_at(s);
  const double root = root_at(s);
  const ConstVectorView state(full_.data(), full_.size());
  contact::LocalState local = equations_.local_state(c, time, state);
  pair.law->evaluate(mode, local, by_state_);
  local.gap = mean_rate * std::copysign(std::pow(root, power_), interval_.length());
  pair.law->evaluate(mode, local, by_gap_);
  value.state[n_] =
      root == 0 ? 0 : power_ * root_span_ / root * (local.gap_rate - mean_rate) / first_rate_;
  carried_ = {.by_gap = by_gap_.force_by_gap - by_state_.force_by_gap,
              .by_gap_rate = by_gap_.force_by_gap_rate - by_state_.force_by_gap_rate,
              .response = equations_.response_to(pair.gap.row, time, state)};
  const Index v = equations_.layout().velocity();
  const Index size = pair.gap.row.size();
  full_rates_.segment(v, size) += (by_gap_.force - by_state_.force) * carried_.response;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    value.keys.col(static_cast<Index>(k)).segment(v, size) +=
        (carried_.by_gap * keys_[k]->gap(c, time, full_) +
         carried_.by_gap_rate * keys_[k]->gap_rate(c, time, full_)) *
        carried_.response;
}

// In scaled entries. Returns what they add to the trace.
double JointRates::add_carried_slopes(const Eigen::Ref<const Matrix> &columns,
                                      Eigen::Ref<Matrix> product) const {
  const RowVector &row = equations_.contacts().pairs()[*interval_.steep].gap.row;
  const Index v = equations_.layout().velocity();
  const Index size = row.size();
  const RowVector of_gap = row.cwiseQuotient(scale_.head(size).transpose());
  const RowVector of_rate = row.cwiseQuotient(scale_.segment(v, size).transpose());
  product.middleRows(v, size) += scale_.segment(v, size).cwiseProduct(carried_.response) *
                                 (carried_.by_gap * (of_gap * columns.topRows(size)) +
                                  carried_.by_gap_rate * (of_rate * columns.middleRows(v, size)));
  return carried_.by_gap_rate * row.dot(carried_.response);
}

} // namespace vibroimpact::motion
