#include "contact/laws/table.h"

#include "contact/laws/crushable_table.h"
#include "contact/laws/table_keys.h"

#include <utility>

namespace vibroimpact::contact {

namespace {

// Mode 0 is open; segment s acts in mode 1 + s, and without force in mode 1 + segments + s.
int acting(std::size_t segment) { return 1 + static_cast<int>(segment); }

AffineForm force_on(const ForceCurve &curve, std::size_t segment, double damping_constant) {
  return {.constant = curve.intercept(segment),
          .gap = -curve.slope(segment),
          .gap_rate = -damping_constant};
}

// The ends of a segment; `first` is the mode of segment 0 among those that it leads to.
std::vector<Guard> ends_of(const ForceCurve &curve, std::size_t segment, int first) {
  const int mode = first + static_cast<int>(segment);
  std::vector<Guard> guards = {{.indicator = {.constant = -curve.lengths()[segment], .gap = -1},
                                .target = segment == 0 ? 0 : mode - 1}};
  if (segment == 0)
    guards[0].indicator.constant = 0;
  if (segment + 1 < curve.n_segments())
    guards.push_back(
        {.indicator = {.constant = curve.lengths()[segment + 1], .gap = 1}, .target = mode + 1});
  return guards;
}

std::vector<Mode> make_modes(const ForceCurve &curve, double damping_constant, bool pulls) {
  std::vector<Mode> modes = open_and_contact();
  modes.pop_back();
  const bool cut_off = damping_constant > 0 && !pulls;
  const int apart = acting(curve.n_segments());
  for (std::size_t s = 0; s < curve.n_segments(); ++s) {
    const AffineForm force = force_on(curve, s, damping_constant);
    Mode mode{.name = "segment " + std::to_string(s + 1),
              .in_contact = true,
              .guards = ends_of(curve, s, acting(0)),
              .affine = AffineLaw{.force = force}};
    if (cut_off)
      mode.guards.push_back({.indicator = force, .target = apart + static_cast<int>(s)});
    modes.push_back(std::move(mode));
  }
  for (std::size_t s = 0; cut_off && s < curve.n_segments(); ++s) {
    Mode mode{.name = "separating " + std::to_string(s + 1),
              .in_contact = true,
              .guards = ends_of(curve, s, apart),
              .affine = AffineLaw{}};
    mode.guards.push_back(
        {.indicator = -1 * force_on(curve, s, damping_constant), .target = acting(s)});
    modes.push_back(std::move(mode));
  }
  return modes;
}

} // namespace

Table::Table(ForceCurve curve, double damping_constant, bool pulls)
    : ContactLaw(make_modes(curve, damping_constant, pulls), {}), curve_(std::move(curve)),
      damping_constant_(damping_constant), pulls_(pulls) {}

void Table::declare(parameters::Section &contact) { declare_table(contact); }

std::shared_ptr<const ContactLaw> Table::create(const parameters::Values &contact) {
  const TableKeys keys = read_table(contact);
  if (keys.crush)
    return std::make_shared<CrushableTable>(*keys.crush);
  return std::make_shared<Table>(keys.loading, keys.damping_constant, keys.pulls);
}

int Table::initial_mode(const LocalState &state) const {
  return state.gap < 0 ? acting(curve_.segment(-state.gap)) : 0;
}

void Table::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const bool acts = mode > 0 && mode < acting(curve_.n_segments());
  const std::size_t segment = acts ? static_cast<std::size_t>(mode - 1) : 0;
  const double damping_constant = acts ? damping_constant_ : 0;
  const double slope = acts ? curve_.slope(segment) : 0;
  const double push = acts ? curve_.intercept(segment) - slope * state.gap : 0;
  response.force = push - damping_constant * state.gap_rate;
  response.force_by_gap = -slope;
  response.force_by_gap_rate = -damping_constant;
  response.stored_energy = acts ? curve_.area(-state.gap, segment) : 0;
  response.dissipated_power = damping_constant * state.gap_rate * state.gap_rate;
}

// Of a single line; others are no power of the penetration.
std::optional<ElasticForce> Table::elastic_force() const {
  if (curve_.n_segments() > 1)
    return std::nullopt;
  return ElasticForce{.stiffness = curve_.slope(0), .exponent = 1};
}

} // namespace vibroimpact::contact
