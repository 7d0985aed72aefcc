#include "motion/variation/key_stencil.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::motion {

namespace {

constexpr double smooth = 3e-5;

void append(const contact::AffineForm &form, std::vector<double> &list) {
  list.insert(list.end(), {form.constant, form.gap, form.gap_rate, form.normal_force});
  list.insert(list.end(), form.internal.begin(), form.internal.end());
}

Vector flat(const Matrix &matrix) { return Eigen::Map<const Vector>(matrix.data(), matrix.size()); }

Vector derivative(const std::vector<double> &offsets, const Vector &present,
                  const std::vector<const Vector *> &neighbours) {
  const Vector weights = derivative_weights(offsets);
  Vector sum = Vector::Zero(present.size());
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    sum += weights[static_cast<Index>(i)] * (*neighbours[i] - present);
  return sum;
}

} // namespace

Vector derivative_weights(const std::vector<double> &offsets) {
  const auto size = static_cast<Index>(offsets.size());
  double largest = 0;
  for (const double offset : offsets)
    largest = std::max(largest, std::abs(offset));
  Matrix powers(size, size);
  for (Index i = 0; i < size; ++i)
    for (Index m = 0; m < size; ++m)
      powers(m, i) =
          std::pow(offsets[static_cast<std::size_t>(i)] / largest, static_cast<double>(m + 1));
  return powers.fullPivLu().solve(Vector::Unit(size, 0)) / largest;
}

std::vector<std::size_t> structure_of(const model::Model &model,
                                      const contact::ContactSet &contacts) {
  std::vector<std::size_t> sizes = {static_cast<std::size_t>(model.size()),
                                    model.sources().size(),
                                    model.connections().size(),
                                    model.rotors().list().size(),
                                    static_cast<std::size_t>(model.n_drive()),
                                    contacts.size()};
  for (const contact::ContactPair &pair : contacts.pairs()) {
    sizes.push_back(static_cast<std::size_t>(pair.n_internal()));
    for (const contact::Mode &mode : pair.law->modes()) {
      sizes.push_back(mode.affine.has_value() ? 1 : 0);
      for (const contact::Guard &guard : mode.guards)
        sizes.insert(sizes.end(), {static_cast<std::size_t>(guard.target), guard.reset.size()});
    }
  }
  return sizes;
}

std::vector<Vector> data_of(const model::Model &model, const contact::ContactSet &contacts) {
  std::vector<Vector> data = {model.mass(), flat(model.stiffness().dense()),
                              flat(model.damping().dense())};
  for (const model::Source &source : model.sources())
    data.insert(data.end(), {source.load, source.rate_load, source.inertial_load});
  std::vector<double> numbers;
  for (const contact::ContactPair &pair : contacts.pairs()) {
    data.emplace_back(pair.gap.row.transpose());
    numbers.assign(1, pair.clearance);
    data.push_back(Eigen::Map<const Vector>(numbers.data(), 1));
    for (const contact::Mode &mode : pair.law->modes())
      for (const contact::Guard &guard : mode.guards) {
        numbers.clear();
        append(guard.indicator, numbers);
        data.push_back(
            Eigen::Map<const Vector>(numbers.data(), static_cast<Index>(numbers.size())));
      }
  }
  return data;
}

bool is_smooth(const std::vector<double> &offsets, const std::vector<Vector> &present,
               const std::vector<std::vector<Vector>> &neighbours) {
  std::vector<std::size_t> order(offsets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(offsets[a]) < std::abs(offsets[b]);
  });
  const std::vector<double> nearest = {offsets[order[0]], offsets[order[1]]};
  const double rounding = 64 * std::numeric_limits<double>::epsilon() / std::abs(nearest[0]);
  for (std::size_t k = 0; k < present.size(); ++k) {
    if (present[k].size() == 0)
      continue;
    std::vector<const Vector *> all;
    all.reserve(neighbours.size());
    for (const std::vector<Vector> &data : neighbours)
      all.push_back(&data[k]);
    const Vector fine = derivative(offsets, present[k], all);
    const Vector coarse = derivative(nearest, present[k], {all[order[0]], all[order[1]]});
    const double apart = (fine - coarse).cwiseAbs().maxCoeff();
    if (!(apart <=
          smooth * fine.cwiseAbs().maxCoeff() + rounding * present[k].cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

} // namespace vibroimpact::motion
