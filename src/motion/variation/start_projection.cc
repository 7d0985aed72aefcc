#include "motion/variation/start_projection.h"

#include "motion/interval/guard_forms.h"

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactLaw;

namespace {

// That of the guards into a mode, when all that lead there have the same one.
const std::vector<AffineForm> *reset_into(const ContactLaw &law, int mode) {
  const std::vector<AffineForm> *found = nullptr;
  for (const contact::Mode &from : law.modes())
    for (const contact::Guard &guard : from.guards) {
      if (guard.target != mode)
        continue;
      if (guard.reset.empty() || found)
        return nullptr;
      found = &guard.reset;
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

bool stays(const AffineForm &reset, std::size_t place) {
  return reset.internal.size() == place + 1 && reset.internal[place] == 1 && reset.gap == 0 &&
         reset.gap_rate == 0 && reset.constant == 0 && !reset.sees_normal_force();
}

// The spring of a slider that slides is what the normal force makes of it.
void slave_to_force(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
                    const Vector &state, std::size_t c, LinearMap &map) {
  const contact::ContactPair &pair = equations.contacts().pairs()[c];
  const int mode = equations.modes()[c];
  const std::vector<AffineForm> &reset = *reset_into(*pair.law, mode);
  for (std::size_t i = 0; i < reset.size(); ++i) {
    if (stays(reset[i], i))
      continue;
    const Index row = equations.layout().internal() + pair.internal_offset + static_cast<Index>(i);
    const RowVector gradient =
        tangent_row(equations, c, reset[i], time, state).row.head(map.by_state.rows());
    map.by_state.row(row) = (gradient * map.by_state).eval();
    map.by_key.row(row) = (gradient * map.by_key).eval();
    for (std::size_t k = 0; k < keys.size(); ++k)
      map.by_key(row, static_cast<Index>(k)) += keys[k]->form(
          equations, c,
          [&](const ContactLaw &law) -> const AffineForm & { return (*reset_into(law, mode))[i]; },
          time, state);
  }
}

void slave(const Equations &equations, const std::vector<KeyTangent *> &keys, double time,
           const Vector &state, std::size_t c, LinearMap &map) {
  const contact::ContactPair &pair = equations.contacts().pairs()[c];
  const int mode = equations.modes()[c];
  const std::vector<AffineForm> *reset = reset_into(*pair.law, mode);
  if (!reset)
    return;
  if (equations.mode(c).sees_force_rate)
    return slave_to_force(equations, keys, time, state, c, map);
  if (!equations.mode(c).affine)
    return;
  const std::vector<AffineForm> &rates = equations.mode(c).affine->internal_rate;
  for (std::size_t i = 0; i < reset->size() && i < rates.size(); ++i) {
    if (!follows_gap((*reset)[i], rates[i], !pair.tangential.empty()))
      continue;
    const Index row = equations.layout().internal() + pair.internal_offset + static_cast<Index>(i);
    const Index n = equations.layout().n;
    map.by_state.row(row) = (*reset)[i].gap * pair.gap.row * map.by_state.topRows(n);
    map.by_key.row(row) = (*reset)[i].gap * pair.gap.row * map.by_key.topRows(n);
    for (std::size_t k = 0; k < keys.size(); ++k)
      map.by_key(row, static_cast<Index>(k)) += (*reset)[i].gap * keys[k]->gap(c, time, state);
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
