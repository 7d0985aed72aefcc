#include "analyses/keys/keyed_system.h"

#include "common/error.h"
#include "periodic/forced_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

// Of the value. Differences by it are exact to its fourth power, and what rounding leaves of them
// is divided by it.
constexpr double relative_step = 1e-3;

constexpr std::array<std::array<double, 4>, 3> sides = {
    {{-2, -1, 1, 2}, {1, 2, 3, 4}, {-4, -3, -2, -1}}};

std::size_t only_periodic(const std::vector<model::Source> &sources) {
  if (sources.size() == 1)
    return 0;
  std::size_t found = sources.size();
  for (std::size_t s = 0; s < sources.size(); ++s)
    if (sources[s].function->period() > 0) {
      if (found < sources.size())
        return sources.size();
      found = s;
    }
  return found;
}

} // namespace

std::size_t sweep_source(const System &system, const std::string &name, const std::string &who) {
  const std::vector<model::Source> &sources = system.model.sources();
  const std::size_t found = name.empty() ? only_periodic(sources) : system.model.find_source(name);
  if (found == sources.size())
    throw InputError(name.empty()
                         ? who + " must have one periodic excitation, or the key Excitation where "
                                 "there are several."
                         : "Excitation must name an active excitation, which " + name + " is not.");
  if (!(sources[found].function->period() > 0))
    throw InputError("The excitation " + sources[found].name +
                     " has no frequency; its History must be harmonic or ramped harmonic.");
  return found;
}

std::optional<std::size_t> period_source(const System &system, const std::string &name,
                                         const std::string &who) {
  if (name.empty() && periodic::is_autonomous(system.model))
    return std::nullopt;
  return sweep_source(system, name, who);
}

std::vector<motion::KeyNeighbour> key_neighbours(const SweptParameter &key, double value,
                                                 const SystemSource &build) {
  const double step = relative_step * (value != 0 ? std::abs(value) : key.magnitude());
  for (std::size_t side = 0;; ++side) {
    try {
      std::vector<motion::KeyNeighbour> neighbours;
      for (const double place : sides[side]) {
        System system = build({key.at(value + place * step)});
        neighbours.push_back(motion::KeyNeighbour::of(place * step, std::move(system.model),
                                                      std::move(system.contacts)));
      }
      return neighbours;
    } catch (const InputError &) {
      if (side + 1 == sides.size())
        throw;
    }
  }
}

std::vector<motion::KeyNeighbour> frequency_neighbours(const std::shared_ptr<const System> &system,
                                                       std::size_t source) {
  const double omega = 2 * std::numbers::pi / system->model.sources()[source].function->period();
  std::vector<motion::KeyNeighbour> neighbours;
  for (const double place : sides.front()) {
    const double offset = place * relative_step * omega;
    neighbours.push_back(
        {.offset = offset / (2 * std::numbers::pi),
         .model = {system, &system->model},
         .contacts = {system, &system->contacts},
         .frequency = motion::SourceFrequency{.source = source, .angular = omega + offset}});
  }
  return neighbours;
}

KeyedSystem::KeyedSystem(std::vector<SweptParameter> keys, std::string excitation, std::string who,
                         System &system, const LineContext &context)
    : keys_(std::move(keys)), excitation_(std::move(excitation)), who_(std::move(who)),
      context_(context), present_(std::shared_ptr<System>(), &system) {}

std::vector<parameters::Override> KeyedSystem::overrides(const Vector &values) const {
  std::vector<parameters::Override> list;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    if (!keys_[k].is_frequency())
      list.push_back(keys_[k].at(values[static_cast<Index>(k)]));
  return list;
}

void KeyedSystem::set_frequency(System &system, const Vector &values) const {
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    if (!keys_[k].is_frequency())
      continue;
    const double value = values[static_cast<Index>(k)];
    // The model would keep a frequency that it cannot have.
    if (!(value > 0))
      throw NumericalError("there is no motion at a frequency of " + std::to_string(value) + " Hz");
    system.model.set_frequency(sweep_source(system, excitation_, who_),
                               2 * std::numbers::pi * value);
  }
}

// A system is built anew unless the frequency alone has changed.
bool KeyedSystem::move_to(const Vector &values) {
  const auto same = [](const parameters::Override &a, const parameters::Override &b) {
    return a.value == b.value;
  };
  std::vector<parameters::Override> wanted = overrides(values);
  const bool another =
      !std::equal(wanted.begin(), wanted.end(), built_with_.begin(), built_with_.end(), same);
  if (another) {
    present_ = std::make_shared<System>(context_.build(wanted));
    built_with_ = std::move(wanted);
  }
  set_frequency(*present_, values);
  return another;
}

std::vector<motion::KeyNeighbour> KeyedSystem::neighbours(const Vector &values, Index key) const {
  const SweptParameter &parameter = keys_[static_cast<std::size_t>(key)];
  if (!parameter.is_frequency())
    return key_neighbours(parameter, values[key], [&](const auto &moved) {
      std::vector<parameters::Override> all = overrides(values);
      for (parameters::Override &one : all)
        if (one.path == parameter.path)
          one = moved.front();
      System system = context_.build(all);
      set_frequency(system, values);
      return system;
    });
  return frequency_neighbours(present_, source());
}

} // namespace vibroimpact::analyses
