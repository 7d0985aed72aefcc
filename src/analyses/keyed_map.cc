#include "analyses/keyed_map.h"

#include "analyses/key_neighbours.h"
#include "analyses/swept_system.h"
#include "common/error.h"
#include "periodic/open_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

using periodic::ForcedSystem;
using periodic::StroboscopicMap;
using periodic::Symmetry;

KeyedMap::KeyedMap(std::vector<SweptParameter> keys, const std::string &excitation, System &system,
                   const LineContext &context, motion::VariationAccuracy accuracy, double size)
    : keys_(std::move(keys)), excitation_(excitation), original_(system), context_(context),
      accuracy_(std::move(accuracy)), present_(&system) {
  find_symmetry(size);
}

// A key that changes one of two equal stops takes the symmetry away.
void KeyedMap::find_symmetry(double size) {
  std::optional<Symmetry> common;
  const std::size_t corners = std::size_t{1} << keys_.size();
  for (std::size_t corner = corners; corner-- > 0;) {
    Vector values(static_cast<Index>(keys_.size()));
    for (std::size_t k = 0; k < keys_.size(); ++k)
      values[static_cast<Index>(k)] =
          (corner >> k & 1) != 0 ? keys_[k].values.back() : keys_[k].values.front();
    move_to(values);
    const std::optional<Symmetry> here = Symmetry::find(*maps_.forced, accuracy_.scale, size);
    if (!here || (common && !(*here == *common)))
      return;
    common = here;
  }
  symmetry_ = common;
}

std::vector<parameters::Override> KeyedMap::overrides(const Vector &values) const {
  std::vector<parameters::Override> list;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    if (!keys_[k].is_frequency())
      list.push_back(keys_[k].at(values[static_cast<Index>(k)]));
  return list;
}

void KeyedMap::set_frequency(System &system, const Vector &values) const {
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    if (!keys_[k].is_frequency())
      continue;
    const double value = values[static_cast<Index>(k)];
    // The model would keep a frequency that it cannot have.
    if (!(value > 0))
      throw NumericalError("there is no motion at a frequency of " + std::to_string(value) + " Hz");
    system.model.set_frequency(sweep_source(system, excitation_, "A branch"),
                               2 * std::numbers::pi * value);
  }
}

void KeyedMap::make_forced(Maps &maps) const {
  if (maps.forced)
    return;
  const contact::ContactSet &contacts = maps.contacts ? *maps.contacts : present_->contacts;
  maps.forced = std::make_unique<ForcedSystem>(present_->model, contacts, present_->integration,
                                               sweep_source(*present_, excitation_, "A branch"));
  if (maps.forced->layout().physical_size() != accuracy_.scale.size())
    throw InputError("the key " + keys_.front().path + (keys_.size() > 1 ? " or " : "") +
                     (keys_.size() > 1 ? keys_.back().path : "") +
                     " must not change the number of coordinates");
}

// A system is built anew unless the frequency alone has changed.
void KeyedMap::move_to(const Vector &values) {
  values_.reset();
  const auto same = [](const parameters::Override &a, const parameters::Override &b) {
    return a.value == b.value;
  };
  std::vector<parameters::Override> wanted = overrides(values);
  if (!std::equal(wanted.begin(), wanted.end(), built_with_.begin(), built_with_.end(), same)) {
    overlooking_.clear();
    maps_ = {};
    built_with_.clear();
    built_ = std::make_unique<System>(context_.build(wanted));
    built_with_ = std::move(wanted);
    present_ = built_.get();
  }
  set_frequency(*present_, values);
  maps_.keys.clear();
  for (auto &[overlooked, maps] : overlooking_)
    maps.keys.clear();
  make_forced(maps_);
}

std::vector<motion::KeyNeighbour> KeyedMap::neighbours(const Vector &values, Index key) const {
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
  std::vector<motion::KeyNeighbour> list = frequency_neighbours(*present_, maps_.forced->source());
  for (motion::KeyNeighbour &neighbour : list)
    neighbour.offset /= 2 * std::numbers::pi; // per hertz
  return list;
}

KeyedMap::Neighbours KeyedMap::neighbours(const Vector &values) const {
  Neighbours list;
  for (Index key = 0; key < values.size(); ++key)
    list.push_back(neighbours(values, key));
  return list;
}

void KeyedMap::finish(Maps &maps, Neighbours neighbours) const {
  if (!maps.map)
    maps.map = std::make_unique<StroboscopicMap>(*maps.forced, accuracy_, symmetry_);
  std::vector<periodic::ForcedKey *> keys;
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    maps.keys.push_back(std::make_unique<periodic::ForcedKey>(
        forced_key(keys_[k].axis_name(), *maps.forced, std::move(neighbours[k]))));
    keys.push_back(maps.keys.back().get());
  }
  maps.map->set_keys(std::move(keys));
}

// The end of a key is where its system may end too: rounding leads to no value beyond it.
Vector KeyedMap::within_ends(Vector values) const {
  constexpr double rounding = 1e-11; // of the range
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    const double first = keys_[k].values.front(), last = keys_[k].values.back();
    double &value = values[static_cast<Index>(k)];
    const double inside = std::clamp(value, first, last);
    if (std::abs(value - inside) <= rounding * (last - first))
      value = inside;
  }
  return values;
}

const StroboscopicMap &KeyedMap::at(const Vector &point) {
  const Vector values = within_ends(point);
  if (values_ && *values_ == values)
    return *maps_.map;
  try {
    move_to(values);
    finish(maps_, neighbours(values));
  } catch (const InputError &error) {
    throw NumericalError(error.what());
  }
  values_ = values;
  return *maps_.map;
}

const StroboscopicMap &KeyedMap::overlooking(const Vector &values,
                                             const periodic::Overlooked &overlooked) {
  at(values);
  Maps &maps = overlooking_[overlooked];
  if (!maps.keys.empty())
    return *maps.map;
  if (!maps.contacts)
    maps.contacts = std::make_unique<contact::ContactSet>(
        periodic::overlooking(present_->contacts, overlooked));
  make_forced(maps);
  Neighbours near = neighbours(within_ends(values));
  for (std::vector<motion::KeyNeighbour> &along_one : near)
    for (motion::KeyNeighbour &neighbour : along_one)
      neighbour.contacts = periodic::overlooking(neighbour.contacts, overlooked);
  finish(maps, std::move(near));
  return *maps.map;
}

} // namespace vibroimpact::analyses
