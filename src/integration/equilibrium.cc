#include "integration/equilibrium.h"

#include "common/error.h"
#include "integration/equations.h"

#include <Eigen/QR>

#include <limits>

namespace vibroimpact {

namespace {

class StaticProblem {
public:
  StaticProblem(const Model &model, const ContactSet &contacts, const Vector &load)
      : model_(model), equations_(model, contacts), load_(load),
        stiffness_(model.stiffness().dense()) {
    for (const Rotor &rotor : model.rotors().list())
      fixed_.push_back(rotor.angle);
  }

  // Unbalanced force at q, n entries, and its derivative, n x n.
  Vector residual(const Vector &q, Matrix &derivative) {
    derivative = -stiffness_;
    Vector force = load_ - stiffness_ * q;
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

  bool closed(std::size_t contact, const Vector &q) const { return local(contact, q).gap < 0; }

  // Size of the forces among which the residual must vanish.
  double scale(const Vector &q) const {
    return load_.cwiseAbs().maxCoeff() + (stiffness_ * q).cwiseAbs().maxCoeff();
  }

private:
  LocalState local(std::size_t contact, const Vector &q) const {
    const StateLayout &layout = equations_.layout();
    Vector x = Vector::Zero(layout.size());
    x.head(layout.n) = q;
    LocalState state = equations_.local_state(contact, 0, ConstVectorView(x.data(), x.size()));
    state.gap_rate = 0;
    state.internal = equations_.contacts().pairs()[contact].law->initial_internal();
    return state;
  }

  void add_contact(std::size_t c, const Vector &q, Vector &force, Matrix &derivative) {
    const ContactPair &pair = equations_.contacts().pairs()[c];
    LocalState state = local(c, q);
    if (state.gap >= 0)
      return;
    const SettledMode settled = settle(*pair.law, state);
    // States that follow the gap at entry follow it here too.
    LocalState shifted = state;
    shifted.gap *= 2;
    const SettledMode further = settle(*pair.law, shifted);
    const double shift = shifted.gap - state.gap;
    state.internal = settled.internal;
    pair.law->evaluate(settled.mode, state, response_);
    double by_gap = response_.force_by_gap;
    for (std::size_t i = 0; i < settled.internal.size(); ++i)
      by_gap +=
          response_.force_by_internal[i] * (further.internal[i] - settled.internal[i]) / shift;
    force += response_.force * pair.gap.row.transpose();
    derivative += by_gap * pair.gap.row.transpose() * pair.gap.row;
  }

  const Model &model_;
  Equations equations_;
  const Vector &load_;
  Matrix stiffness_;
  std::vector<Index> fixed_;
  LawResponse response_;
};

// One Newton step, halved until the residual falls; false when it no longer does.
bool improve(StaticProblem &problem, Vector &q, Vector &residual, Matrix &derivative) {
  const Vector step = -derivative.completeOrthogonalDecomposition().solve(residual);
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

} // namespace

Equilibrium static_equilibrium(const Model &model, const ContactSet &contacts, const Vector &load) {
  constexpr int maximum_iterations = 200;
  constexpr double tolerance = 1e3 * std::numeric_limits<double>::epsilon();
  StaticProblem problem(model, contacts, load);
  Equilibrium equilibrium{.displacement = Vector::Zero(model.size()), .closed = {}};
  Matrix derivative;
  Vector residual = problem.residual(equilibrium.displacement, derivative);
  for (int i = 0; i < maximum_iterations && residual.norm() > 0; ++i)
    if (!improve(problem, equilibrium.displacement, residual, derivative))
      break;
  if (residual.cwiseAbs().maxCoeff() > tolerance * problem.scale(equilibrium.displacement))
    throw NumericalError("nothing balances the constant loads, or no equilibrium was found; "
                         "unbalanced " +
                         std::to_string(residual.cwiseAbs().maxCoeff()) + " N");
  for (std::size_t c = 0; c < contacts.size(); ++c)
    equilibrium.closed.push_back(problem.closed(c, equilibrium.displacement));
  return equilibrium;
}

} // namespace vibroimpact
