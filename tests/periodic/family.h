// Forced oscillators along keys, for tests of continuation problems.
#pragma once

#include "forced_models.h"
#include "periodic/open_contact.h"
#include "periodic/orbit_problem.h"

#include <functional>
#include <map>

namespace vibroimpact::testing {

/// An oscillator for any values of its keys, without looking for its symmetry unless wanted.
class Family : public periodic::MapAlongKeys {
public:
  using Make = std::function<Oscillator(const Vector &keys)>;
  explicit Family(Make make, bool symmetric = true)
      : make_(std::move(make)), symmetric_(symmetric) {}
  /// Along one key.
  explicit Family(const std::function<Oscillator(double)> &make, bool symmetric = true)
      : Family(Make([make](const Vector &keys) { return make(keys[0]); }), symmetric) {}

  const periodic::StroboscopicMap &at(double value) { return at(Vector::Constant(1, value)); }
  const periodic::StroboscopicMap &at(const Vector &keys) override {
    if (!present_ || values_ != keys) {
      overlooking_.clear();
      present_ = std::make_unique<Member>(make_, keys, symmetric_);
      values_ = keys;
    }
    return present_->forced->map;
  }
  const periodic::StroboscopicMap &overlooking(const Vector &keys,
                                               const periodic::Overlooked &overlooked) override {
    at(keys);
    std::unique_ptr<Member> &member = overlooking_[overlooked];
    if (!member)
      member = std::make_unique<Member>(
          [this, overlooked](const Vector &at) {
            Oscillator oscillator = make_(at);
            oscillator.contacts = periodic::overlooking(oscillator.contacts, overlooked);
            return oscillator;
          },
          keys, false);
    return member->forced->map;
  }

private:
  struct Member {
    Member(const Make &make, const Vector &values, bool symmetric)
        : oscillator(make(values)), forced(std::make_unique<ForcedMap>(oscillator, symmetric)) {
      std::vector<periodic::ForcedKey *> list;
      for (Index k = 0; k < values.size(); ++k) {
        keys.push_back(std::make_unique<periodic::ForcedKey>(
            periodic::forced_key("key", forced->system, neighbours(make, values, k))));
        list.push_back(keys.back().get());
      }
      forced->map.set_keys(std::move(list));
    }
    static std::vector<motion::KeyNeighbour> neighbours(const Make &make, const Vector &values,
                                                        Index key) {
      std::vector<motion::KeyNeighbour> list;
      for (const double place : {-2e-3, -1e-3, 1e-3, 2e-3}) {
        Vector moved = values;
        moved[key] *= 1 + place;
        Oscillator near = make(moved);
        list.push_back(motion::KeyNeighbour::of(place * values[key], std::move(near.model),
                                                std::move(near.contacts)));
      }
      return list;
    }
    Oscillator oscillator;
    std::unique_ptr<ForcedMap> forced;
    std::vector<std::unique_ptr<periodic::ForcedKey>> keys;
  };

  Make make_;
  bool symmetric_;
  std::unique_ptr<Member> present_;
  std::map<periodic::Overlooked, std::unique_ptr<Member>> overlooking_;
  Vector values_;
};

} // namespace vibroimpact::testing
