#include "reduction/spin_projection.h"

#include "modes/static_solution.h"

namespace vibroimpact::reduction {

namespace {

using structure::AssembledBody;
using structure::SpinPart;

/// Of all nodes of a part, from rows 6 node + component.
Matrix rows_of_part(const SpinPart &part, const Matrix &rows) {
  Matrix own(6 * static_cast<Index>(part.nodes.size()), rows.cols());
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    own.middleRows(6 * static_cast<Index>(i), 6) = rows.middleRows(Index{6} * part.nodes[i], 6);
  return own;
}

/// Displacement under the centrifugal forces at unit speed, rows 6 node + component.
Matrix centrifugal_displacement(const AssembledBody &body, const modes::EigenProblem &problem) {
  Matrix load = Matrix::Zero(body.free.size, 1);
  for (const SpinPart &part : body.model.spinning)
    for (std::size_t i = 0; i < part.nodes.size(); ++i)
      for (int component = 0; component < 6; ++component)
        for (const auto &[dof, factor] : body.free.terms(part.nodes[i], component))
          load(dof, 0) += factor * part.load[6 * static_cast<Index>(i) + component];
  return node_rows(body.free, modes::static_solution(problem, load));
}

void add_rotating_frame(const AssembledBody &body, const modes::EigenProblem &problem,
                        const Basis &basis, SpinMatrices &spin) {
  if (!basis.held)
    throw structure::DefinitionError("Spin axis", "", "Frame",
                                     "must be fixed for a body that no support holds against "
                                     "every rigid motion");
  const Index n = basis.shapes.cols();
  spin.centrifugal = Matrix::Zero(n, n);
  spin.centrifugal_load = Vector::Zero(n);
  const Matrix displacement = centrifugal_displacement(body, problem);
  for (const SpinPart &part : body.model.spinning) {
    const Matrix rows = rows_of_part(part, basis.shapes);
    structure::NodalMatrix stiffness = part.centrifugal;
    if (part.stiffening)
      stiffness += part.stiffening(rows_of_part(part, displacement));
    spin.centrifugal += rows.transpose() * stiffness * rows;
    spin.centrifugal_load += rows.transpose() * part.load;
  }
  spin.centrifugal = (spin.centrifugal + spin.centrifugal.transpose()).eval() / 2;
}

/// Of the parts that have such a matrix.
Matrix projected_parts(const AssembledBody &body, const Basis &basis,
                       structure::NodalMatrix SpinPart::*matrix) {
  Matrix sum = Matrix::Zero(basis.shapes.cols(), basis.shapes.cols());
  for (const SpinPart &part : body.model.spinning)
    if ((part.*matrix).size() > 0) {
      const Matrix rows = rows_of_part(part, basis.shapes);
      sum += rows.transpose() * (part.*matrix) * rows;
    }
  return sum;
}

} // namespace

Matrix internal_damping(const AssembledBody &body, const Basis &basis,
                        const structure::SpinAxis &axis) {
  const Matrix damping = axis.internal_damping * projected_parts(body, basis, &SpinPart::stiffness);
  return (damping + damping.transpose()) / 2;
}

SpinMatrices spin_matrices(const AssembledBody &body, const modes::EigenProblem &problem,
                           const Basis &basis, const structure::SpinAxis &axis) {
  const Index n = basis.shapes.cols();
  SpinMatrices spin{.axis = axis.direction,
                    .rotating_frame = axis.rotating_frame,
                    .gyroscopic = Matrix::Zero(n, n),
                    .centrifugal = {},
                    .centrifugal_load = {},
                    .turning = Matrix::Zero(n, n),
                    .crosswise = Matrix::Zero(n, n)};
  for (const SpinPart &part : body.model.spinning) {
    const Matrix rows = rows_of_part(part, basis.shapes);
    spin.gyroscopic += rows.transpose() * part.gyroscopic * rows;
    spin.turning += rows.transpose() * part.turning * rows;
    spin.crosswise += rows.transpose() * part.crosswise * rows;
  }
  spin.gyroscopic = (spin.gyroscopic - spin.gyroscopic.transpose()).eval() / 2;
  spin.turning = (spin.turning - spin.turning.transpose()).eval() / 2;
  spin.crosswise = (spin.crosswise + spin.crosswise.transpose()).eval() / 2;
  if (axis.rotating_frame) {
    add_rotating_frame(body, problem, basis, spin);
  } else if (axis.internal_damping > 0) {
    const Matrix all = axis.internal_damping * projected_parts(body, basis, &SpinPart::circulatory);
    spin.circulatory = (all - all.transpose()) / 2;
  }
  return spin;
}

} // namespace vibroimpact::reduction
