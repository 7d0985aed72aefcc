#include "contact/laws/table_spring.h"

#include <utility>

namespace vibroimpact::contact {

namespace {

std::vector<Mode> segments_of(const ForceCurve &tension) {
  std::vector<Mode> modes;
  for (std::size_t s = 0; s < tension.n_segments(); ++s) {
    const int mode = static_cast<int>(s);
    modes.push_back({.name = "segment " + std::to_string(s + 1),
                     .in_contact = true,
                     .affine = AffineLaw{
                         .force = {.constant = -tension.intercept(s), .gap = -tension.slope(s)}}});
    if (s > 0)
      modes.back().guards.push_back(
          {.indicator = {.constant = -tension.lengths()[s], .gap = 1}, .target = mode - 1});
    if (s + 1 < tension.n_segments())
      modes.back().guards.push_back(
          {.indicator = {.constant = tension.lengths()[s + 1], .gap = -1}, .target = mode + 1});
  }
  return modes;
}

} // namespace

TableSpring::TableSpring(ForceCurve tension)
    : ContactLaw(segments_of(tension), {}), tension_(std::move(tension)),
      energy_at_zero_(tension_.area(0)) {}

int TableSpring::initial_mode(const LocalState &state) const {
  return static_cast<int>(tension_.segment(state.gap));
}

void TableSpring::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const auto segment = static_cast<std::size_t>(mode);
  const double slope = tension_.slope(segment);
  response.force = -tension_.intercept(segment) - slope * state.gap;
  response.force_by_gap = -slope;
  response.force_by_gap_rate = 0;
  response.stored_energy = tension_.area(state.gap, segment) - energy_at_zero_;
  response.dissipated_power = 0;
}

} // namespace vibroimpact::contact
