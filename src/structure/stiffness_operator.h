// The stiffness of a body as a PETSc shell matrix that works element by element (see
// Element::force). It is the same operator as the assembled matrix, with far less round-off:
// residuals and Rayleigh quotients of low modes of fine meshes need that.
#pragma once

#include "structure/discretisation.h"
#include "structure/petsc_object.h"
#include "structure/rigid_links.h"

#include <memory>

namespace vibroimpact::structure {

/// Equation numbers of the degrees of freedom that are not held.
struct FreeDofs {
  std::vector<std::array<int, 6>> number; ///< per node and component; -1 where held
  int size = 0;                           ///< of all ranks
  int own_begin = 0;                      ///< this rank owns own_begin <= number < own_end
  int own_end = 0;
  std::map<int, LinkedNode> linked{}; ///< nodes of rigid bodies

  /// Of all nodes of an element, one after the other.
  std::vector<int> of(const Element &element) const;

  struct Term {
    int number = 0;
    double factor = 1;
  };
  /// What the displacement or rotation of a node is made of; nothing where it is held.
  std::vector<Term> terms(int node, int component) const;
};

/// Filled with the elements and springs of this rank and then finished.
class StiffnessOperator {
public:
  explicit StiffnessOperator(const FreeDofs &free);
  StiffnessOperator(const StiffnessOperator &) = delete;
  StiffnessOperator &operator=(const StiffnessOperator &) = delete;

  void add(std::shared_ptr<const Element> element, const NodalMatrix &stiffness,
           const std::vector<int> &dofs);
  /// Those whose degrees of freedom this rank owns, out of all; those of linked nodes are elements.
  void add_springs(const std::vector<std::array<double, 6>> &springs);
  /// Collective.
  void finish(MPI_Comm communicator);

  /// The shell matrix; it may be used as long as this object lives.
  Mat matrix() const { return shell_.get(); }

private:
  struct Part {
    std::shared_ptr<const Element> element;
    Index size = 0;              ///< degrees of freedom
    std::size_t local_begin = 0; ///< of its positions in local_
    std::size_t lower_begin = 0; ///< of the lower triangle of its matrix in lower_
  };
  struct Spring {
    int local = 0;
    double stiffness = 0;
  };

  static PetscErrorCode multiply(Mat shell, Vec x, Vec y);
  static PetscErrorCode multiply_columns(Mat shell, Mat x, Mat y, void *unused);
  /// Columns are multiplied together: takes x into one of them, gives one to y.
  void begin(Index columns);
  void take(Vec x, Index column);
  void give(Index column, Vec y);
  void add_products();
  NodalMatrix stiffness_of(const Part &part) const;
  int local_number(int dof);

  FreeDofs free_;
  std::vector<Part> parts_;
  std::vector<int> local_;    ///< positions in the ghosted vector; -1 where held
  std::vector<double> lower_; ///< by columns
  std::vector<Spring> springs_;
  std::vector<int> local_of_dof_; ///< of all degrees of freedom; -1 where there is none
  std::vector<PetscInt> dofs_;    ///< of the local ones
  vibroimpact::Matrix in_, out_;  ///< degrees of freedom of this rank's elements x columns
  petsc::Vector ghosted_;         ///< is laid on a column of them
  petsc::Scatter scatter_;
  petsc::Matrix shell_;
};

} // namespace vibroimpact::structure
