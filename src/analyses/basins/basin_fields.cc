#include "analyses/basins/basin_fields.h"

#include "analyses/results/fields.h"

#include <algorithm>

namespace vibroimpact::analyses {

double mark_of(const periodic::Decision &decision, std::size_t known) {
  if (decision.outcome == periodic::Outcome::failed)
    return no_motion;
  if (decision.outcome == periodic::Outcome::undecided)
    return undecided;
  return decision.attractor < known ? static_cast<double>(decision.attractor) : another;
}

void add_shares(const FieldWriter &result, const std::vector<double> &marks, std::size_t known,
                const std::string &of) {
  const auto share = [&](double mark) {
    return static_cast<double>(std::count(marks.begin(), marks.end(), mark)) /
           static_cast<double>(marks.size());
  };
  std::vector<double> shares;
  for (std::size_t a = 0; a < known; ++a)
    shares.push_back(share(static_cast<double>(a)));
  result.series("attractors/share", "attractor", std::move(shares), "1",
                "share of " + of + " that lead to it");
  result.number("undecided_share", share(undecided), "1",
                "share of " + of + " that no motion had caught in time");
  result.number("no_motion_share", share(no_motion), "1",
                "share of " + of +
                    " at which no motion starts, or that end with a "
                    "numerical failure");
}

void add_attractors(const FieldWriter &result, const BasinSearch &search, std::size_t known) {
  std::vector<double> multiples, moduli, states;
  for (std::size_t a = 0; a < known; ++a) {
    const periodic::Attractor &attractor = search.attractors().list()[a];
    multiples.push_back(static_cast<double>(attractor.motion.multiple));
    moduli.push_back(attractor.multipliers.cwiseAbs().maxCoeff());
    const Vector state = search.state(attractor);
    states.insert(states.end(), state.begin(), state.end());
  }
  result.series("attractors/period_multiple", "attractor", std::move(multiples), "1",
                "forcing periods after which the motion repeats itself");
  result.series("attractors/largest_multiplier", "attractor", std::move(moduli), "1",
                "largest modulus of its multipliers");
  static const Label state("attractors/state", "SI",
                           "state of the motion at the forcing phase of time zero: coordinates, "
                           "their rates, internal states of contacts",
                           {"attractor", "state"});
  result.array(state, {known, static_cast<std::size_t>(search.states())}, std::move(states));
}

} // namespace vibroimpact::analyses
