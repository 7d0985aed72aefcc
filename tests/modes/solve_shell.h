// Modes and static displacements of a shell definition.
#pragma once

#include "modes/solve_beam.h"
#include "modes/static_solution.h"
#include "structure/shell_examples.h"

namespace vibroimpact::examples {

inline structure::AssembledBody assembled(const ShellDefinition &shell,
                                          MPI_Comm communicator = MPI_COMM_WORLD) {
  return structure::assemble(structure::build_shell(shell), communicator);
}

inline modes::NormalModes solve_shell(const ShellDefinition &shell, int number,
                                      MPI_Comm communicator = MPI_COMM_WORLD) {
  const structure::AssembledBody body = assembled(shell, communicator);
  return modes::normal_modes(eigen_problem(body), {number, {}});
}

/// [Hz]
inline Vector frequencies(const ShellDefinition &shell, int number,
                          MPI_Comm communicator = MPI_COMM_WORLD) {
  return solve_shell(shell, number, communicator).eigenvalues.array().sqrt() / (2 * M_PI);
}

/// Six components at the first point of the definition, under its loads.
inline Vector static_at_point(const ShellDefinition &shell,
                              MPI_Comm communicator = MPI_COMM_WORLD) {
  const structure::AssembledBody body = assembled(shell, communicator);
  const Matrix solution = modes::static_solution(eigen_problem(body), body.load);
  Vector moved = Vector::Zero(6);
  for (int component = 0; component < 6; ++component)
    if (const int dof = body.free.number[body.model.points[0].node][component]; dof >= 0)
      moved[component] = solution(dof, 0);
  return moved;
}

} // namespace vibroimpact::examples
