#include "periodic/energy_orbits.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::periodic {

using continuation::Evaluation;
using continuation::Extension;
using continuation::Graze;
using continuation::Point;
using continuation::ShorterReturn;
using continuation::Transfer;

namespace {

// Of the size of an entry. Linear forces leave only rounding of the difference; others its square.
constexpr double energy_step = 1e-5;
constexpr double lost_share = 1e-6; // of the energy: beyond what rounding and steps leave
// Of xi T: what the last, linear correction leaves is its square.
constexpr double near_excitation = 1e-8;
constexpr double stalled_excitation = 1e-6; // where grazing contacts let it become no smaller
constexpr int most_excitations = 30;
constexpr double largest_excitation = 1; // change of xi T in one step

} // namespace

MechanicalEnergy mechanical_energy(const StroboscopicMap &map, const Vector &state,
                                   const Vector &sizes) {
  motion::Trajectory &trajectory = map.start(0, state);
  const motion::Equations &equations = trajectory.equations();
  const Vector load = equations.model().static_load();
  Vector full = trajectory.state();
  const auto value = [&] {
    return equations.stored_energy(trajectory.time(), ConstVectorView(full.data(), full.size())) -
           load.dot(full.head(load.size()));
  };
  MechanicalEnergy energy{.value = value(), .by_state = RowVector(state.size())};
  for (Index i = 0; i < state.size(); ++i) {
    const double place = full[i], step = energy_step * sizes[i];
    full[i] = place + step;
    const double above = value();
    full[i] = place - step;
    energy.by_state[i] = (above - value()) / (2 * step);
    full[i] = place;
  }
  return energy;
}

EnergyMemory::EnergyMemory(std::shared_ptr<FreePeriod> period, const Vector &sizes)
    : period_(std::move(period)) {
  period_->set_key_sizes(sizes);
  excitation_.set_key_sizes(sizes);
}

void EnergyMemory::note(const Vector &motion) {
  period_->note(motion);
  excitation_.note(motion);
}

void EnergyMemory::recall(const Vector &motion) {
  period_->recall(motion);
  excitation_.recall(motion);
}

std::vector<double> EnergyMemory::numbers() const {
  const std::vector<double> periods = period_->numbers(), excitations = excitation_.numbers();
  std::vector<double> list{static_cast<double>(periods.size())};
  list.insert(list.end(), periods.begin(), periods.end());
  list.insert(list.end(), excitations.begin(), excitations.end());
  return list;
}

void EnergyMemory::restore(const std::vector<double> &numbers) {
  const auto first = numbers.begin() + 1;
  const auto second = first + static_cast<std::ptrdiff_t>(numbers.front());
  period_->restore({first, second});
  excitation_.restore({second, numbers.end()});
}

EnergyOrbits::EnergyOrbits(MapAlongKeys &maps, std::shared_ptr<EnergyMemory> memory, long halves,
                           Rule rule)
    : maps_(maps), memory_(std::move(memory)), orbits_(maps, halves, rule.sizes),
      rule_(std::move(rule)) {}

MechanicalEnergy EnergyOrbits::energy(const Vector &state) {
  return mechanical_energy(maps_.at(Vector::Constant(1, memory_->excitation())), state,
                           rule_.sizes.head(state.size()));
}

Vector EnergyOrbits::unknowns(const Point &point) const {
  Vector list(point.state.size() + 1);
  list << point.state, point.keys;
  return list;
}

// What Newton's method says is missing of the self-excitation for the energy to come back.
EnergyOrbits::Correction EnergyOrbits::missing(const Evaluation &at, const Point &point,
                                               const MechanicalEnergy &begin) {
  const MechanicalEnergy end = energy(point.state + at.residual);
  const double rise = end.by_state.dot(at.by_keys.col(0));
  if (rise == 0 || !std::isfinite(rise))
    throw NumericalError("self-excitation does not change the energy of the motion");
  const RowVector there = end.by_state * at.by_state + end.by_state;
  return {.change = (begin.value - end.value) / rise, .by_state = (begin.by_state - there) / rise};
}

Evaluation EnergyOrbits::at_returned_energy(const Point &point, const MechanicalEnergy &begin,
                                            const Evaluate &evaluate, Correction &last) {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_excitations; ++i) {
    Evaluation at =
        evaluate({point.state, Vector::Constant(1, memory_->excitation()), point.chart});
    if (rule_.losses == Losses::none) {
      refuse_losses(at, point, begin);
      return at;
    }
    last = missing(at, point, begin);
    const double share = std::abs(last.change) * memory_->period();
    memory_->set_excitation(memory_->excitation() +
                            last.change / std::max(1.0, share / largest_excitation));
    const bool stalls = share <= stalled_excitation && share >= before / 2;
    before = share;
    if (share > near_excitation && !stalls)
      continue;
    at.residual += at.by_keys.col(0) * last.change;
    at.by_state += at.by_keys.col(0) * last.by_state;
    return at;
  }
  throw NumericalError("no self-excitation balances the losses of the motion");
}

