#include "motion/path/exact_segment.h"

#include "common/decompositions.h"
#include "reduction/known_flexibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

// Largest (t (1 - t))^p / (2p)! and its derivatives on [0, 1], for p = 5 and p = 4.
constexpr double value_error = 2.692e-10, rate_error = 1.121e-9, acceleration_error = 1.077e-8;
constexpr double first_order_value_error = 9.69e-8, first_order_rate_error = 3.70e-7;

} // namespace

ExactSegment::ExactSegment(const Equations &equations, const ExactPhase &phase, double tolerance,
                           double longest)
    : phase_(phase), layout_(equations.layout()), tolerance_(tolerance), longest_(longest) {
  list_measures(equations);
  renew();
}

// The coordinates of a body that are its modes are measured together: what a high mode does by
// itself is nothing that anyone sees.
void ExactSegment::list_measures(const Equations &equations) {
  const model::Model &model = equations.model();
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    for (Index j = 0; j < model.bodies()[b]->size(); ++j) {
      measures_.push_back({.row = model.offset(b) + j, .into = n_second_});
      if (!reduction::has_modes(*model.bodies()[b]) || j + 1 == model.bodies()[b]->size())
        ++n_second_;
    }
  for (std::size_t k = 0; k < model.sources().size(); ++k)
    measures_.push_back(
        {.row = layout_.physical_size() + 3 * static_cast<Index>(k), .into = n_second_++});
  for (Index i = layout_.internal(); i < layout_.physical_size(); ++i)
    measures_.push_back({.row = i, .into = n_second_ + n_first_++, .first_order = true});
}

void ExactSegment::renew() {
  const Index units = phase_.view().n_groups;
  for (Matrix &sizes : sizes_)
    sizes.setZero(n_second_ + n_first_, units);
  magnitudes_.resize(units);
  fastest_growth_ = 0;
  for (const PhaseGroup &group : phase_.groups())
    measure(group);
}

void ExactSegment::add_sizes(const Measure &of, Index unit, const std::array<double, 4> &sizes) {
  for (std::size_t k = 0; k < sizes.size(); ++k)
    sizes_[k](of.into, unit) += sizes[k];
}

void ExactSegment::measure(const PhaseGroup &group) {
  if (group.kind == BlockKind::dense) {
    measure_dense(group);
    return;
  }
  fastest_growth_ = std::max(fastest_growth_, group.exponent.real());
  const double e = std::abs(group.exponent);
  for (const Measure &of : measures_) {
    double size = phase_.columns()(of.row, group.coordinates[0]);
    if (group.kind == BlockKind::pair)
      size = std::hypot(size, phase_.columns()(of.row, group.coordinates[1]));
    size = std::abs(size);
    add_sizes(of, group.first,
              {size, size * e, size * e * e, size * std::pow(e, of.first_order ? 8 : 10)});
  }
}

// Of a block x' = B x a derivative is bounded over a step no longer than 1 / radius by those of
// higher order at its start.
void ExactSegment::measure_dense(const PhaseGroup &group) {
  const auto size = static_cast<Index>(group.coordinates.size());
  const ComplexVector exponents = eigenvalues(group.generator);
  const double radius = exponents.cwiseAbs().maxCoeff();
  fastest_growth_ = std::max(fastest_growth_, radius);
  for (const Measure &of : measures_) {
    RowVector row(size);
    for (Index c = 0; c < size; ++c)
      row[c] = phase_.columns()(of.row, group.coordinates[static_cast<std::size_t>(c)]);
    std::array<RowVector, 4> sizes;
    sizes.fill(RowVector::Zero(size));
    const int highest = of.first_order ? 8 : 10;
    double scale = 1;
    for (int order = 0; order < highest + 4; ++order, row = row * group.generator) {
      if (order < 3)
        sizes[static_cast<std::size_t>(order)] = row.cwiseAbs();
      if (order >= highest) {
        sizes[3] = sizes[3].cwiseMax(scale * row.cwiseAbs());
        scale = radius > 0 ? scale / radius : 0;
      }
    }
    for (Index c = 0; c < size; ++c)
      add_sizes(of, group.first + c, {sizes[0][c], sizes[1][c], sizes[2][c], sizes[3][c]});
  }
}

