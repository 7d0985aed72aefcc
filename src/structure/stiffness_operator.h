// The stiffness of a frame as a PETSc shell matrix that works element by element, from deformations
// (see stiffness_product). It is the same operator as the assembled matrix, with far less
// round-off: residuals and Rayleigh quotients of low modes of fine meshes need that.
#pragma once

#include "structure/discretisation.h"
#include "structure/frame_model.h"
#include "structure/petsc_object.h"

#include <memory>

namespace vibroimpact::structure {

/// Equation numbers of the degrees of freedom that are not held.
struct FreeDofs {
  std::vector<std::array<int, 6>> number; ///< per node and component; -1 where held
  int size = 0;                           ///< of all ranks
  int own_begin = 0;                      ///< this rank owns own_begin <= number < own_end
  int own_end = 0;
};

class StiffnessOperator {
public:
  /// Collective.
  StiffnessOperator(const FrameModel &model, const FreeDofs &free,
                    const std::vector<int> &own_cells, MPI_Comm communicator);
  StiffnessOperator(const StiffnessOperator &) = delete;
  StiffnessOperator &operator=(const StiffnessOperator &) = delete;

  /// The shell matrix; it may be used as long as this object lives.
  Mat matrix() const { return shell_.get(); }

private:
  struct Element {
    ElementFrame frame;
    std::array<int, 12> local{}; ///< positions in the ghosted vector; -1 where held
  };
  struct Spring {
    int local = 0;
    double stiffness = 0;
  };

  static PetscErrorCode multiply(Mat shell, Vec x, Vec y);
  void apply(Vec x, Vec y);
  int local_number(int dof);
  void add_springs(const FrameModel &model, const FreeDofs &free);

  BeamProperties properties_;
  std::vector<Element> elements_;
  std::vector<Spring> springs_;
  std::map<int, int> local_of_dof_;
  petsc::Vector ghosted_x_;
  petsc::Vector ghosted_y_;
  petsc::Scatter scatter_;
  petsc::Matrix shell_;
};

} // namespace vibroimpact::structure