void EnergyOrbits::refuse_losses(const Evaluation &at, const Point &point,
                                 const MechanicalEnergy &begin) {
  const double end = energy(point.state + at.residual).value;
  if (std::abs(end - begin.value) > lost_share * std::abs(begin.value - rule_.rest))
    throw NumericalError(
        "the motion loses energy in its contacts, which Damping = balanced would make good");
}

void EnergyOrbits::add_energy(Evaluation &at, const Point &point,
                              const MechanicalEnergy &begin) const {
  const Index n = point.state.size();
  const Vector uphill = rule_.sizes.head(n).cwiseAbs2().cwiseProduct(begin.by_state.transpose());
  const double rise = begin.by_state.dot(uphill);
  if (!(rise > 0))
    throw NumericalError("the motion is at rest");
  const Vector along = uphill / rise;
  at.residual += along * (point.keys[0] + rule_.rest - begin.value);
  at.by_state -= along * begin.by_state;
  at.by_keys = along;
}

Evaluation EnergyOrbits::evaluate(const Point &point) {
  memory_->recall(unknowns(point));
  const MechanicalEnergy begin = energy(point.state);
  Correction correction;
  Evaluation at = at_returned_energy(
      point, begin, [&](const Point &excited) { return orbits_.evaluate(excited); }, correction);
  add_energy(at, point, begin);
  memory_->note(unknowns(point));
  at_ = point;
  return at;
}

// The period and the self-excitation become those of the point.
void EnergyOrbits::take(const Point &point) {
  const auto same = [](const Vector &a, const Vector &b) { return a.size() == b.size() && a == b; };
  if (!at_ || at_->chart != point.chart || !same(at_->state, point.state) ||
      !same(at_->keys, point.keys))
    evaluate(point);
  memory_->recall(unknowns(point));
}

Point EnergyOrbits::excited(const Point &point) {
  take(point);
  return {point.state, Vector::Constant(1, memory_->excitation()), point.chart};
}

double EnergyOrbits::self_excitation(const Point &point) { return excited(point).keys[0]; }

double EnergyOrbits::period(const Point &point) {
  orbit(point);
  return memory_->period();
}

const StroboscopicMap &EnergyOrbits::map(const Point &point) {
  return maps_.at(excited(point).keys);
}

Orbit EnergyOrbits::orbit(const Point &point) {
  const Evaluation at = evaluate(point);
  const StroboscopicMap &map = this->map(point);
  const Section section{.phase = point.chart, .halves = orbits_.halves()};
  Orbit orbit{.section = section, .point = {.state = point.state, .image = {}}};
  orbit.point.image = map.image(section, point.state);
  memory_->note(unknowns(point)); // at the corrected self-excitation
  orbit.point.image.by_state = at.by_state + Matrix::Identity(map.size(), map.size());
  orbit.point.residual = map.norm(at.residual) / map.norm(point.state);
  return orbit;
}

std::vector<ShorterReturn> EnergyOrbits::shorter_returns(const Point &point) {
  return orbits_.shorter_returns(excited(point));
}

std::unique_ptr<continuation::Problem> EnergyOrbits::doubled() {
  return std::make_unique<EnergyOrbits>(maps_, memory_, 2 * orbits_.halves(), rule_);
}

double EnergyOrbits::best_chart(const Point &point) { return orbits_.best_chart(excited(point)); }

Transfer EnergyOrbits::transfer(const Point &point, double chart) {
  Transfer moved = orbits_.transfer(excited(point), chart);
  moved.by_keys.setZero(point.state.size(), 1);
  moved.point.keys = point.keys;
  if (rule_.losses == Losses::balanced)
    moved.point.keys[0] = energy(moved.point.state).value - rule_.rest;
  memory_->note(unknowns(moved.point));
  return moved;
}

std::vector<Graze> EnergyOrbits::grazes_near(const Point &point) {
  return orbits_.grazes_near(excited(point));
}

Extension EnergyOrbits::extend(const Point &point, const Graze &graze) {
  memory_->recall(unknowns(point));
  const MechanicalEnergy begin = energy(point.state);
  Correction correction;
  Extension extension;
  Evaluation smooth = at_returned_energy(
      point, begin,
      [&](const Point &excited) {
        extension = orbits_.extend(excited, graze);
        return extension.smooth;
      },
      correction);
  if (rule_.losses == Losses::balanced) {
    extension.value += extension.by_keys[0] * correction.change;
    extension.by_state += extension.by_keys[0] * correction.by_state;
  }
  add_energy(smooth, point, begin);
  extension.smooth = std::move(smooth);
  extension.by_keys = RowVector::Zero(1);
  return extension;
}

std::vector<double> EnergyOrbits::remembered() const { return memory_->numbers(); }

void EnergyOrbits::remember(const std::vector<double> &numbers) {
  if (!numbers.empty())
    memory_->restore(numbers);
  at_.reset();
}

} // namespace vibroimpact::periodic
