#include "motion/variation/start_projection.h"

#include "motion/interval/guard_forms.h"

#include <algorithm>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactLaw;

namespace {

bool stays(const AffineForm &reset, std::size_t place) {
  return reset.internal.size() == place + 1 && reset.internal[place] == 1 && reset.gap == 0 &&
         reset.gap_rate == 0 && reset.constant == 0 && !reset.sees_normal_force();
}

bool same(const AffineForm &one, const AffineForm &other) {
  AffineForm difference = -1.0 * other;
  difference += one;
  return difference.zero();
}

// What guards make of an internal state on the way into a mode, through modes that they leave it as
// it is on the way to, when there is one such form only; nullptr otherwise.
const AffineForm *reset_into(const ContactLaw &law, int mode, std::size_t place) {
  const AffineForm *found = nullptr;
  std::vector<int> targets = {mode};
  for (std::size_t i = 0; i < targets.size(); ++i)
    for (std::size_t m = 0; m < law.modes().size(); ++m)
      for (const contact::Guard &guard : law.modes()[m].guards) {
        if (guard.target != targets[i])
          continue;
        const bool kept = place >= guard.reset.size() || stays(guard.reset[place], place);
        if (kept && std::ranges::find(targets, static_cast<int>(m)) == targets.end())
          targets.push_back(static_cast<int>(m));
        if (kept)
          continue;
        if (found && !same(*found, guard.reset[place]))
          return nullptr;
        found = &guard.reset[place];
      }
  return found;
}

// z = a gap + b with z' = a gap_rate; a = 0 for states of friction, which limits give.
bool follows_gap(const AffineForm &reset, const AffineForm &rate, bool friction) {
  return (reset.gap != 0 || friction) && reset.gap_rate == 0 && reset.internal.empty() &&
         rate.gap == 0 && rate.constant == 0 && rate.internal.empty() &&
         rate.gap_rate == reset.gap && rate.tangential[0].zero();
}

void hold(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
          const Vector &state, LinearMap &map) {
  const ActiveConstraints &holding = equations.holding();
  const StateLayout &layout = equations.layout();
  const auto n_keys = static_cast<Index>(keys.size());
  Matrix gaps = Matrix::Zero(holding.size(), n_keys);
  Matrix gap_rates(holding.size(), n_keys);
  Matrix rows = holding.rows(); // of the positions that are held
  for (Index i = 0; i < holding.size(); ++i) {
    const HeldDirection &held = holding.held(i);
    if (held.direction > 0)
      rows.row(i).setZero();
    for (Index k = 0; k < n_keys; ++k) {
      KeyTangent &key = *keys[static_cast<std::size_t>(k)];
      if (held.direction == 0)
        gaps(i, k) = key.gap(held.contact, time, state);
      gap_rates(i, k) = key.gap_rate(held.contact, time, state, held.direction);
    }
  }
  const Matrix &response = holding.response();
  map.by_state.block(0, 0, layout.n, layout.n) -= response * holding.forces(rows);
  map.by_state.block(layout.velocity(), layout.velocity(), layout.n, layout.n) -=
      response * holding.forces(holding.rows());
  map.by_key.topRows(layout.n) -= response * holding.forces(gaps);
  map.by_key.middleRows(layout.velocity(), layout.n) -= response * holding.forces(gap_rates);
}

// The spring of a slider that slides is what the normal force makes of it.
void slave_to_force(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
                    const Vector &state, std::size_t c, std::size_t place, const AffineForm &reset,
                    LinearMap &map) {
  const contact::ContactPair &pair = equations.contacts().pairs()[c];
  const int mode = equations.modes()[c];
  const Index row =
      equations.layout().internal() + pair.internal_offset + static_cast<Index>(place);
  const RowVector gradient =
      tangent_row(equations, c, reset, time, state).row.head(map.by_state.rows());
  map.by_state.row(row) = (gradient * map.by_state).eval();
  map.by_key.row(row) = (gradient * map.by_key).eval();
  for (std::size_t k = 0; k < keys.size(); ++k)
    map.by_key(row, static_cast<Index>(k)) += keys[k]->form(
        equations, c,
        [&](const ContactLaw &law) -> const AffineForm & { return *reset_into(law, mode, place); },
        time, state);
}

void slave_to_gap(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
                  const Vector &state, std::size_t c, std::size_t place, double factor,
                  LinearMap &map) {
  const contact::ContactPair &pair = equations.contacts().pairs()[c];
  const Index row =
      equations.layout().internal() + pair.internal_offset + static_cast<Index>(place);
  const Index n = equations.layout().n;
  map.by_state.row(row) = factor * pair.gap.row * map.by_state.topRows(n);
  map.by_key.row(row) = factor * pair.gap.row * map.by_key.topRows(n);
  for (std::size_t k = 0; k < keys.size(); ++k)
    map.by_key(row, static_cast<Index>(k)) += factor * keys[k]->gap(c, time, state);
}

void slave(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
           const Vector &state, std::size_t c, LinearMap &map) {
  const contact::ContactPair &pair = equations.contacts().pairs()[c];
  const contact::Mode &mode = equations.mode(c);
  for (std::size_t i = 0; i < static_cast<std::size_t>(pair.n_internal()); ++i) {
    const AffineForm *reset = reset_into(*pair.law, equations.modes()[c], i);
    if (!reset)
      continue;
    if (mode.sees_force_rate)
      slave_to_force(equations, keys, time, state, c, i, *reset, map);
    else if (mode.affine && i < mode.affine->internal_rate.size() &&
             follows_gap(*reset, mode.affine->internal_rate[i], !pair.tangential.empty()))
      slave_to_gap(equations, keys, time, state, c, i, reset->gap, map);
  }
}

} // namespace

LinearMap start_projection(const Equations &equations, const std::vector<KeyTangent *> &keys,
                           double time, const Vector &state) {
  const Index size = equations.layout().physical_size();
  LinearMap map{.by_state = Matrix::Identity(size, size),
                .by_key = Matrix::Zero(size, static_cast<Index>(keys.size()))};
  if (!equations.holding().empty())
    hold(equations, keys, time, state, map);
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    slave(equations, keys, time, state, c, map);
  return map;
}

} // namespace vibroimpact::motion
