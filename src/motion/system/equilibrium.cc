#include "motion/system/equilibrium.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "motion/system/equations.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace vibroimpact::motion {

using contact::LocalState;
using model::Model;

namespace {

class StaticProblem {
public:
  StaticProblem(const Model &model, const contact::ContactSet &contacts, const Vector &load)
      : model_(model), equations_(model, contacts), load_(load),
        stiffness_(model.stiffness().dense()) {
    for (const model::Rotor &rotor : model.rotors().list())
      fixed_.push_back(rotor.angle);
  }

  // Rigid contacts that are held closed, each by a force of its own.
  void press(std::vector<std::size_t> contacts) { pressed_ = std::move(contacts); }
  // Springs that hardly hold every coordinate.
  void hold_weakly(bool hold) {
    weak_ = hold ? 1e-6 * std::max(1.0, stiffness_.cwiseAbs().maxCoeff()) : 0;
  }
  Index size() const { return model_.size() + static_cast<Index>(pressed_.size()); }

  // Unbalanced force at [q, forces of the pressed contacts], and their gaps as forces of a spring;
  // size() entries, and the derivative of all that.
  Vector residual(const Vector &unknown, Matrix &derivative) {
    const Index n = model_.size();
    const Vector q = unknown.head(n);
    Matrix by_position;
    Vector all(size());
    all.head(n) = unbalanced(q, by_position);
    derivative = Matrix::Zero(size(), size());
    derivative.topLeftCorner(n, n) = by_position;
    const double spring = std::max(1.0, stiffness_.cwiseAbs().maxCoeff());
    for (Index k = n; k < size(); ++k) {
      const std::size_t contact = pressed_[static_cast<std::size_t>(k - n)];
      const Vector x = at_rest(q);
      const RowVector row =
          equations_.row_along(contact, 0, 0, ConstVectorView(x.data(), x.size()));
      all.head(n) += unknown[k] * row.transpose();
      if (equations_.contacts().pairs()[contact].circle)
        add_turning(contact, x, {.force = unknown[k]}, derivative);
      all[k] = spring * local(contact, q).gap;
      derivative.col(k).head(n) = row.transpose();
      derivative.row(k).head(n) = spring * row;
    }
    return all;
  }

  // Unbalanced force at q without the pressed contacts, n entries, and its derivative, n x n.
  Vector unbalanced(const Vector &q, Matrix &derivative) {
    derivative = -stiffness_;
    derivative.diagonal().array() -= weak_;
    Vector force = load_ - stiffness_ * q - weak_ * q;
    const ConstVectorView view(q.data(), q.size());
    model_.add_cubic_forces(0, view, VectorView(force.data(), force.size()));
    Matrix cubic = Matrix::Zero(q.size(), q.size());
    model_.add_cubic_stiffness(0, view, cubic);
    derivative -= cubic;
    for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
      add_contact(c, q, force, derivative);
    for (const Index j : fixed_) {
      force[j] = 0;
      derivative.row(j).setZero();
      derivative.col(j).setZero();
    }
    return force;
  }

  double gap(std::size_t contact, const Vector &q) const { return local(contact, q).gap; }

  // Size of the forces among which the residual must vanish.
  double scale(const Vector &unknown) const {
    const Vector q = unknown.head(model_.size());
    return load_.cwiseAbs().maxCoeff() + (stiffness_ * q).cwiseAbs().maxCoeff() +
           (pressed_.empty() ? 0 : unknown.tail(unknown.size() - q.size()).cwiseAbs().maxCoeff());
  }

private:
  Vector at_rest(const Vector &q) const {
    Vector x = Vector::Zero(equations_.layout().size());
    x.head(q.size()) = q;
    return x;
  }

  LocalState local(std::size_t contact, const Vector &q) const {
    const Vector x = at_rest(q);
    LocalState state = equations_.local_state(contact, 0, ConstVectorView(x.data(), x.size()));
    state.gap_rate = 0;
    state.internal = equations_.contacts().pairs()[contact].law->initial_internal();
    return state;
  }

  void add_contact(std::size_t c, const Vector &q, Vector &force, Matrix &derivative) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    LocalState state = local(c, q);
    if (state.gap >= 0 && !pair.law->always_in_contact())
      return;
    const contact::SettledMode settled = contact::settle(*pair.law, state);
    state.internal = settled.internal;
    pair.law->evaluate(settled.mode, state, response_);
    if (pair.circle)
      return add_circular(c, q, force, derivative);
    force += response_.force * pair.gap.row.transpose();
    derivative += response_.force_by_gap * pair.gap.row.transpose() * pair.gap.row;
  }

