#include "analyses/basin_fields.h"

#include "analyses/fields.h"

#include <algorithm>

namespace vibroimpact::analyses {

double mark_of(const periodic::Decision &decision, std::size_t known) {
  if (decision.outcome == periodic::Outcome::failed)
    return no_motion;
  if (decision.outcome == periodic::Outcome::undecided)
    return undecided;
  return decision.attractor < known ? static_cast<double>(decision.attractor) : another;
}

Field attractor_field(const std::string &name, std::vector<double> values, const std::string &unit,
                      const std::string &description) {
  return series_field("attractors/" + name, "attractor", std::move(values), unit, description);
}

void add_shares(PointResult &result, const std::vector<double> &marks, std::size_t known,
                const std::string &of) {
  const auto share = [&](double mark) {
    return static_cast<double>(std::count(marks.begin(), marks.end(), mark)) /
           static_cast<double>(marks.size());
  };
  std::vector<double> shares;
  for (std::size_t a = 0; a < known; ++a)
    shares.push_back(share(static_cast<double>(a)));
  result.fields.push_back(
      attractor_field("share", std::move(shares), "1", "share of " + of + " that lead to it"));
  result.fields.push_back(scalar_field("undecided_share", share(undecided), "1",
                                       "share of " + of + " that no motion had caught in time"));
  result.fields.push_back(scalar_field("no_motion_share", share(no_motion), "1",
                                       "share of " + of +
                                           " at which no motion starts, or that end with a "
                                           "numerical failure"));
}

void add_attractors(PointResult &result, const BasinSearch &search, std::size_t known) {
  std::vector<double> multiples, moduli, states;
  for (std::size_t a = 0; a < known; ++a) {
    const periodic::Attractor &attractor = search.attractors().list()[a];
    multiples.push_back(static_cast<double>(attractor.motion.multiple));
    moduli.push_back(attractor.multipliers.cwiseAbs().maxCoeff());
    const Vector state = search.state(attractor);
    states.insert(states.end(), state.begin(), state.end());
  }
  result.fields.push_back(attractor_field("period_multiple", std::move(multiples), "1",
                                          "forcing periods after which the motion repeats itself"));
  result.fields.push_back(attractor_field("largest_multiplier", std::move(moduli), "1",
                                          "largest modulus of its multipliers"));
  static const Label state("attractors/state", "SI",
                           "state of the motion at the forcing phase of time zero: coordinates, "
                           "their rates, internal states of contacts",
                           {"attractor", "state"});
  result.fields.push_back({.label = state,
                           .shape = {known, static_cast<std::size_t>(search.states())},
                           .values = std::move(states)});
}

} // namespace vibroimpact::analyses
