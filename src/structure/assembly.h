// The matrices of a body, distributed over the ranks of a communicator. Held degrees of
// freedom are eliminated: a unit diagonal in their place would put modes into the spectrum that do
// not exist.
#pragma once

#include "structure/stiffness_operator.h"

namespace vibroimpact::structure {

/// Everything that the eigen-solution and the reduction need; the mesh and the points stay in the
/// model. Rows are the free degrees of freedom.
struct AssembledBody {
  BodyModel model;
  FreeDofs free;
  petsc::Matrix stiffness; ///< elements and springs
  petsc::Matrix mass;      ///< elements and lumped masses; its entries stand where those of K do
  std::unique_ptr<StiffnessOperator> accurate_stiffness; ///< none of given matrices
  /// (M r) at the free rows, for a unit displacement r of the whole body, supports included, along
  /// x, y and z: size x 3 [kg], the same on every rank.
  vibroimpact::Matrix base_inertia;
  vibroimpact::Vector load; ///< of the static solution at the free rows, the same on every rank
  int massive_dofs = 0;     ///< rank of the mass matrix; of a given one its rows with mass
  petsc::Matrix damping{};  ///< of given matrices; none otherwise
  /// That a unit base displacement along each axis moves, supports included [kg].
  Vector3 total_mass = Vector3::Zero();

  /// The one whose products have the least round-off.
  Mat best_stiffness() const {
    return accurate_stiffness ? accurate_stiffness->matrix() : stiffness.get();
  }
};

/// Throws DefinitionError when every degree of freedom is held.
void check_free(const FreeDofs &free);

/// Collective. Throws DefinitionError when every degree of freedom is held.
AssembledBody assemble(BodyModel model, MPI_Comm communicator);

} // namespace vibroimpact::structure
