#include "modes/static_solution.h"
#include "reduction/basis.h"
#include "reduction/basis_rule.h"

#include <limits>

namespace vibroimpact::reduction {

using structure::AssembledBody;
using structure::DefinitionError;

namespace {

// Rigid motions come out of static solutions and have their round-off. Below this fraction of the
// lowest eigenvalue of the held body an eigenvalue is that of a rigid motion.
constexpr double rigid_fraction = 1e-14;

AssembledBody held_at(const std::vector<InterfaceDof> &dofs, const AssembledBody &body,
                      MPI_Comm communicator) {
  structure::BodyModel model = body.model;
  for (const InterfaceDof &dof : dofs)
    model.fixed[dof.node][dof.axis] = true;
  return structure::assemble(std::move(model), communicator);
}

/// Holding a node of a rigid body leaves no motion in which it moves alone.
void check_links(const std::vector<InterfaceDof> &dofs, const AssembledBody &body) {
  for (const InterfaceDof &dof : dofs)
    if (body.free.linked.contains(dof.node))
      throw DefinitionError("Modes", "", "Attachments",
                            "must not name places of a Rigid link for Reduction = fixed interface");
}

Matrix unit_displacements(const std::vector<InterfaceDof> &dofs, Index rows) {
  Matrix unit = Matrix::Zero(rows, static_cast<Index>(dofs.size()));
  for (std::size_t j = 0; j < dofs.size(); ++j)
    unit(Index{6} * dofs[j].node + dofs[j].axis, static_cast<Index>(j)) = 1;
  return unit;
}

/// Static shapes on all nodes for a unit displacement of each of the interface's.
Matrix constraint_modes(const std::vector<InterfaceDof> &dofs, const AssembledBody &body,
                        const AssembledBody &held, const modes::EigenProblem &held_problem) {
  const modes::Layout layout(body.stiffness.get());
  const Matrix unit =
      unit_displacements(dofs, 6 * static_cast<Index>(body.model.mesh.nodes.size()));
  const modes::Block own = modes::own_rows(layout, free_rows(body.free, unit));
  const Matrix forces =
      node_rows(body.free, modes::gather(layout, modes::multiply(body.best_stiffness(), own)));
  return unit +
         node_rows(held.free, modes::static_solution(held_problem, -free_rows(held.free, forces)));
}

modes::Block normalised(const modes::Layout &layout, Mat mass, const modes::Block &x) {
  const Vector squares = modes::column_products(layout, x, modes::multiply(mass, x));
  return x * squares.cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The best modes that the shapes span, in ascending order. Those of the constraint modes alone go
/// first: rigid motions are among them, which the stiff shapes would otherwise cover with
/// round-off.
modes::Eigenpairs best_modes(const AssembledBody &body, const modes::EigenProblem &problem,
                             const Matrix &constraint, const Matrix &normal) {
  const modes::Layout layout(problem.stiffness);
  const auto own = [&](const Matrix &shapes) {
    return modes::own_rows(layout, free_rows(body.free, shapes));
  };
  const modes::Eigenpairs soft =
      modes::rayleigh_ritz(problem, normalised(layout, problem.mass, own(constraint)));
  modes::Block all(soft.vectors.rows(), constraint.cols() + normal.cols());
  all << soft.vectors, own(normal);
  return modes::rayleigh_ritz(problem, all);
}

} // namespace

Basis fixed_interface_basis(const BodyDefinition &definition, const AssembledBody &body,
                            const modes::EigenProblem &problem, MPI_Comm communicator) {
  const std::vector<InterfaceDof> dofs = interface_dofs(definition, body);
  if (dofs.empty())
    throw DefinitionError("Modes", "", "Attachments",
                          "must name at least one displacement that no support holds, for "
                          "Reduction = fixed interface");
  check_links(dofs, body);
  const AssembledBody held = held_at(dofs, body, communicator);
  const modes::EigenProblem held_problem = problem_of(held);
  const modes::NormalModes modes = solve_modes(held_problem, definition.selection);
  if (modes.eigenvalues[0] == 0)
    throw DefinitionError("Modes", "", "Attachments",
                          "must hold the body against every rigid motion, together with its "
                          "supports, for Reduction = fixed interface");
  const Matrix normal =
      ruled(held, modes.eigenvalues, modes.shapes).middleCols(modes.first, modes.number);
  modes::Eigenpairs pairs =
      best_modes(body, problem, constraint_modes(dofs, body, held, held_problem), normal);
  const Vector noise = modes::rounding_of_quotients(problem, pairs.vectors);
  for (Index j = 0; j < pairs.values.size(); ++j)
    if (pairs.values[j] <=
        std::max(rigid_fraction * modes.eigenvalues[0], modes::rounding_deviations * noise[j]))
      pairs.values[j] = 0;
  const modes::Layout layout(body.stiffness.get());
  Basis basis{.stiffness = merge_multiple(pairs.values),
              .shapes = ruled(body, pairs.values, modes::gather(layout, pairs.vectors)),
              .normal = modes.number};
  basis.orthogonality_residual = modes::orthogonality_residual(problem, pairs.vectors);
  basis.held = basis.stiffness[0] > 0;
  check_loads(definition, body, basis.held);
  const Index rigid = (basis.stiffness.array() == 0).count();
  basis.first_elastic = rigid < basis.stiffness.size() ? basis.stiffness[rigid] : 0;
  basis.error_bounds =
      Vector::Constant(basis.stiffness.size(), std::numeric_limits<double>::quiet_NaN());
  return basis;
}

} // namespace vibroimpact::reduction
