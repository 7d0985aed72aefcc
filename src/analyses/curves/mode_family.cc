#include "analyses/curves/mode_family.h"

#include "analyses/curves/orbit_rows.h"
#include "common/error.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using periodic::EnergyOrbits;
using periodic::FreePeriod;
using periodic::Losses;

namespace {

constexpr double longest_first_return = 1.5; // periods of the linear mode
constexpr double near_start = 0.4;           // of the farthest way from the start
constexpr int looks_for_return = 300;
constexpr double same_after_half = 0.2; // of the size of the motion

} // namespace

ModeFamily::ModeFamily(const System &system, const ModeStart &start, Losses losses,
                       std::vector<RecorderFactory> recorders)
    : mode_(linear_mode(system, start)), period_(std::make_shared<FreePeriod>(mode_.period)),
      growth_(std::sqrt(start.last_energy / start.energy)),
      maps_(system, losses == Losses::none ? FileDamping::left_out : FileDamping::kept, period_,
            growth_ * mode_.motion),
      recorders_(std::move(recorders)), rule_{.losses = losses,
                                              .sizes = sizes(start.last_energy - start.energy)} {
  rule_.rest = periodic::mechanical_energy(map(), whole(mode_.rest), rule_.sizes).value;
  memory_ = std::make_shared<periodic::EnergyMemory>(period_, rule_.sizes);
  start_ = {.state = whole(mode_.rest + mode_.motion), .keys = Vector::Constant(1, start.energy)};
  find_period();
  halves_ = is_symmetric() ? 1 : 2;
}

// Internal states of contacts begin at zero.
Vector ModeFamily::whole(const Vector &motion) {
  Vector state = Vector::Zero(map().size());
  state.head(motion.size()) = motion;
  return state;
}

// Displacements and rates of the linear mode at the last energy are as one.
Vector ModeFamily::sizes(double energies) {
  const Vector &scale = map().scale();
  const double largest =
      growth_ * scale.head(mode_.motion.size()).cwiseProduct(mode_.motion).cwiseAbs().maxCoeff();
  Vector sizes(map().size() + 1);
  sizes << largest * scale.cwiseInverse(), energies;
  return sizes;
}

std::shared_ptr<EnergyOrbits> ModeFamily::problem(long halves) {
  return std::make_shared<EnergyOrbits>(maps_, memory_, halves, rule_);
}

// Contacts that touch at rest make the period another one than that of the mode, and losses bring
// the first motion back to some other place.
void ModeFamily::find_period() {
  motion::Trajectory &trajectory = map().start(0, start_.state);
  const periodic::Plane plane =
      periodic::plane_across(start_.state, map().rates(0, start_.state), map().scale());
  map().start(0, start_.state);
  const auto returns = [](const periodic::Passage &passage) {
    return passage.away <= near_start * passage.farthest;
  };
  const std::vector<periodic::Passage> found = periodic::passages(
      plane, map().scale(), 0, longest_first_return * mode_.period, looks_for_return,
      [&](double time) -> Vector {
        trajectory.advance(time);
        return trajectory.motion_state().physical;
      },
      returns);
  const bool seen = !found.empty() && returns(found.back());
  period_->set_period(seen ? found.back().time : mode_.period);
}

bool ModeFamily::is_symmetric() {
  if (!maps_.symmetric())
    return false;
  const double period = period_->period();
  bool same = false;
  try {
    const Vector image = map().image({.halves = 1}, start_.state).state;
    same = map().norm(image - start_.state) < same_after_half * map().norm(start_.state);
  } catch (const NumericalError &) {
    // It does not come back after half a period.
  }
  period_->set_period(period);
  return same;
}

EnergyOrbits &ModeFamily::recorded(long halves) {
  std::shared_ptr<EnergyOrbits> &motions = recorded_[halves];
  if (!motions)
    motions = problem(halves);
  return *motions;
}

PointResult ModeFamily::row(const BranchPoint &point, long halves) {
  EnergyOrbits &motions = recorded(halves);
  const periodic::Orbit orbit = motions.orbit(point.point);
  const double excitation = motions.self_excitation(point.point);
  const periodic::StroboscopicMap &map = motions.map(point.point);
  PointResult row = orbit_row(map, orbit, maps_.system(), maps_.forced().trajectory(), recorders_,
                              motions.neutral_margin());
  const double frequency = 1 / (static_cast<double>(orbit.multiple()) * map.period());
  const FieldWriter result(row);
  result.number("frequency", frequency, "Hz", "of the periodic motion");
  result.number("self_excitation", excitation, "1/s",
                "force on each mass over its momentum that balances the losses");
  result.number("damping_ratio", excitation / (4 * std::numbers::pi * frequency), "1",
                "of the mode: self-excitation over twice the angular frequency");
  return row;
}

} // namespace vibroimpact::analyses
