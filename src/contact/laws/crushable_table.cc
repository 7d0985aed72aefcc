#include "contact/laws/crushable_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::contact {

namespace {

enum Stage : int { open, elastic, loading, falling, unloading, rising };
constexpr int n_stages = 6;

// Mode 0: apart, nothing crushed.
int place(std::size_t interval, Stage stage) {
  return 1 + n_stages * static_cast<int>(interval) + stage;
}
Stage stage_of(int mode) { return mode == 0 ? open : static_cast<Stage>((mode - 1) % n_stages); }
std::size_t interval_of(int mode) {
  return mode == 0 ? 0 : static_cast<std::size_t>((mode - 1) / n_stages);
}

const AffineForm rate_in{.gap_rate = -1};
const AffineForm rate_out{.gap_rate = 1};

AffineForm residual(double factor) { return {.internal = {factor}}; }
AffineForm constant(double value) { return {.constant = value}; }

class Modes {
public:
  explicit Modes(const CrushCurves &curves) : curves_(curves) {}

  std::vector<Mode> make() const {
    std::vector<Mode> modes = {with("untouched", {}, {touch()})};
    for (std::size_t i = 0; i < curves_.intervals().size(); ++i)
      for (int stage = 0; stage < n_stages; ++stage) {
        modes.push_back(make(i, static_cast<Stage>(stage)));
        modes.back().name += " " + std::to_string(i + 1);
      }
    return modes;
  }

private:
  Guard touch() const {
    return {.indicator = {.gap = 1},
            .target = place(0, curves_.yields_later() ? elastic : loading),
            .reset = {constant(0)}};
  }
  const CrushInterval &at(std::size_t i) const { return curves_.intervals()[i]; }
  bool last(std::size_t i) const { return i + 1 == curves_.intervals().size(); }
  bool comes_back(std::size_t i) const { return !at(i).unloading.no_force(); }

  AffineForm line() const {
    return {.gap = -curves_.stiffness(), .internal = {-curves_.stiffness()}};
  }
  /// p stays.
  static Mode with(const char *name, const AffineForm &force, std::vector<Guard> guards) {
    return {.name = name,
            .in_contact = !force.zero(),
            .guards = std::move(guards),
            .affine = AffineLaw{.force = force, .internal_rate = {AffineForm{}}}};
  }
  static Mode on_curve(const char *name, const CrushSide &side, std::vector<Guard> guards) {
    Mode mode = with(name, {.constant = side.intercept, .gap = -side.stiffness}, std::move(guards));
    mode.in_contact = true;
    mode.affine->internal_rate[0] = {.gap_rate = -side.residual_rate()};
    return mode;
  }

  // p on a curve.
  static std::vector<AffineForm> as_on(const CrushSide &side) {
    return {{.constant = -side.at_zero / side.slope, .gap = -1 / side.slope}};
  }
  Guard meets_loading(std::size_t i) const {
    const CrushSide &side = at(i).loading;
    return {.indicator = constant(side.at_zero) + residual(side.slope) + AffineForm{.gap = 1},
            .target = place(i, loading),
            .reset = as_on(side)};
  }
  // The sides part where it has no force.
  Guard meets_unloading(std::size_t i) const {
    const CrushSide &side = at(i).unloading;
    const AffineForm above =
        constant(-side.at_zero) + residual(-side.slope) + AffineForm{.gap = -1};
    if (!comes_back(i))
      return {.indicator = above, .target = place(i, open)};
    return {.indicator = above, .target = place(i, unloading), .reset = as_on(side)};
  }

  std::vector<Guard> while_loading(std::size_t i) const {
    std::vector<Guard> guards = {
        {.indicator = rate_in, .target = place(i, falling), .reset = as_on(at(i).loading)}};
    if (!last(i))
      guards.push_back({.indicator = constant(at(i + 1).loading_begin) + AffineForm{.gap = 1},
                        .target = place(i + 1, loading),
                        .reset = {constant(at(i + 1).begin)}});
    return guards;
  }
  // Of the first interval at zero; where the curve below has no force the sides part.
  Guard ends_unloading(std::size_t i) const {
    Guard guard{.indicator = constant(-at(i).unloading_begin) + AffineForm{.gap = -1},
                .target = 0,
                .reset = {constant(at(i).begin)}};
    if (i > 0)
      guard.target = comes_back(i - 1) ? place(i - 1, unloading) : place(i, open);
    return guard;
  }

