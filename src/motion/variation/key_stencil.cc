#include "motion/variation/key_stencil.h"

#include "common/decompositions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::motion {

namespace {

// What goes with the power p of a key differs in both derivatives by (p - 1)(p - 2) / 6 h^2 with
// neighbours at both sides, by twice that with those at one side: 2.4e-5 for p = 10 at h = 1e-3,
// where a kink at the present value changes it by its jump of the slope over the slope.
constexpr double smooth = 3e-5;

void append(const contact::AffineForm &form, std::vector<double> &list) {
  list.insert(list.end(), {form.constant, form.gap, form.gap_rate, form.normal_force});
  if (form.normal_force_rate != 0)
    list.push_back(form.normal_force_rate);
  list.insert(list.end(), form.internal.begin(), form.internal.end());
  for (const contact::DirectionForm &of : form.tangential)
    if (!of.zero())
      list.insert(list.end(), {of.position, of.rate, of.force});
}

Eigen::Map<const Vector> numbers_of(const ModelData &data) {
  return {data.numbers.data(), static_cast<Index>(data.numbers.size())};
}

// Of all numbers, from the neighbours at these places.
Vector derivative(const std::vector<double> &offsets, const ModelData &present,
                  const std::vector<ModelData> &neighbours,
                  const std::vector<std::size_t> &places) {
  std::vector<double> used;
  for (const std::size_t place : places)
    used.push_back(offsets[place]);
  const Vector weights = derivative_weights(used);
  Vector sum = Vector::Zero(static_cast<Index>(present.numbers.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    sum +=
        weights[static_cast<Index>(i)] * (numbers_of(neighbours[places[i]]) - numbers_of(present));
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
  return solve_fully_pivoted(powers, Vector::Unit(size, 0)) / largest;
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
    sizes.push_back(pair.circle ? 1 : 0);
    for (const contact::Mode &mode : pair.law->modes()) {
      sizes.push_back(mode.affine.has_value() ? 1 : 0);
      for (const contact::Guard &guard : mode.guards)
        sizes.insert(sizes.end(), {static_cast<std::size_t>(guard.target), guard.reset.size()});
    }
  }
  return sizes;
}

ModelData data_of(const model::Model &model, const contact::ContactSet &contacts) {
  ModelData data;
  std::vector<double> &numbers = data.numbers;
  const auto add = [&](const auto &values) {
    numbers.insert(numbers.end(), values.data(), values.data() + values.size());
    data.ends.push_back(numbers.size());
  };
  add(model.mass());
  add(model.stiffness().dense());
  add(model.damping().dense());
  for (const model::Source &source : model.sources())
    for (const Vector *load : {&source.load, &source.rate_load, &source.inertial_load})
      add(*load);
  for (const contact::ContactPair &pair : contacts.pairs()) {
    for (int d = 0; d < pair.n_directions(); ++d) {
      const contact::Direction along = pair.along(d);
      add(along.projection->row);
      const double place = along.offset + along.speed; // one of them is zero
      add(Eigen::Map<const Vector>(&place, 1));
    }
    if (pair.circle) {
      add(std::array{pair.circle->clearance()});
      add(std::array{pair.circle->surface_speed()});
    }
    for (const contact::Mode &mode : pair.law->modes())
      for (const contact::Guard &guard : mode.guards) {
        append(guard.indicator, numbers);
        data.ends.push_back(numbers.size());
      }
  }
  return data;
}

bool is_smooth(const std::vector<double> &offsets, const ModelData &present,
               const std::vector<ModelData> &neighbours) {
  std::vector<std::size_t> order(offsets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<std::size_t> all = order;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(offsets[a]) < std::abs(offsets[b]);
  });
  order.resize(2); // the nearest ones
  const double rounding = 64 * std::numeric_limits<double>::epsilon() / std::abs(offsets[order[0]]);
  const Vector fine = derivative(offsets, present, neighbours, all);
  const Vector apart = fine - derivative(offsets, present, neighbours, order);
  Index begin = 0;
  for (const std::size_t end : present.ends) {
    const Index size = static_cast<Index>(end) - begin;
    const auto largest = [&](const auto &of) {
      return of.segment(begin, size).cwiseAbs().maxCoeff();
    };
    if (size > 0 &&
        !(largest(apart) <= smooth * largest(fine) + rounding * largest(numbers_of(present))))
      return false;
    begin += size;
  }
  return true;
}

} // namespace vibroimpact::motion
