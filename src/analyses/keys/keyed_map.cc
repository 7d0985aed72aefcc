#include "analyses/keys/keyed_map.h"

#include "common/error.h"
#include "periodic/open_contact.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using periodic::ForcedSystem;
using periodic::StroboscopicMap;
using periodic::Symmetry;

KeyedMap::KeyedMap(std::vector<SweptParameter> keys, const std::string &excitation, System &system,
                   const LineContext &context, motion::VariationAccuracy accuracy, double size,
                   std::shared_ptr<periodic::FreePeriod> period)
    : keyed_(std::move(keys), excitation, "A branch", system, context), free_(std::move(period)),
      accuracy_(std::move(accuracy)) {
  if (free_) {
    Vector ranges(static_cast<Index>(keyed_.keys().size()));
    for (Index k = 0; k < ranges.size(); ++k) {
      const std::vector<double> &values = keyed_.keys()[static_cast<std::size_t>(k)].values;
      ranges[k] = values.back() - values.front();
    }
    free_->set_key_sizes(std::move(ranges));
  }
  find_symmetry(size);
}

// A key that changes one of two equal stops takes the symmetry away.
void KeyedMap::find_symmetry(double size) {
  std::optional<Symmetry> common;
  const std::size_t corners = std::size_t{1} << keyed_.keys().size();
  for (std::size_t corner = corners; corner-- > 0;) {
    Vector values(static_cast<Index>(keyed_.keys().size()));
    for (std::size_t k = 0; k < keyed_.keys().size(); ++k)
      values[static_cast<Index>(k)] =
          (corner >> k & 1) != 0 ? keyed_.keys()[k].values.back() : keyed_.keys()[k].values.front();
    move_to(values);
    const std::optional<Symmetry> here = Symmetry::find(*maps_.forced, accuracy_.scale, size);
    if (!here || (common && !(*here == *common)))
      return;
    common = here;
  }
  symmetry_ = common;
}

void KeyedMap::make_forced(Maps &maps) const {
  if (maps.forced)
    return;
  const System &present = system();
  const contact::ContactSet &contacts = maps.contacts ? *maps.contacts : present.contacts;
  maps.forced =
      free_ ? std::make_unique<ForcedSystem>(present.model, contacts, present.integration, free_)
            : std::make_unique<ForcedSystem>(present.model, contacts, present.integration,
                                             keyed_.source());
  if (maps.forced->layout().physical_size() == accuracy_.scale.size())
    return;
  const std::vector<SweptParameter> &keys = keyed_.keys();
  throw InputError("the key " + keys.front().path + (keys.size() > 1 ? " or " : "") +
                   (keys.size() > 1 ? keys.back().path : "") +
                   " must not change the number of coordinates");
}

void KeyedMap::move_to(const Vector &values) {
  values_.reset();
  const std::shared_ptr<System> before = keyed_.system(); // until what refers to it has gone
  if (keyed_.move_to(values)) {
    overlooking_.clear();
    maps_ = {};
  }
  maps_.keys.clear();
  for (auto &[overlooked, maps] : overlooking_)
    maps.keys.clear();
  make_forced(maps_);
}

KeyedMap::Neighbours KeyedMap::neighbours(const Vector &values) const {
  Neighbours list;
  for (Index key = 0; key < values.size(); ++key)
    list.push_back(keyed_.neighbours(values, key));
  return list;
}

void KeyedMap::finish(Maps &maps, Neighbours neighbours) const {
  if (!maps.map)
    maps.map = std::make_unique<StroboscopicMap>(*maps.forced, accuracy_, symmetry_);
  std::vector<periodic::ForcedKey *> keys;
  for (std::size_t k = 0; k < keyed_.keys().size(); ++k) {
    maps.keys.push_back(std::make_unique<periodic::ForcedKey>(
        forced_key(keyed_.keys()[k].axis_name(), *maps.forced, std::move(neighbours[k]))));
    keys.push_back(maps.keys.back().get());
  }
  maps.map->set_keys(std::move(keys));
}

// The end of a key is where its system may end too: rounding leads to no value beyond it.
Vector KeyedMap::within_ends(Vector values) const {
  constexpr double rounding = 1e-11; // of the range
  for (std::size_t k = 0; k < keyed_.keys().size(); ++k) {
    const double first = keyed_.keys()[k].values.front(), last = keyed_.keys()[k].values.back();
    double &value = values[static_cast<Index>(k)];
    const double inside = std::clamp(value, first, last);
    if (std::abs(value - inside) <= rounding * (last - first))
      value = inside;
  }
  return values;
}

const StroboscopicMap &KeyedMap::at(const Vector &point) {
  const Vector values = within_ends(point);
  if (free_)
    free_->recall(values);
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
  const auto overlooking_some = [&](const contact::ContactSet &contacts) {
    return std::make_shared<const contact::ContactSet>(periodic::overlooking(contacts, overlooked));
  };
  if (!maps.contacts)
    maps.contacts = overlooking_some(system().contacts);
  make_forced(maps);
  Neighbours near = neighbours(within_ends(values));
  for (std::vector<motion::KeyNeighbour> &along_one : near)
    for (motion::KeyNeighbour &neighbour : along_one)
      neighbour.contacts = neighbour.contacts.get() == &system().contacts
                               ? maps.contacts
                               : overlooking_some(*neighbour.contacts);
  finish(maps, std::move(near));
  return *maps.map;
}

} // namespace vibroimpact::analyses
