#include "periodic/symmetry.h"

#include "common/error.h"
#include "contact/same_law.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace vibroimpact::periodic {

namespace {

using contact::ContactPair;

constexpr double equal_up_to = 1e-12; // two clearances or gap rows
constexpr double motions_equal_up_to = 1e-6;
constexpr int states_tried = 3;

/// Numbers between -1 and 1, the same on every machine.
class Random {
public:
  double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-52 - 1; }

private:
  std::mt19937_64 generator_{20};
};

bool near(double a, double b) {
  return std::abs(a - b) <= equal_up_to * std::max(std::abs(a), std::abs(b));
}

using Exchange = std::vector<std::size_t>; // the body that each body takes the place of

// All ways in which bodies of equal sizes change places in pairs, no exchange first.
void add_exchanges(const model::Model &model, std::size_t body, Exchange &from,
                   std::vector<Exchange> &exchanges) {
  if (body == from.size()) {
    exchanges.push_back(from);
    return;
  }
  add_exchanges(model, body + 1, from, exchanges);
  for (std::size_t other = body + 1; from[body] == body && other < from.size(); ++other)
    if (from[other] == other && model.bodies()[body]->size() == model.bodies()[other]->size()) {
      std::swap(from[body], from[other]);
      add_exchanges(model, body + 1, from, exchanges);
      std::swap(from[body], from[other]);
    }
}

std::vector<Exchange> exchanges_of(const model::Model &model) {
  constexpr std::size_t most_bodies = 8;
  Exchange from(model.bodies().size());
  std::iota(from.begin(), from.end(), std::size_t{0});
  if (from.size() > most_bodies)
    return {from};
  std::vector<Exchange> exchanges;
  add_exchanges(model, 0, from, exchanges);
  return exchanges;
}

// For the rigid contacts of a state, which must not overlap: half as far from the origin until none
// does.
void part_rigid_sides(const motion::Equations &equations, double time, Vector &state) {
  const auto overlaps = [&] {
    for (std::size_t c = 0; c < equations.contacts().size(); ++c)
      if (equations.contacts().pairs()[c].law->rigid() &&
          equations.local_state(c, time, ConstVectorView(state.data(), state.size())).gap < 0)
        return true;
    return false;
  };
  for (int i = 0; i < 60 && overlaps(); ++i)
    state.head(equations.layout().n) /= 2;
}

Vector half_period_on(ForcedSystem &system, double start, const Vector &state) {
  motion::Trajectory &trajectory = system.trajectory();
  trajectory.start({.time = start, .physical = state});
  trajectory.advance(start + system.period() / 2);
  return trajectory.motion_state().physical;
}

} // namespace

Symmetry::Symmetry(const ForcedSystem &system, const Exchange &from, double sign)
    : taken_from_(static_cast<std::size_t>(system.layout().physical_size())),
      factor_(Vector::Ones(system.layout().physical_size())) {
  std::iota(taken_from_.begin(), taken_from_.end(), Index{0});
  factor_.head(system.layout().internal()).setConstant(sign);
  for (std::size_t body = 0; body < from.size(); ++body)
    for (Index i = 0; i < system.model().bodies()[body]->size(); ++i)
      for (const Index start : {Index{0}, system.layout().velocity()})
        taken_from_[static_cast<std::size_t>(start + system.model().offset(body) + i)] =
            start + system.model().offset(from[body]) + i;
}

// The gap of a in the state sigma x, half a period later, is that of b in the state x.
bool Symmetry::matches(const ContactPair &a, const ContactPair &b) const {
  RowVector row = RowVector::Zero(a.gap.row.size());
  for (Index i = 0; i < row.size(); ++i)
    row[taken_from_[static_cast<std::size_t>(i)]] += factor_[i] * a.gap.row[i];
  const double largest = row.cwiseAbs().maxCoeff();
  if (a.circle || b.circle) // their second direction is not looked at here
    return false;
  if (!near(a.clearance, b.clearance) ||
      (row - RowVector(b.gap.row)).cwiseAbs().maxCoeff() > equal_up_to * largest)
    return false;
  const std::vector<double> &one = a.gap.base_coefficients, &other = b.gap.base_coefficients;
  for (std::size_t k = 0; k < one.size(); ++k)
    if (std::abs(one[k] + other[k]) > equal_up_to)
      return false;
  return true;
}

bool Symmetry::pair_contacts(const ForcedSystem &system, double size) {
  const std::vector<ContactPair> &pairs = system.contacts().pairs();
  const Index internal = system.layout().internal();
  std::vector<char> paired(pairs.size(), 0);
  partners_.resize(pairs.size());
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    if (paired[a])
      continue;
    std::size_t b = a;
    while (b < pairs.size() && (paired[b] || !matches(pairs[a], pairs[b]) ||
                                !same_law(*pairs[a].law, *pairs[b].law, size)))
      ++b;
    if (b == pairs.size())
      return false;
    paired[a] = paired[b] = 1;
    partners_[a] = b;
    partners_[b] = a;
    for (Index i = 0; i < pairs[a].n_internal(); ++i) {
      const Index one = internal + pairs[a].internal_offset + i;
      const Index other = internal + pairs[b].internal_offset + i;
      taken_from_[static_cast<std::size_t>(one)] = other;
      taken_from_[static_cast<std::size_t>(other)] = one;
    }
  }
  return true;
}

// sigma P_(T/2)(x, 0) = P_(T/2)(sigma x, T/2): a motion that fails must do so on both sides.
bool Symmetry::holds(ForcedSystem &system, const Vector &scale, double size) const {
  Random random;
  const motion::StateLayout &layout = system.layout();
  for (int i = 0; i < states_tried; ++i) {
    Vector state = Vector::Zero(layout.physical_size());
    for (Index j = 0; j < layout.internal(); ++j)
      state[j] = size / scale[j] * random();
    state.segment(layout.internal(), layout.n_internal) = system.contacts().initial_internal();
    part_rigid_sides(system.trajectory().equations(), 0, state);
    const auto image = [&](double start, const Vector &from) -> std::optional<Vector> {
      try {
        return half_period_on(system, start, from);
      } catch (const NumericalError &) {
        return std::nullopt;
      }
    };
    const std::optional<Vector> one = image(0, state);
    const std::optional<Vector> other = image(system.period() / 2, apply(state));
    if (one.has_value() != other.has_value())
      return false;
    if (one &&
        ((apply(*one) - *other).cwiseProduct(scale)).cwiseAbs().maxCoeff() >
            motions_equal_up_to * std::max(size, one->cwiseProduct(scale).cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

std::optional<Symmetry> Symmetry::find(ForcedSystem &system, const Vector &scale, double size) {
  // Friction would have to be paired in its modes as well.
  if (!forcing_is_odd(system) || system.contacts().n_sliding() > 0)
    return std::nullopt;
  const std::vector<Exchange> exchanges = exchanges_of(system.model());
  for (const Exchange &from : exchanges)
    for (const double sign : {-1.0, 1.0}) {
      if (sign > 0 && from == exchanges.front())
        continue; // nothing would change
      Symmetry symmetry(system, from, sign);
      if (symmetry.pair_contacts(system, size) && symmetry.holds(system, scale, size))
        return symmetry;
    }
  return std::nullopt;
}

Matrix Symmetry::apply(const Matrix &columns) const {
  Matrix image(columns.rows(), columns.cols());
  for (Index i = 0; i < columns.rows(); ++i)
    image.row(i) = factor_[i] * columns.row(taken_from_[static_cast<std::size_t>(i)]);
  return image;
}

} // namespace vibroimpact::periodic