  // The law having been evaluated; nothing slides.
  void add_circular(std::size_t c, const Vector &q, Vector &force, Matrix &derivative) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const Vector x = at_rest(q);
    response_.tangential[0] = {};
    const contact::AcrossAxis push =
        pair.circle->force(equations_.frame(c, 0, ConstVectorView(x.data(), x.size())), response_);
    for (int d = 0; d < 2; ++d)
      force += push[static_cast<std::size_t>(d)] * pair.along(d).projection->row.transpose();
    add_turning(c, x, response_, derivative);
  }

  // Of the force as a vector, whose normal turns, by the coordinates.
  void add_turning(std::size_t c, const Vector &x, const contact::LawResponse &response,
                   Matrix &derivative) const {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const Index n = equations_.layout().n;
    const std::array<contact::AffineForm, 2> by = pair.circle->force_gradient(
        equations_.frame(c, 0, ConstVectorView(x.data(), x.size())), response);
    for (int d = 0; d < 2; ++d)
      for (int other = 0; other < 2; ++other)
        derivative.topLeftCorner(n, n) += by[static_cast<std::size_t>(d)].along(other).position *
                                          pair.along(d).projection->row.transpose() *
                                          pair.along(other).projection->row;
  }

  const Model &model_;
  Equations equations_;
  const Vector &load_;
  Matrix stiffness_;
  std::vector<Index> fixed_;
  std::vector<std::size_t> pressed_;
  double weak_ = 0; // [N/m]
  contact::LawResponse response_;
};

// One Newton step, halved until the residual falls; false when it no longer does.
bool improve(StaticProblem &problem, Vector &q, Vector &residual, Matrix &derivative) {
  const Vector step = -least_norm_solution(derivative, residual);
  for (double share = 1; share > 1e-9; share /= 2) {
    const Vector trial = q + share * step;
    Matrix trial_derivative;
    const Vector trial_residual = problem.residual(trial, trial_derivative);
    if (trial_residual.norm() < residual.norm()) {
      q = trial;
      residual = trial_residual;
      derivative = std::move(trial_derivative);
      return true;
    }
  }
  return false;
}

// [q, forces of the pressed contacts] from q on; nothing when they do not balance.
std::optional<Vector> balance(StaticProblem &problem, const Vector &q, double &unbalanced) {
  constexpr int maximum_iterations = 200;
  constexpr double tolerance = 1e3 * std::numeric_limits<double>::epsilon();
  Vector unknown = Vector::Zero(problem.size());
  unknown.head(q.size()) = q;
  Matrix derivative;
  Vector residual = problem.residual(unknown, derivative);
  for (int i = 0; i < maximum_iterations && residual.norm() > 0; ++i)
    if (!improve(problem, unknown, residual, derivative))
      break;
  unbalanced = residual.cwiseAbs().maxCoeff();
  if (unbalanced > tolerance * problem.scale(unknown))
    return std::nullopt;
  return unknown;
}

struct Balance {
  Vector unknown;
  std::vector<std::size_t> pressed;
};

// Lets go of the rigid contact that pulls most, or else presses the one that overlaps most, until
// none does either.
std::optional<Balance> balance_from(StaticProblem &problem, std::vector<std::size_t> pressed,
                                    const std::vector<std::size_t> &rigid, Index n,
                                    double &unbalanced) {
  constexpr double rounding = 1e-12;
  Vector q = Vector::Zero(n); // in a circular gap the last place says where the sides meet
  for (std::size_t change = 0; change <= 4 * rigid.size(); ++change) {
    problem.press(pressed);
    const std::optional<Vector> unknown = balance(problem, q, unbalanced);
    if (!unknown)
      return std::nullopt;
    const Vector forces = unknown->tail(unknown->size() - n);
    Index pulling = 0;
    if (forces.size() > 0 && forces.minCoeff(&pulling) < -rounding * problem.scale(*unknown)) {
      pressed.erase(pressed.begin() + pulling);
      continue;
    }
    q = unknown->head(n);
    const auto deeper = [&](std::size_t a, std::size_t b) {
      return problem.gap(a, q) < problem.gap(b, q);
    };
    const auto deepest = std::min_element(rigid.begin(), rigid.end(), deeper);
    if (deepest == rigid.end() ||
        problem.gap(*deepest, q) >= -rounding * std::max(1e-3, q.cwiseAbs().maxCoeff()))
      return Balance{.unknown = *unknown, .pressed = pressed};
    pressed.push_back(*deepest);
  }
  return std::nullopt;
}

} // namespace

Equilibrium static_equilibrium(const Model &model, const contact::ContactSet &contacts,
                               const Vector &load) {
  StaticProblem problem(model, contacts, load);
  std::vector<std::size_t> rigid;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.pairs()[c].law->rigid())
      rigid.push_back(c);
  double unbalanced = 0;
  std::optional<Balance> found = balance_from(problem, {}, rigid, model.size(), unbalanced);
  if (!found && !rigid.empty()) { // what nothing else holds may lie on a stop
    problem.hold_weakly(true);
    found = balance_from(problem, {}, rigid, model.size(), unbalanced);
    problem.hold_weakly(false);
    if (found)
      found = balance_from(problem, found->pressed, rigid, model.size(), unbalanced);
  }
  if (!found)
    throw NumericalError("no static equilibrium under the constant loads was found; residual "
                         "force " +
                         std::to_string(unbalanced) + " N");
  Equilibrium equilibrium{.displacement = found->unknown.head(model.size()), .closed = {}};
  for (std::size_t c = 0; c < contacts.size(); ++c)
    equilibrium.closed.push_back(contacts.pairs()[c].law->rigid()
                                     ? std::find(found->pressed.begin(), found->pressed.end(), c) !=
                                           found->pressed.end()
                                     : problem.gap(c, equilibrium.displacement) < 0);
  return equilibrium;
}

} // namespace vibroimpact::motion
