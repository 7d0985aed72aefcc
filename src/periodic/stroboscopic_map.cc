#include "periodic/stroboscopic_map.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "periodic/contact_memory.h"

#include <algorithm>
#include <complex>
#include <tuple>

namespace vibroimpact::periodic {

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
  Flow image = flow(section.phase, section.phase + section.length(), begin);
  image.by_state(Eigen::all, unseen).setZero();
  if (section.with_symmetry()) {
    image.state = mirrored(section, image.state);
    image.by_state = mirrored(section, image.by_state);
    image.by_keys = mirrored(section, image.by_keys);
  }
  return image;
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
