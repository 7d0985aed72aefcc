#include "reduction/reduce.h"

#include "reduction/basis_rule.h"
#include "reduction/body_file.h"
#include "reduction/lumped_body.h"
#include "reduction/rotor_body.h"
#include "structure/assembly.h"

#include <algorithm>

namespace vibroimpact {

namespace {

using structure::AssembledBody;
using structure::DefinitionError;

// Rows of free degrees of freedom -> rows 6 node + component, 0 where held.
Matrix node_rows(const structure::FreeDofs &free, const Matrix &shapes) {
  Matrix rows = Matrix::Zero(6 * static_cast<Index>(free.number.size()), shapes.cols());
  for (std::size_t node = 0; node < free.number.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (const int dof = free.number[node][component]; dof >= 0)
        rows.row(static_cast<Index>(6 * node) + component) = shapes.row(dof);
  return rows;
}

Matrix free_rows(const structure::FreeDofs &free, const Matrix &shapes) {
  Matrix rows(free.size, shapes.cols());
  for (std::size_t node = 0; node < free.number.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (const int dof = free.number[node][component]; dof >= 0)
        rows.row(dof) = shapes.row(static_cast<Index>(6 * node) + component);
  return rows;
}

modes::NormalModes solve(const AssembledBody &body, const modes::Selection &selection) {
  try {
    return modes::normal_modes({.stiffness = body.stiffness.get(),
                                .mass = body.mass.get(),
                                .accurate_stiffness = body.accurate_stiffness->matrix(),
                                .mass_rank = body.massive_dofs},
                               selection);
  } catch (const modes::TooManyModes &too_many) {
    throw DefinitionError("Modes", "", "Number",
                          "must not exceed the number of free degrees of freedom with mass, " +
                              std::to_string(too_many.available));
  }
}

Recovery recovery(const structure::LineMesh &mesh, Matrix shapes) {
  Recovery result;
  result.nodes.resize(3, static_cast<Index>(mesh.nodes.size()));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    result.nodes.col(static_cast<Index>(node)) = mesh.nodes[node];
  result.lines = mesh.cells;
  result.shapes = std::move(shapes);
  return result;
}

Matrix diagonal(const Vector &entries) { return entries.asDiagonal(); }

Matrix viscous_damping(const Damping &damping, const AssembledBody &body, const Matrix &shapes) {
  const double mass = body.model.distributed_mass();
  if (!(mass > 0))
    throw DefinitionError("Modes", "", "Damping model",
                          "= viscous needs a body with distributed mass (Density > 0)");
  const Matrix projected =
      modes::project(body.distributed_mass.get(), free_rows(body.free, shapes));
  return damping.viscous_constant / mass * (projected + projected.transpose()) / 2;
}

Matrix modal_damping(const Damping &damping, const AssembledBody &body, const Vector &stiffness,
                     const Matrix &shapes) {
  if (damping.model == Damping::Model::viscous)
    return viscous_damping(damping, body, shapes);
  if (damping.model == Damping::Model::rayleigh)
    return diagonal((damping.alpha + damping.beta * stiffness.array()).matrix());
  Vector ratio(stiffness.size());
  for (Index j = 0; j < ratio.size(); ++j)
    ratio[j] = damping.ratios[std::min<std::size_t>(j, damping.ratios.size() - 1)];
  return diagonal((2 * ratio.array() * stiffness.array().sqrt()).matrix());
}

ReducedBody beam_body(const BodyDefinition &definition, MPI_Comm communicator) {
  const AssembledBody assembled =
      structure::assemble(structure::build_frame(definition.beam), communicator);
  const modes::NormalModes modes = solve(assembled, definition.selection);
  if (modes.number == 0)
    throw DefinitionError("Modes", "", "Band", "must hold at least one natural frequency");

  std::vector<int> point_nodes;
  for (const structure::NamedNode &point : assembled.model.points)
    point_nodes.push_back(point.node);
  Matrix shapes = node_rows(assembled.free, modes.shapes);
  fix_basis(modes.eigenvalues, point_nodes, shapes);
  shapes = Matrix(shapes.middleCols(modes.first, modes.number));

  ReducedBody body;
  body.name = definition.name;
  body.type = "beam";
  body.mass = Vector::Ones(modes.number);
  body.stiffness = merge_multiple(modes.eigenvalues).segment(modes.first, modes.number);
  body.damping = modal_damping(definition.damping, assembled, body.stiffness, shapes);
  body.base_participation = free_rows(assembled.free, shapes).transpose() * assembled.base_inertia;
  for (const structure::NamedNode &point : assembled.model.points)
    body.points.push_back(
        {point.name, assembled.model.mesh.nodes[point.node], shapes.middleRows(6 * point.node, 6)});
  body.recovery = recovery(assembled.model.mesh, std::move(shapes));
  body.total_mass.setConstant(assembled.model.total_mass());
  body.eigen_residual = modes.error_bounds.segment(modes.first, modes.number);
  body.orthogonality_residual = modes.orthogonality_residual;
  return body;
}

} // namespace

ReducedBody reduce(const BodyDefinition &definition, MPI_Comm communicator) {
  if (definition.type == BodyDefinition::Type::lumped)
    return lumped_body(definition);
  if (definition.type == BodyDefinition::Type::rotor)
    return rotor_body(definition);
  return broadcast(beam_body(definition, communicator), communicator);
}

} // namespace vibroimpact
