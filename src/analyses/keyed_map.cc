#include "analyses/keyed_map.h"

#include "analyses/key_neighbours.h"
#include "analyses/swept_system.h"
#include "common/error.h"
#include "periodic/open_contact.h"

#include <numbers>

namespace vibroimpact::analyses {

using periodic::ForcedSystem;
using periodic::StroboscopicMap;
using periodic::Symmetry;

KeyedMap::KeyedMap(const SweptParameter &parameter, const std::string &excitation, System &system,
                   const LineContext &context, motion::VariationAccuracy accuracy, double size)
    : parameter_(parameter), excitation_(excitation), original_(system), context_(context),
      accuracy_(std::move(accuracy)), present_(&system) {
  find_symmetry(size);
}

// A key that changes one of two equal stops takes the symmetry away.
void KeyedMap::find_symmetry(double size) {
  move_to(parameter_.values.back());
  const std::optional<Symmetry> last = Symmetry::find(*maps_.forced, accuracy_.scale, size);
  if (!last)
    return;
  move_to(parameter_.values.front());
  const std::optional<Symmetry> first = Symmetry::find(*maps_.forced, accuracy_.scale, size);
  if (first == last)
    symmetry_ = first;
}

void KeyedMap::build(double value) {
  open_.clear();
  maps_ = {};
  built_ = std::make_unique<System>(context_.build({parameter_.at(value)}));
  present_ = built_.get();
}

void KeyedMap::make_forced(Maps &maps) const {
  if (maps.forced)
    return;
  const contact::ContactSet &contacts = maps.contacts ? *maps.contacts : present_->contacts;
  maps.forced = std::make_unique<ForcedSystem>(present_->model, contacts, present_->integration,
                                               sweep_source(*present_, excitation_, "A branch"));
  if (maps.forced->layout().physical_size() != accuracy_.scale.size())
    throw InputError("the key " + parameter_.path + " changes the number of coordinates");
}

void KeyedMap::move_to(double value) {
  value_.reset();
  // The model would keep a frequency that it cannot have.
  if (parameter_.is_frequency() && !(value > 0))
    throw NumericalError("there is no motion at a frequency of " + std::to_string(value) + " Hz");
  if (parameter_.is_frequency())
    original_.model.set_frequency(sweep_source(original_, excitation_, "A branch"),
                                  2 * std::numbers::pi * value);
  else
    build(value);
  maps_.key.reset();
  for (auto &[contact, maps] : open_)
    maps.key.reset();
  make_forced(maps_);
}

std::vector<motion::KeyNeighbour> KeyedMap::neighbours(double value) const {
  if (!parameter_.is_frequency())
    return key_neighbours(parameter_, value,
                          [this](const auto &overrides) { return context_.build(overrides); });
  std::vector<motion::KeyNeighbour> list = frequency_neighbours(*present_, maps_.forced->source());
  for (motion::KeyNeighbour &neighbour : list)
    neighbour.offset /= 2 * std::numbers::pi; // per hertz
  return list;
}

void KeyedMap::finish(Maps &maps, std::vector<motion::KeyNeighbour> neighbours) const {
  if (!maps.map)
    maps.map = std::make_unique<StroboscopicMap>(*maps.forced, accuracy_, symmetry_);
  maps.key = std::make_unique<periodic::ForcedKey>(
      forced_key(parameter_.axis_name(), *maps.forced, std::move(neighbours)));
  maps.map->set_key(maps.key.get());
}

const StroboscopicMap &KeyedMap::at(double value) {
  if (value_ == value)
    return *maps_.map;
  try {
    move_to(value);
    finish(maps_, neighbours(value));
  } catch (const InputError &error) {
    throw NumericalError(error.what());
  }
  value_ = value;
  return *maps_.map;
}

const StroboscopicMap &KeyedMap::with_open(double value, std::size_t contact) {
  at(value);
  Maps &maps = open_[contact];
  if (maps.key)
    return *maps.map;
  if (!maps.contacts)
    maps.contacts =
        std::make_unique<contact::ContactSet>(periodic::with_open(present_->contacts, contact));
  make_forced(maps);
  std::vector<motion::KeyNeighbour> near = neighbours(value);
  for (motion::KeyNeighbour &neighbour : near)
    neighbour.contacts = periodic::with_open(neighbour.contacts, contact);
  finish(maps, std::move(near));
  return *maps.map;
}

} // namespace vibroimpact::analyses
