#include "contact/same_law.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace vibroimpact::contact {

namespace {

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

bool same_guards(const Mode &a, const Mode &b, const LocalState &state) {
  if (a.guards.size() != b.guards.size() || a.in_contact != b.in_contact ||
      a.holds_gap != b.holds_gap || a.holds_slip != b.holds_slip)
    return false;
  for (std::size_t g = 0; g < a.guards.size(); ++g) {
    const Guard &one = a.guards[g], &other = b.guards[g];
    if (one.target != other.target || one.action != other.action ||
        one.reset.size() != other.reset.size() ||
        !near(one.indicator(state), other.indicator(state)))
      return false;
    for (std::size_t i = 0; i < one.reset.size(); ++i)
      if (!near(one.reset[i](state), other.reset[i](state)))
        return false;
  }
  return true;
}

bool same_response(const ContactLaw &a, const ContactLaw &b, int mode, const LocalState &state) {
  LawResponse one, other;
  a.evaluate(mode, state, one);
  b.evaluate(mode, state, other);
  for (int k = 0; k < a.n_tangential(); ++k)
    if (const auto place = static_cast<std::size_t>(k);
        !near(one.tangential[place].force, other.tangential[place].force))
      return false;
  return near(one.force, other.force) &&
         std::equal(one.internal_rate.begin(), one.internal_rate.end(), other.internal_rate.begin(),
                    other.internal_rate.end(), near);
}

} // namespace

bool same_law(const ContactLaw &a, const ContactLaw &b, double size) {
  if (a.name() != b.name() || a.modes().size() != b.modes().size() ||
      a.initial_internal() != b.initial_internal() || a.n_tangential() != b.n_tangential())
    return false;
  std::mt19937_64 generator(20); // NOLINT(cert-msc51-cpp): the same states in every run
  const auto random = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; };
  for (int i = 0; i < 5; ++i) {
    std::vector<double> internal(a.initial_internal().size());
    for (double &value : internal)
      value = size * random();
    LocalState state{.gap = size * random(), .gap_rate = size * random(), .internal = internal};
    for (int k = 0; k < a.n_tangential(); ++k)
      state.tangential[static_cast<std::size_t>(k)] = {
          .slip = size * random(), .slip_rate = size * random(), .force = random()};
    for (std::size_t mode = 0; mode < a.modes().size(); ++mode)
      if (!same_guards(a.modes()[mode], b.modes()[mode], state) ||
          !same_response(a, b, static_cast<int>(mode), state))
        return false;
    if (a.rigid() &&
        (!near(a.restitution(std::abs(state.gap_rate)), b.restitution(std::abs(state.gap_rate))) ||
         a.hypothesis() != b.hypothesis()))
      return false;
  }
  return true;
}

} // namespace vibroimpact::contact
