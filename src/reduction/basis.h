// What spans the motion of a reduced body with a mesh: shapes that are M-orthonormal and
// K-orthogonal, so that its equations stay diagonal whichever way they were found.
#pragma once

#include "modes/normal_modes.h"
#include "reduction/body_definition.h"
#include "structure/assembly.h"

namespace vibroimpact::reduction {

struct Basis {
  Vector stiffness{};       ///< n, omega^2 [rad^2/s^2]; exactly 0 for rigid motions
  Matrix shapes{};          ///< rows 6 node + component x n
  Index normal = 0;         ///< the first ones; those behind came in with the Attachments
  bool held = false;        ///< against every rigid motion
  double first_elastic = 0; ///< lowest omega^2 of the body above 0 [rad^2/s^2]; 0 without any
  /// n, see ReducedBody; NaN where nothing bounds it.
  Vector error_bounds{};
  double orthogonality_residual = 0;
};

/// The normal modes of the selection, then the residual attachment modes. Collective. Throws
/// DefinitionError and NumericalError.
Basis free_interface_basis(const BodyDefinition &definition, const structure::AssembledBody &body,
                           const modes::EigenProblem &problem);

/// The normal modes of the body that is held at its Attachments too, and its static shapes for a
/// unit displacement of each of these (craig1968), brought to diagonal form. Collective. Throws
/// DefinitionError and NumericalError.
Basis fixed_interface_basis(const BodyDefinition &definition, const structure::AssembledBody &body,
                            const modes::EigenProblem &problem, MPI_Comm communicator);

/// Throws DefinitionError when there are fewer modes than asked for.
modes::NormalModes solve_modes(const modes::EigenProblem &problem,
                               const modes::Selection &selection);
/// What is factorised for one use of it serves the others too. Collective. Throws DefinitionError
/// for a given mass that is not positive semidefinite.
modes::EigenProblem problem_of(const structure::AssembledBody &body);

/// Throws DefinitionError when a body with loads is not held.
void check_loads(const BodyDefinition &definition, const structure::AssembledBody &body, bool held);

/// Node and component of the forces that the attachments name; without those that are held.
struct InterfaceDof {
  int node = 0;
  int axis = 0;
};
std::vector<InterfaceDof> interface_dofs(const BodyDefinition &definition,
                                         const structure::AssembledBody &body);

/// Rows of free degrees of freedom -> rows 6 node + component, 0 where held.
Matrix node_rows(const structure::FreeDofs &free, const Matrix &shapes);
/// The other way round.
Matrix free_rows(const structure::FreeDofs &free, const Matrix &shapes);

/// Shapes at the free rows as shapes on all nodes, in the basis that the rule of basis_rule.h
/// takes.
Matrix ruled(const structure::AssembledBody &body, const Vector &eigenvalues,
             const Matrix &free_shapes);

} // namespace vibroimpact::reduction
