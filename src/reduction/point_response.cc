#include "reduction/point_response.h"

#include "modes/impulse_response.h"
#include "modes/static_solution.h"
#include "reduction/basis.h"

namespace vibroimpact::reduction {

namespace {

using structure::AssembledBody;

/// Unit forces at the points along each axis; none where a point is held.
Matrix unit_forces(const AssembledBody &body) {
  const auto points = static_cast<Index>(body.model.points.size());
  Matrix forces = Matrix::Zero(body.free.size, 3 * points);
  for (Index p = 0; p < points; ++p)
    for (Index axis = 0; axis < 3; ++axis)
      for (const auto &[dof, factor] : body.free.terms(body.model.points[p].node, axis))
        forces(dof, 3 * p + axis) = factor;
  return forces;
}

/// The 3 x 3 block of each point of forces^T answers, which is symmetric but for rounding.
std::vector<Matrix> blocks(const Matrix &forces, const Matrix &answers) {
  std::vector<Matrix> all;
  for (Index first = 0; first < forces.cols(); first += 3) {
    const Matrix moved = forces.middleCols(first, 3).transpose() * answers.middleCols(first, 3);
    all.emplace_back((moved + moved.transpose()) / 2);
  }
  return all;
}

void solve_statics(const AssembledBody &body, const modes::EigenProblem &problem,
                   const Matrix &forces, PointResponse &response) {
  const Index given = body.model.loaded ? 1 : 0;
  if (given + forces.cols() == 0)
    return;
  Matrix loads(body.free.size, given + forces.cols());
  loads << body.load.replicate(1, given), forces;
  const Matrix solution = modes::static_solution(problem, loads);
  if (given > 0)
    response.deflection = node_rows(body.free, solution.col(0));
  response.flexibility = blocks(forces, solution.rightCols(forces.cols()));
}

/// Per point: whether each of its free displacements has mass.
std::vector<bool> massive_points(const AssembledBody &body) {
  const Vector mass = modes::diagonal(body.mass.get());
  std::vector<bool> massive;
  for (const structure::NamedNode &point : body.model.points) {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const auto &[dof, factor] : body.free.terms(point.node, axis))
        all = all && mass[dof] > 0;
    massive.push_back(all);
  }
  return massive;
}

void solve_impulses(const AssembledBody &body, Matrix forces, PointResponse &response) {
  if (forces.cols() == 0)
    return;
  const std::vector<bool> massive = massive_points(body);
  for (std::size_t p = 0; p < massive.size(); ++p)
    if (!massive[p])
      forces.middleCols(static_cast<Index>(3 * p), 3).setZero();
  response.inverse_mass = blocks(forces, modes::impulse_response(body.mass.get(), forces));
  for (std::size_t p = 0; p < massive.size(); ++p)
    if (!massive[p])
      response.inverse_mass[p] = Matrix();
}

} // namespace

PointResponse point_response(const AssembledBody &body, const modes::EigenProblem &problem,
                             bool held) {
  const Matrix forces = unit_forces(body);
  PointResponse response;
  if (held)
    solve_statics(body, problem, forces, response);
  problem.factorised->release(); // before that of the mass matrix
  if (problem.mass_rank == body.massive_dofs)
    solve_impulses(body, forces, response);
  else // the mass has no inverse
    response.inverse_mass.resize(body.model.points.size());
  return response;
}

} // namespace vibroimpact::reduction
