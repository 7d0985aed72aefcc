#include "periodic/forced_system.h"

#include "common/error.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vibroimpact::periodic {

namespace {

// Instants of a period at which sources are compared: a prime number, so that they do not fall on
// the zeros of a harmonic.
constexpr int symmetry_instants = 61;
constexpr double rounding = 1e-9; // of a source that is evaluated periods after time zero

// s(t + shift) = sign s(t) with its derivatives, over one period.
bool repeats(const model::TimeFunction &function, double period, double shift, double sign) {
  std::array<double, 3> size{}, difference{};
  for (int i = 0; i < symmetry_instants; ++i) {
    const double t = period * i / symmetry_instants;
    const std::array<double, 3> now = {function.value(t), function.rate(t),
                                       function.acceleration(t)};
    const std::array<double, 3> later = {function.value(t + shift), function.rate(t + shift),
                                         function.acceleration(t + shift)};
    for (std::size_t k = 0; k < 3; ++k) {
      size[k] = std::max({size[k], std::abs(now[k]), std::abs(later[k])});
      difference[k] = std::max(difference[k], std::abs(later[k] - sign * now[k]));
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (difference[k] > rounding * size[k])
      return false;
  return true;
}

bool runs_up(const model::Model &model) {
  return std::any_of(model.spins().begin(), model.spins().end(),
                     [](const model::Spin &spin) { return !spin.speed.constant(); });
}

void refuse_rotors(const model::Model &model) {
  if (!model.rotors().empty())
    throw InputError("A periodic motion is looked for, but the model has a rotor: its speed is a "
                     "second frequency, so that the motion repeats itself after no period.");
  if (runs_up(model))
    throw InputError(
        "A periodic motion is looked for, but a Spin has a Run-up: its speed changes.");
}

void refuse_rigid_rings(const contact::ContactSet &contacts) {
  for (const contact::ContactPair &pair : contacts.pairs())
    if (pair.circle && pair.law->rigid())
      throw InputError("A periodic motion is looked for, but the contact " + pair.name +
                       " has rigid sides in a circular gap (Law = " + pair.law->name() +
                       "): motions with it have no known derivative. Use a law with a finite "
                       "force.");
}

bool is_constant(const model::TimeFunction &function) {
  return function.period() == 0 && function.highest_frequency() == 0 &&
         !std::isfinite(function.next_break(0)) && function.rate(0) == 0 &&
         function.acceleration(0) == 0 && function.rate(1) == 0;
}

} // namespace

ForcedSystem::ForcedSystem(const model::Model &model, const contact::ContactSet &contacts,
                           const motion::Settings &settings, std::size_t source)
    : model_(model), contacts_(contacts), source_(source), trajectory_(model, contacts, settings) {
  refuse_rotors(model);
  refuse_rigid_rings(contacts);
  if (const model::Source *other = source_without_period(model, period()))
    throw InputError("A periodic motion is looked for, but the excitation " + other->name +
                     " does not repeat itself after the period of " + model.sources()[source].name +
                     ".");
}

ForcedSystem::ForcedSystem(const model::Model &model, const contact::ContactSet &contacts,
                           const motion::Settings &settings, std::shared_ptr<FreePeriod> period)
    : model_(model), contacts_(contacts), free_(std::move(period)),
      trajectory_(model, contacts, settings) {
  refuse_rotors(model);
  refuse_rigid_rings(contacts);
}

namespace {

double period_by_key(const ForcedSystem &system, std::size_t source,
                     const std::vector<motion::KeyNeighbour> &neighbours) {
  std::vector<double> offsets;
  for (const motion::KeyNeighbour &neighbour : neighbours)
    offsets.push_back(neighbour.offset);
  const Vector weights = motion::derivative_weights(offsets);
  double derivative = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    derivative += weights[static_cast<Index>(i)] *
                  (neighbours[i].histories()[source]->period() - system.period());
  return derivative;
}

} // namespace

ForcedKey forced_key(const std::string &name, const ForcedSystem &system,
                     std::vector<motion::KeyNeighbour> neighbours) {
  const double derivative =
      system.source() ? period_by_key(system, *system.source(), neighbours) : 0;
  return {.tangent =
              motion::KeyTangent(name, system.model(), system.contacts(), std::move(neighbours)),
          .period = derivative};
}

const model::Source *source_without_period(const model::Model &model, double period) {
  const auto harmonic = [&](const model::TimeFunction &function) { // known without looking
    return function.harmonic() && std::abs(function.period() - period) <= 1e-12 * period;
  };
  for (const model::Source &source : model.sources())
    if (!harmonic(*source.function) && !repeats(*source.function, period, period, 1))
      return &source;
  return nullptr;
}

bool is_autonomous(const model::Model &model) {
  return std::all_of(model.sources().begin(), model.sources().end(),
                     [](const model::Source &source) { return is_constant(*source.function); });
}

bool forcing_is_odd(const ForcedSystem &system) {
  const std::vector<model::Source> &sources = system.model().sources();
  return std::all_of(sources.begin(), sources.end(), [&](const model::Source &source) {
    return repeats(*source.function, system.period(), system.period() / 2, -1);
  });
}

} // namespace vibroimpact::periodic
