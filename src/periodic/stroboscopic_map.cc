#include "periodic/stroboscopic_map.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "periodic/contact_memory.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <tuple>

namespace vibroimpact::periodic {

namespace {

// Of the time of a return.
constexpr double near_return = 1e-9; // what the last step leaves is its square
constexpr int most_return_steps = 30;
constexpr double largest_return_step = 0.1;
constexpr double least_return = 0.3, most_return = 3; // of the last one, where it is looked for
constexpr int looks_for_return = 400;
constexpr double least_angle = 1e-6; // sine of that between motion and plane, scaled

} // namespace

StroboscopicMap::StroboscopicMap(ForcedSystem &system, motion::VariationAccuracy accuracy,
                                 std::optional<Symmetry> symmetry)
    : system_(system), accuracy_(std::move(accuracy)),
      lineariser_(std::make_shared<motion::Lineariser>(system.trajectory(), accuracy_)),
      symmetry_(std::move(symmetry)) {}

motion::Trajectory &StroboscopicMap::start(double phase, const Vector &state) const {
  system_.trajectory().start({.time = phase * period(), .physical = state});
  return system_.trajectory();
}

Vector StroboscopicMap::rates(double phase, const Vector &state) const {
  start(phase, state);
  const Vector &full = system_.trajectory().state();
  Vector rates(full.size());
  system_.equations().rates(phase * period(), ConstVectorView(full.data(), full.size()),
                            VectorView(rates.data(), rates.size()));
  return rates.head(size());
}

Flow StroboscopicMap::flow(double from, double to, const Vector &state) const {
  const double begin = from * period(), end = to * period();
  std::vector<motion::KeyTangent *> keys;
  for (ForcedKey *key : keys_)
    keys.push_back(&key->tangent);
  PatternObserver pattern(system_.contacts(), begin);
  motion::LinearisedMotion motion =
      (*lineariser_)({.time = begin, .physical = state}, end, keys, &pattern);
  Flow flow{.state = std::move(motion.end.physical),
            .rates = motion.rates,
            .by_state = std::move(motion.by_state),
            .by_keys = Matrix(size(), static_cast<Index>(keys_.size())),
            .pattern = pattern.pattern(end),
            .determinant = motion.determinant,
            .without_derivative = motion.without_derivative};
  for (Index k = 0; k < flow.by_keys.cols(); ++k) {
    const double change = keys_[static_cast<std::size_t>(k)]->period;
    flow.by_keys.col(k) = motion.by_key.col(k) + motion.rates * (to * change);
    if (from != 0 && change != 0)
      flow.by_keys.col(k) -= flow.by_state * rates(from, state) * (from * change);
  }
  return flow;
}

std::vector<Index> StroboscopicMap::idle(double phase, const Vector &state) const {
  if (system_.layout().n_internal == 0)
    return {};
  start(phase, state);
  return idle_memory(system_.equations());
}

Flow StroboscopicMap::image(const Section &section, const Vector &state) const {
  const std::vector<Index> unseen = idle(section.phase, state);
  Vector begin = state;
  begin(unseen).setZero();
  Flow image =
      system_.free_period()
          ? return_to_plane(section, begin)
          : mirrored(section, flow(section.phase, section.phase + section.length(), begin));
  image.by_state(Eigen::all, unseen).setZero();
  return image;
}

Flow StroboscopicMap::mirrored(const Section &section, Flow flow) const {
  if (!section.with_symmetry())
    return flow;
  flow.state = mirrored(section, flow.state);
  flow.rates = mirrored(section, flow.rates);
  flow.by_state = mirrored(section, flow.by_state);
  flow.by_keys = mirrored(section, flow.by_keys);
  return flow;
}

void StroboscopicMap::set_period(double period) const {
  if (system_.free_period())
    system_.free_period()->set_period(period);
}

void StroboscopicMap::project(const Plane &plane, Flow &flow) {
  const double approach = plane.normal.dot(flow.rates);
  const Vector along = flow.rates / approach;
  flow.state -= along * plane.distance(flow.state);
  flow.by_state -= along * (plane.normal.transpose() * flow.by_state);
  flow.by_keys -= along * (plane.normal.transpose() * flow.by_keys);
}

StroboscopicMap::Return StroboscopicMap::step_to_return(const Section &section, const Plane &plane,
                                                        const Vector &there,
                                                        const Vector &rates) const {
  const double approach = plane.normal.dot(rates);
  const double size =
      plane.normal.cwiseQuotient(scale()).norm() * rates.cwiseProduct(scale()).norm();
  if (!(approach > least_angle * size))
    return Return::lost;
  const double share = -plane.distance(there) / (approach * section.length() * period());
  if (std::abs(share) > largest_return_step)
    return Return::lost;
  set_period(period() * (1 + share));
  return std::abs(share) <= near_return ? Return::there : Return::nearer;
}

const Plane &StroboscopicMap::plane(const Section &section, const Vector &begin) const {
  return system_.free_period()->plane(
      section.phase, [&] { return plane_across(begin, rates(0, begin), scale()); });
}

// The period becomes that of the return, by Newton's method from the last one; false where that
// leads away from it.
bool StroboscopicMap::refine_return(const Section &section, const Plane &plane,
                                    const Vector &begin) const {
  for (int i = 0; i < most_return_steps; ++i) {
    const Vector there = carry(0, section.length(), begin);
    const Vector speed = mirrored(section, rates(0, there));
    const Return step = step_to_return(section, plane, mirrored(section, there), speed);
    if (step != Return::nearer)
      return step == Return::there;
  }
  return false;
}

// The passage that is nearest to the last return.
double StroboscopicMap::look_for_return(const Section &section, const Plane &plane,
                                        const Vector &begin) const {
  const double last = section.length() * period();
  motion::Trajectory &trajectory = start(0, begin);
  const std::vector<Passage> found =
      passages(plane, scale(), least_return * last, most_return * last, looks_for_return,
               [&](double time) -> Vector {
                 trajectory.advance(time);
                 return mirrored(section, trajectory.motion_state().physical);
               });
  const auto nearest =
      std::min_element(found.begin(), found.end(), [&](const Passage &a, const Passage &b) {
        return std::abs(a.time - last) < std::abs(b.time - last);
      });
  return nearest == found.end() ? 0 : nearest->time / section.length();
}

void StroboscopicMap::find_return(const Section &section, const Plane &plane,
                                  const Vector &begin) const {
  const double last = period();
  if (refine_return(section, plane, begin))
    return;
  set_period(last);
  if (const double seen = look_for_return(section, plane, begin); seen > 0) {
    set_period(seen);
    if (refine_return(section, plane, begin))
      return;
  }
  throw NumericalError("the motion does not come back to where it is cut near the period of " +
                       std::to_string(last) + " s");
}

Flow StroboscopicMap::return_to_plane(const Section &section, const Vector &begin) const {
  const Plane &plane = this->plane(section, begin);
  const double before = period();
  try {
    find_return(section, plane, begin);
    Flow image = mirrored(section, flow(0, section.length(), begin));
    project(plane, image);
    return image;
  } catch (const NumericalError &) {
    set_period(before);
    throw;
  }
}

Flow StroboscopicMap::to_section(double from, double to, double phase, const Vector &state) const {
  Flow there = flow(from, to, state);
  if (!system_.free_period())
    return there;
  Plane plane = plane_across(there.state, there.rates, scale());
  project(plane, there);
  system_.free_period()->set_plane(phase, std::move(plane));
  return there;
}

Vector StroboscopicMap::carry(double from, double to, const Vector &state) const {
  start(from, state);
  system_.trajectory().advance(to * period());
  return system_.trajectory().motion_state().physical;
}

void StroboscopicMap::observe(double from, double to, const Vector &state,
                              motion::Observer &observer) const {
  start(from, state);
  system_.trajectory().advance(to * period(), observer);
}

Eigen::VectorXcd multipliers_of(const Matrix &by_state, const Vector &scale) {
  const Matrix scaled = scale.asDiagonal() * by_state * scale.cwiseInverse().asDiagonal();
  const auto found = try_eigenvalues(scaled);
  if (!found)
    throw NumericalError("the multipliers of the motion could not be computed");
  ComplexVector values = *found;
  const auto order = [](const std::complex<double> &value) {
    return std::make_tuple(-std::abs(value), -value.real(), -value.imag());
  };
  std::sort(values.begin(), values.end(),
            [&](const auto &a, const auto &b) { return order(a) < order(b); });
  return values;
}

} // namespace vibroimpact::periodic
