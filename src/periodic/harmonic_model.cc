#include "periodic/harmonic_model.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "continuation/harmonic_series.h"
#include "periodic/forced_system.h"
#include "periodic/harmonic_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::periodic {

using continuation::ForceSeries;
using continuation::HarmonicEquations;
using std::numbers::pi;

namespace {

constexpr const char *refusal = "A harmonic balance is asked for, but ";

std::vector<const model::Connection *> cubic_springs(const model::Model &model) {
  std::vector<const model::Connection *> list;
  for (const model::Connection &connection : model.connections())
    if (connection.cubic_stiffness != 0)
      list.push_back(&connection);
  return list;
}

// By equal samples, which are exact for harmonics below their number less H.
RowVector series_of(const model::TimeFunction &function, double period, Index harmonics) {
  const Index samples = 4 * harmonics + 61;
  RowVector series = RowVector::Zero(2 * harmonics + 1);
  for (Index i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(samples);
    series +=
        function.value(share * period) * (2 * pi / static_cast<double>(samples)) *
        continuation::harmonic_projection(continuation::harmonic_basis(2 * pi * share, harmonics))
            .transpose();
  }
  return series;
}

// Compared at instants of which none is a sample.
bool is_series(const model::TimeFunction &function, double period, const RowVector &series) {
  constexpr double rounding = 1e-9;
  const Index harmonics = continuation::harmonics_of(series.size());
  const Index instants = 4 * harmonics + 67;
  double size = 0, difference = 0;
  for (Index i = 0; i < instants; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(instants);
    const double value = function.value(share * period);
    const double sum = series.dot(continuation::harmonic_basis(2 * pi * share, harmonics));
    size = std::max({size, std::abs(value), std::abs(sum)});
    difference = std::max(difference, std::abs(value - sum));
  }
  return difference <= rounding * size;
}

void check_sources(const model::Model &model, std::size_t source, Index harmonics) {
  const double period = ForcedSystem::period_of(model, source);
  for (const model::Source &other : model.sources())
    if (!is_series(*other.function, period, series_of(*other.function, period, harmonics)))
      throw InputError(refusal + ("the excitation " + other.name) + " is not made of the first " +
                       std::to_string(harmonics) + " harmonics of " + model.sources()[source].name +
                       "; more Harmonics may hold it.");
}

// Where the constant part has no stiffness, the balance cannot be solved for it.
void check_supports(const model::Model &model) {
  const Vector scale = model.mass().cwiseSqrt().cwiseInverse();
  const Matrix stiffness = scale.asDiagonal() * model.stiffness().dense() * scale.asDiagonal();
  if (!is_invertible(stiffness))
    throw InputError(refusal + std::string("the bodies can move without any force, since no "
                                           "spring or support holds them."));
}

} // namespace

Index default_intervals(Index harmonics) { return std::max<Index>(16, 4 * harmonics); }

const HarmonicGrid &HarmonicGrids::at(Index harmonics) {
  const Index share = (harmonics + harmonics_ - 1) / harmonics_;
  return grids_.try_emplace(harmonics, harmonics, share * intervals_).first->second;
}

void check_harmonic(const model::Model &model, const contact::ContactSet &contacts,
                    std::size_t source, Index harmonics) {
  if (!model.rotors().empty())
    throw InputError(refusal + std::string("the model has a rotor: its speed is a second "
                                           "frequency, so that the motion has no period."));
  for (const model::Spin &spin : model.spins())
    if (!spin.speed.constant())
      throw InputError(refusal + ("the Spin " + spin.name) + " has a Run-up: its speed changes.");
  for (const contact::ContactPair &pair : contacts.pairs()) {
    if (pair.law->rigid())
      throw InputError(refusal + ("the contact " + pair.name) + " is rigid (Law = " +
                       pair.law->name() + "): its force is no function of time.");
    if (pair.circle)
      throw InputError(refusal + ("the contact " + pair.name) +
                       " has a circular gap, for which it is not built.");
    if (!pair.tangential.empty())
      throw InputError(refusal + ("the contact " + pair.name) +
                       " has friction, for which it is not built.");
  }
  if (contacts.size() == 0 && model.linear())
    throw InputError(refusal + std::string("the model has no contact and no cubic spring; its "
                                           "linear response is Type = frequency response."));
  check_sources(model, source, harmonics);
  check_supports(model);
}