  std::vector<Guard> while_unloading(std::size_t i) const {
    return {ends_unloading(i),
            {.indicator = rate_out, .target = place(i, rising), .reset = as_on(at(i).unloading)}};
  }

  Mode make(std::size_t i, Stage stage) const {
    switch (stage) {
    case open:
      return with("open", {},
                  {{.indicator = AffineForm{.gap = 1} + residual(1), .target = place(i, elastic)}});
    case elastic:
      return with("elastic", line(), {meets_loading(i), meets_unloading(i)});
    case loading:
      return on_curve("loading", at(i).loading, while_loading(i));
    case falling:
      return with("falling", line(),
                  {meets_unloading(i), {.indicator = rate_out, .target = place(i, elastic)}});
    case unloading:
      return on_curve("unloading", at(i).unloading, while_unloading(i));
    default:
      return with("rising", line(),
                  {meets_loading(i), {.indicator = rate_in, .target = place(i, elastic)}});
    }
  }

  const CrushCurves &curves_;
};

} // namespace

CrushableTable::CrushableTable(CrushCurves curves)
    : ContactLaw(Modes(curves).make(), {0.0}), curves_(std::move(curves)) {}

std::vector<InternalState> CrushableTable::internal_states() const {
  return {{.name = "residual_penetration",
           .unit = "m",
           .description =
               "Penetration at which the force would be gone on the present line of "
               "unloading; of a stop that does not come back, what it stays crushed by"}};
}

// A motion may go on from a place on one of the curves, up to the error of the integration.
int CrushableTable::initial_mode(const LocalState &state) const {
  constexpr double integration_error = 1e-9; // relative
  const double p = state.internal[0];
  const double u = -state.gap;
  const std::size_t i = curves_.interval(p);
  const CrushInterval &at = curves_.intervals()[i];
  const auto on = [&](const CrushSide &side) {
    const double there = side.penetration(p);
    return std::abs(u - there) <= integration_error * there;
  };
  const bool comes_back = !curves_.intervals().front().unloading.no_force();
  if (!(u > p))
    return comes_back || (p == 0 && !curves_.yields_later()) ? 0 : place(i, open);
  if (on(at.loading))
    return place(i, state.gap_rate < 0 ? loading : falling);
  if (!at.unloading.no_force() && on(at.unloading))
    return place(i, state.gap_rate > 0 ? unloading : rising);
  return place(i, elastic);
}

void CrushableTable::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  response.force_by_internal.assign(1, 0);
  response.internal_rate.assign(1, 0);
  response.internal_rate_by_gap.assign(1, 0);
  response.internal_rate_by_gap_rate.assign(1, 0);
  response.internal_rate_by_internal.assign(1, 0);
  response.force = response.force_by_gap = response.force_by_gap_rate = 0;
  response.stored_energy = response.dissipated_power = 0;
  const Stage stage = stage_of(mode);
  if (stage == loading || stage == unloading)
    evaluate_curve(mode, state, response);
  else if (stage != open)
    evaluate_line(mode, state, response);
}

void CrushableTable::evaluate_line(int mode, const LocalState &state, LawResponse &response) const {
  const double p = state.internal[0];
  response.force = -curves_.stiffness() * (state.gap + p);
  response.force_by_gap = -curves_.stiffness();
  response.force_by_internal[0] = -curves_.stiffness();
  response.stored_energy = curves_.recoverable(interval_of(mode), p, -state.gap);
}

void CrushableTable::evaluate_curve(int mode, const LocalState &state,
                                    LawResponse &response) const {
  const std::size_t i = interval_of(mode);
  const CrushSide &below = curves_.intervals()[i].unloading;
  const bool loads = stage_of(mode) == loading;
  const CrushSide &side = loads ? curves_.intervals()[i].loading : below;
  const double p = (-state.gap - side.at_zero) / side.slope;
  const double rate = -state.gap_rate / side.slope;
  response.force = side.force(-state.gap);
  response.force_by_gap = -side.stiffness;
  response.internal_rate[0] = rate;
  response.internal_rate_by_gap_rate[0] = -1 / side.slope;
  response.stored_energy =
      loads ? curves_.recoverable(i, p, -state.gap) : curves_.recoverable_below(i, -state.gap);
  if (loads)
    response.dissipated_power = (response.force - below.force(below.penetration(p))) * rate;
}

} // namespace vibroimpact::contact
