#include "analyses/curves/self_excited_map.h"

#include "analyses/curves/orbit_start.h"
#include "common/error.h"
#include "periodic/open_contact.h"

#include <numbers>

namespace vibroimpact::analyses {

using contact::ContactSet;
using periodic::ForcedSystem;

namespace {

// Of the angular frequency. Damping is linear in the rate, so that differences are exact.
constexpr double rate_step = 1e-3;
constexpr double rate_places[] = {-2, -1, 1, 2};

} // namespace

SelfExcitedMap::SelfExcitedMap(const System &system, FileDamping damping,
                               std::shared_ptr<periodic::FreePeriod> period, const Vector &largest)
    : given_(system), damping_(damping), period_(std::move(period)),
      natural_(2 * std::numbers::pi / period_->period()), present_(excited(0)) {
  const std::shared_ptr<const ContactSet> contacts(present_, &present_->contacts);
  ForcedSystem forced(present_->model, *contacts, present_->integration, period_);
  accuracy_ = orbit_accuracy(*present_, forced);
  const auto scale = accuracy_.scale.head(largest.size());
  symmetry_ = periodic::Symmetry::find(forced, accuracy_.scale,
                                       largest.cwiseProduct(scale).cwiseAbs().maxCoeff());
  maps_ = maps_with(contacts);
}

std::shared_ptr<const System> SelfExcitedMap::excited(double rate) const {
  auto system = std::make_shared<System>(given_);
  system->model.change_damping(damping_ == FileDamping::kept ? 1 : 0, rate);
  return system;
}

SelfExcitedMap::Maps SelfExcitedMap::maps_with(std::shared_ptr<const ContactSet> contacts) const {
  Maps maps;
  maps.contacts = std::move(contacts);
  maps.forced = std::make_unique<ForcedSystem>(present_->model, *maps.contacts,
                                               present_->integration, period_);
  maps.map = std::make_unique<periodic::StroboscopicMap>(*maps.forced, accuracy_, symmetry_);
  if (damping_ == FileDamping::left_out)
    return maps;
  std::vector<motion::KeyNeighbour> neighbours;
  for (const double place : rate_places) {
    const double offset = place * rate_step * natural_;
    const std::shared_ptr<const System> near = excited(rate_ + offset);
    neighbours.push_back(
        {.offset = offset, .model = {near, &near->model}, .contacts = maps.contacts});
  }
  maps.key = std::make_unique<periodic::ForcedKey>(
      periodic::forced_key("self-excitation", *maps.forced, std::move(neighbours)));
  maps.map->set_keys({maps.key.get()});
  return maps;
}

const periodic::StroboscopicMap &SelfExcitedMap::at(const Vector &keys) {
  if (keys[0] == rate_)
    return *maps_.map;
  if (damping_ == FileDamping::left_out)
    throw NumericalError("a system without damping is not excited");
  overlooking_.clear();
  maps_ = {};
  rate_ = keys[0];
  present_ = excited(rate_);
  maps_ = maps_with({present_, &present_->contacts});
  return *maps_.map;
}

const periodic::StroboscopicMap &
SelfExcitedMap::overlooking(const Vector &keys, const periodic::Overlooked &overlooked) {
  at(keys);
  Maps &maps = overlooking_[overlooked];
  if (!maps.map)
    maps = maps_with(
        std::make_shared<const ContactSet>(periodic::overlooking(present_->contacts, overlooked)));
  return *maps.map;
}

} // namespace vibroimpact::analyses
