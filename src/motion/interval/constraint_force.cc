#include "motion/interval/constraint_force.h"

#include "common/decompositions.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

namespace {

constexpr Index degree = Bernstein::dense_degree;

// Chebyshev points of the second kind: interpolation there is within a small factor of the best.
double node(Index i) {
  return 0.5 * (1 - std::cos(std::numbers::pi * static_cast<double>(i) / degree));
}

// Takes the values at the nodes to Bernstein coefficients.
Matrix coefficients_from_values() {
  Matrix basis(degree + 1, degree + 1);
  for (Index i = 0; i <= degree; ++i) {
    double binomial = 1;
    for (Index k = 0; k <= degree; ++k) {
      basis(i, k) = binomial * std::pow(node(i), static_cast<double>(k)) *
                    std::pow(1 - node(i), static_cast<double>(degree - k));
      binomial *= static_cast<double>(degree - k) / static_cast<double>(k + 1);
    }
  }
  return inverse(basis);
}

/// The whole state along one step, from its polynomials.
class DenseState {
public:
  explicit DenseState(const StepView &view) : layout_(view.equations().layout()) {
    for (Index j = 0; j < layout_.n; ++j) {
      coordinates_.push_back(view.coordinate(j));
      velocities_.push_back(
          view.velocity({.row = RowVector::Unit(layout_.n, j), .base_coefficients = {}}));
    }
    for (Index i = 0; i < layout_.n_internal; ++i)
      others_.push_back(view.internal(i));
    for (Index i = 0; i < layout_.n_drive; ++i)
      others_.push_back(view.drive(i));
  }

  /// The state at tau in [0, 1], the work integrals at zero.
  void at(double tau, Vector &state) const {
    state.setZero(layout_.size());
    for (std::size_t j = 0; j < coordinates_.size(); ++j) {
      state[static_cast<Index>(j)] = coordinates_[j](tau);
      state[layout_.velocity() + static_cast<Index>(j)] = velocities_[j](tau);
    }
    for (std::size_t i = 0; i < others_.size(); ++i)
      state[layout_.internal() + static_cast<Index>(i)] = others_[i](tau);
  }

private:
  StateLayout layout_;
  std::vector<Bernstein> coordinates_, velocities_, others_;
};

} // namespace

Bernstein local_curve(const StepView &view, std::size_t contact, const LocalValue &value) {
  static const Matrix to_coefficients = coefficients_from_values();
  const DenseState motion(view);
  const auto at = [&](double time, const Vector &state) {
    return value(
        view.equations().local_state(contact, time, ConstVectorView(state.data(), state.size())));
  };
  Vector values(degree + 1);
  Vector state;
  for (Index i = 1; i < degree; ++i) {
    motion.at(node(i), state);
    values[i] = at(view.start() + node(i) * view.length(), state);
  }
  values[0] = at(view.start(), view.start_state());
  values[degree] = at(view.end(), view.end_state());
  Vector coefficients = to_coefficients * values;
  coefficients[0] = values[0];
  coefficients[degree] = values[degree];
  return Bernstein::of_coefficients({coefficients.data(), static_cast<std::size_t>(degree + 1)});
}

std::function<double(double tau)> local_function(const StepView &view, std::size_t contact,
                                                 LocalValue value) {
  return [view, contact, value = std::move(value), motion = DenseState(view)](double tau) {
    Vector state;
    motion.at(tau, state);
    return value(view.equations().local_state(contact, view.start() + tau * view.length(),
                                              ConstVectorView(state.data(), state.size())));
  };
}

Bernstein constraint_force(const StepView &view, std::size_t contact, int direction) {
  if (!view.equations().mode(contact).holds(direction))
    return Bernstein(0);
  return local_curve(view, contact, contact::AffineForm::force_along(direction));
}

} // namespace vibroimpact::motion
