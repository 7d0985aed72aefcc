#include "analyses/basins/start_box.h"

#include "common/error.h"
#include "contact/same_law.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

// Of initial states at equally spaced values of a key, relative to the largest of them: a reading
// of texts with units leaves a few roundings.
constexpr double proportional = 1e-12;

Vector state_of(const model::InitialState &initial) {
  Vector state(initial.displacement.size() + initial.velocity.size());
  state << initial.displacement, initial.velocity;
  return state;
}

bool same_history(const model::TimeFunction &a, const model::TimeFunction &b) {
  if (a.period() != b.period() || a.highest_frequency() != b.highest_frequency())
    return false;
  for (int i = 0; i < 7; ++i) {
    const double time = (i + 0.3) / 7 * (a.period() > 0 ? a.period() : 1);
    if (a.value(time) != b.value(time) || a.rate(time) != b.rate(time) ||
        a.acceleration(time) != b.acceleration(time))
      return false;
  }
  return true;
}

bool same_contacts(const contact::ContactSet &a, const contact::ContactSet &b, double size) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    const contact::ContactPair &one = a.pairs()[c], &other = b.pairs()[c];
    if (one.gap.base_coefficients != other.gap.base_coefficients ||
        !same_law(*one.law, *other.law, size))
      return false;
  }
  return true;
}

using Overrides = std::vector<parameters::Override>;

Overrides with(Overrides overrides, const Overrides &more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

Overrides lower_ends(const std::vector<SweptParameter> &keys) {
  Overrides ends;
  for (const SweptParameter &key : keys)
    ends.push_back(key.at(key.values.front()));
  return ends;
}

Overrides middles(const std::vector<SweptParameter> &keys) {
  Overrides middles;
  for (const SweptParameter &key : keys)
    middles.push_back(key.at(0.5 * (key.values.front() + key.values.back())));
  return middles;
}

void refuse_start_key(const SweptParameter &key) {
  throw InputError(key.origin + " the key " + key.path +
                   " must change initial conditions only, and these in proportion.");
}

} // namespace

StartBox::StartBox(const std::vector<SweptParameter> &keys, const Overrides &fixed,
                   const SystemSource &build)
    : system_(build(with(fixed, lower_ends(keys)))), origin_(state_of(system_.initial)),
      slopes_(origin_.size(), static_cast<Index>(keys.size())),
      size_(origin_.cwiseAbs().maxCoeff()) {
  Vector expected = origin_;
  std::vector<System> others;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    Overrides ends = lower_ends(keys);
    ends[k] = keys[k].at(keys[k].values.back());
    others.push_back(build(with(fixed, ends)));
    const Vector end = state_of(others.back().initial);
    slopes_.col(static_cast<Index>(k)) = end - origin_;
    expected += 0.5 * (end - origin_);
    size_ = std::max(size_, end.cwiseAbs().maxCoeff());
  }
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (!same_motions(system_, others[k], size_ > 0 ? size_ : 1))
      refuse_start_key(keys[k]);
  const Vector middle = state_of(build(with(fixed, middles(keys))).initial);
  if (!((middle - expected).cwiseAbs().maxCoeff() <= proportional * size_))
    refuse_start_key(keys.front());
}

model::InitialState StartBox::start(const Vector &shares) const {
  const Vector state = origin_ + slopes_ * shares;
  const Index n = state.size() / 2;
  return {.displacement = state.head(n), .velocity = state.tail(n)};
}

bool same_motions(const System &a, const System &b, double size) {
  if (motion::structure_of(a.model, a.contacts) != motion::structure_of(b.model, b.contacts) ||
      motion::data_of(a.model, a.contacts) != motion::data_of(b.model, b.contacts))
    return false;
  const auto &one = a.model.sources(), &other = b.model.sources();
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const model::Source &x, const model::Source &y) {
                      return same_history(*x.function, *y.function);
                    }) &&
         same_contacts(a.contacts, b.contacts, size);
}

} // namespace vibroimpact::analyses
