// Forced oscillators along a key, for tests of continuation problems.
#pragma once

#include "forced_models.h"
#include "periodic/open_contact.h"
#include "periodic/orbit_problem.h"

#include <functional>
#include <map>

namespace vibroimpact::testing {

/// An oscillator for each value of a key, without looking for its symmetry unless wanted.
class Family : public periodic::MapAlongKeys {
public:
  explicit Family(std::function<Oscillator(double)> make, bool symmetric = true)
      : make_(std::move(make)), symmetric_(symmetric) {}

  const periodic::StroboscopicMap &at(double value) { return at(Vector::Constant(1, value)); }
  const periodic::StroboscopicMap &at(const Vector &keys) override {
    const double value = keys[0];
    if (value_ != value || !present_) {
      open_.clear();
      present_ = std::make_unique<Member>(make_, value, symmetric_);
      value_ = value;
    }
    return present_->forced->map;
  }
  const periodic::StroboscopicMap &with_open(const Vector &keys, std::size_t contact) override {
    const double value = keys[0];
    at(value);
    std::unique_ptr<Member> &member = open_[contact];
    if (!member)
      member = std::make_unique<Member>(
          [this, contact](double at) {
            Oscillator oscillator = make_(at);
            oscillator.contacts = periodic::with_open(oscillator.contacts, contact);
            return oscillator;
          },
          value, false);
    return member->forced->map;
  }

private:
  struct Member {
    Member(const std::function<Oscillator(double)> &make, double value, bool symmetric)
        : oscillator(make(value)), forced(std::make_unique<ForcedMap>(oscillator, symmetric)) {
      std::vector<motion::KeyNeighbour> neighbours;
      for (const double place : {-2e-3, -1e-3, 1e-3, 2e-3}) {
        Oscillator near = make(value * (1 + place));
        neighbours.push_back({.offset = place * value,
                              .model = std::move(near.model),
                              .contacts = std::move(near.contacts)});
      }
      key = std::make_unique<periodic::ForcedKey>(
          periodic::forced_key("key", forced->system, std::move(neighbours)));
      forced->map.set_keys({key.get()});
    }
    Oscillator oscillator;
    std::unique_ptr<ForcedMap> forced;
    std::unique_ptr<periodic::ForcedKey> key;
  };

  std::function<Oscillator(double)> make_;
  bool symmetric_;
  std::unique_ptr<Member> present_;
  std::map<std::size_t, std::unique_ptr<Member>> open_;
  double value_ = 0;
};

} // namespace vibroimpact::testing