// The longest step by one kind of error, factor errors h^power <= tolerance sizes.
double ExactSegment::allowed(const Vector &sizes, const Vector &errors, double factor,
                             int power) const {
  double worst = 0;
  for (Index i = 0; i < sizes.size(); ++i)
    if (sizes[i] > 0)
      worst = std::max(worst, errors[i] / sizes[i]);
  return worst > 0 ? std::pow(tolerance_ / (factor * worst), 1.0 / power)
                   : std::numeric_limits<double>::infinity();
}

void ExactSegment::take_magnitudes(const double *amplitudes) {
  const PhaseView &view = phase_.view();
  for (int j = 0; j < view.n_groups; ++j)
    magnitudes_[j] =
        std::abs(amplitudes[j]) + (j < view.n_pairs ? std::abs(amplitudes[view.n_padded + j]) : 0);
}

void ExactSegment::begin(const double *amplitudes, bool anew) {
  constexpr double counts = 1e-3;
  take_magnitudes(amplitudes);
  for (std::size_t k = 0; k < reached_.size(); ++k) {
    errors_.noalias() = sizes_[k] * magnitudes_; // now
    if (!anew && reached_[k].size() == errors_.size())
      reached_[k] = errors_.cwiseMax(counts * reached_[k]);
    else
      reached_[k] = errors_;
  }
}

double ExactSegment::step(const double *amplitudes) {
  take_magnitudes(amplitudes);
  errors_.noalias() = sizes_[3] * magnitudes_;
  const auto of = [&](std::size_t k, double factor, int power) {
    return allowed(reached_[k].head(n_second_), errors_.head(n_second_), factor, power);
  };
  const auto of_first = [&](std::size_t k, double factor, int power) {
    return allowed(reached_[k].tail(n_first_), errors_.tail(n_first_), factor, power);
  };
  const double growing = fastest_growth_ > 0 ? 1 / fastest_growth_ : longest_;
  return std::min({longest_, growing, of(0, value_error, 10), of(1, rate_error, 9),
                   of(2, acceleration_error, 8), of_first(0, first_order_value_error, 8),
                   of_first(1, first_order_rate_error, 7)});
}

// x' = B x, group by group.
void ExactSegment::differentiate() {
  moved_.resize(coordinates_.size());
  for (const PhaseGroup &group : phase_.groups()) {
    const std::vector<Index> &list = group.coordinates;
    if (group.kind == BlockKind::dense) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        double rate = 0;
        for (std::size_t k = 0; k < list.size(); ++k)
          rate +=
              group.generator(static_cast<Index>(i), static_cast<Index>(k)) * coordinates_[list[k]];
        moved_[list[i]] = rate;
      }
      continue;
    }
    const bool pair = group.kind == BlockKind::pair;
    const Complex rate =
        group.exponent * Complex(coordinates_[list[0]], pair ? coordinates_[list[1]] : 0);
    moved_[list[0]] = rate.real();
    if (pair)
      moved_[list[1]] = rate.imag();
  }
  coordinates_.swap(moved_);
}

void ExactSegment::fill(double time, const double *amplitudes, EndPoint &point) {
  const Index size = layout_.physical_size();
  const Matrix &columns = phase_.columns();
  const Index n_sources = (columns.rows() - size) / 3;
  coordinates_.resize(columns.cols());
  for (Index k = 0; k < columns.cols(); ++k)
    coordinates_[k] = amplitudes[phase_.places()[static_cast<std::size_t>(k)]];
  point.time = time;
  point.state.conservativeResize(layout_.size());
  point.rates.resize(layout_.size());
  point.higher.resize(size, 2);
  point.sources.resize(static_cast<std::size_t>(n_sources));
  for (Index order = 0; order < 4; ++order) {
    rows_.noalias() = columns * coordinates_;
    if (order == 0)
      point.state.head(size) = rows_.head(size);
    else if (order == 1)
      point.rates.head(size) = rows_.head(size);
    else
      point.higher.col(order - 2) = rows_.head(size);
    for (Index k = 0; k < n_sources; ++k) {
      SourceValues &source = point.sources[static_cast<std::size_t>(k)];
      source[static_cast<std::size_t>(order)] = rows_[size + 3 * k];
      if (order == 2)
        source[4] = rows_[size + 3 * k + 2];
    }
    differentiate();
  }
}

} // namespace vibroimpact::motion