HarmonicModel::HarmonicModel(const model::Model &model, const contact::ContactSet &contacts,
                             std::size_t source, HarmonicGrids &grids, Index harmonics)
    : model_{model}, contacts_{contacts}, source_{source}, grids_{grids}, harmonics_{harmonics},
      sources_(static_cast<Index>(model.sources().size()), 2 * harmonics + 1), cubic_{cubic_springs(
                                                                                   model)} {
  const double period = ForcedSystem::period_of(model, source);
  for (std::size_t s = 0; s < model.sources().size(); ++s)
    sources_.row(static_cast<Index>(s)) =
        series_of(*model.sources()[s].function, period, harmonics);
}

double HarmonicModel::frequency() const {
  return 2 * pi / ForcedSystem::period_of(model_, source_);
}

RowVector HarmonicModel::observed(const model::Projection &projection,
                                  const Matrix &coordinates) const {
  RowVector series = continuation::with_harmonics(projection.row * coordinates,
                                                  continuation::harmonics_of(coordinates.cols()));
  for (std::size_t s = 0; s < projection.base_coefficients.size(); ++s)
    series.leftCols(sources_.cols()) +=
        projection.base_coefficients[s] * sources_.row(static_cast<Index>(s));
  return series;
}

HarmonicEquations HarmonicModel::equations() const {
  const Index n = model_.size();
  const auto elements = static_cast<Index>(contacts_.size() + cubic_.size());
  HarmonicEquations equations{.mass = model_.mass().asDiagonal(),
                              .damping = model_.damping().dense(),
                              .stiffness = model_.stiffness().dense(),
                              .frequency = frequency(),
                              .load = Matrix::Zero(n, sources_.cols()),
                              .rows = Matrix(elements, n),
                              .offset = Matrix(elements, sources_.cols())};
  const Matrix rate = equations.frequency * continuation::harmonic_rate(harmonics_);
  for (std::size_t s = 0; s < model_.sources().size(); ++s) {
    const model::Source &source = model_.sources()[s];
    const RowVector series = sources_.row(static_cast<Index>(s));
    equations.load += source.load * series + source.rate_load * (series * rate) +
                      source.inertial_load * (series * rate * rate);
  }
  const Matrix rest = Matrix::Zero(n, sources_.cols());
  Index element = 0;
  const auto add = [&](const model::Projection &projection) {
    equations.rows.row(element) = projection.row;
    equations.offset.row(element++) = observed(projection, rest);
  };
  for (const contact::ContactPair &pair : contacts_.pairs())
    add(pair.gap);
  for (const model::Connection *spring : cubic_)
    add(spring->elongation);
  return equations;
}

ForceSeries HarmonicModel::force(Index element, const RowVector &displacement, bool slopes) const {
  const auto place = static_cast<std::size_t>(element);
  return place < contacts_.size() ? contact_force(place, displacement, slopes)
                                  : spring_force(*cubic_[place - contacts_.size()], displacement);
}

// A normal force opens the gap, so that on the left-hand side it counts as negative.
ForceSeries HarmonicModel::contact_force(std::size_t contact, const RowVector &opening,
                                         bool slopes) const {
  const contact::ContactPair &pair = contacts_.pairs()[contact];
  RowVector gap = opening;
  gap(0) += pair.clearance;
  const HarmonicGrid &grid = grids_.at(continuation::harmonics_of(opening.size()));
  const ContactSeries series = contact_series(pair, gap, frequency(), grid, slopes);
  return {.force = -series.force, .by_displacement = -series.by_gap, .largest = series.largest};
}

// k3 e^3
ForceSeries HarmonicModel::spring_force(const model::Connection &spring,
                                        const RowVector &elongation) const {
  const HarmonicGrid &grid = grids_.at(continuation::harmonics_of(elongation.size()));
  ForceSeries result{.force = RowVector::Zero(grid.coefficients()),
                     .by_displacement = Matrix::Zero(grid.coefficients(), grid.coefficients())};
  for (Index i = 0; i < grid.intervals(); ++i) {
    const auto basis = grid.basis(i);
    for (Index k = 0; k < HarmonicGrid::nodes; ++k) {
      const double e = elongation.dot(basis.col(k));
      const double force = spring.cubic_stiffness * e * e * e;
      const Vector weight = grid.length() * HarmonicGrid::weights()(k) *
                            continuation::harmonic_projection(basis.col(k));
      result.force += force * weight.transpose();
      result.by_displacement.noalias() +=
          (3 * spring.cubic_stiffness * e * e) * weight * basis.col(k).transpose();
      result.largest = std::max(result.largest, std::abs(force));
    }
  }
  return result;
}

} // namespace vibroimpact::periodic
