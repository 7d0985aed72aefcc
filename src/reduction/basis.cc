#include "reduction/basis.h"

#include "modes/attachment_modes.h"
#include "modes/impulse_response.h"
#include "reduction/basis_rule.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::reduction {

using structure::AssembledBody;
using structure::DefinitionError;

Matrix node_rows(const structure::FreeDofs &free, const Matrix &shapes) {
  Matrix rows = Matrix::Zero(6 * static_cast<Index>(free.number.size()), shapes.cols());
  for (std::size_t node = 0; node < free.number.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (const int dof = free.number[node][component]; dof >= 0)
        rows.row(static_cast<Index>(6 * node) + component) = shapes.row(dof);
  const Matrix coordinates = free.linked.empty() ? Matrix() : rows;
  for (const auto &[node, linked] : free.linked)
    rows.middleRows<6>(Index{6} * node) =
        linked.motion * coordinates.middleRows<6>(Index{6} * linked.master);
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

namespace {

// Of 14 digits, as CalculiX writes them: evenly distributed within half a unit of the last one.
constexpr double given_entry_error = 3e-14;

int mass_rank(const AssembledBody &body) {
  if (!body.model.given)
    return body.massive_dofs;
  const modes::MassSigns signs = modes::mass_signs(body.mass.get());
  if (signs.negative > 0)
    throw DefinitionError("Matrices", "", "Mass",
                          "must be positive semidefinite, but has negative eigenvalues: " +
                              std::to_string(signs.negative));
  return body.massive_dofs - signs.zero;
}

} // namespace

modes::EigenProblem problem_of(const AssembledBody &body) {
  return {.stiffness = body.stiffness.get(),
          .mass = body.mass.get(),
          .accurate_stiffness = body.best_stiffness(),
          .mass_rank = mass_rank(body),
          .entry_error = body.accurate_stiffness ? 0 : given_entry_error};
}

modes::NormalModes solve_modes(const modes::EigenProblem &problem,
                               const modes::Selection &selection) {
  try {
    modes::NormalModes modes = modes::normal_modes(problem, selection);
    if (modes.number == 0)
      throw DefinitionError("Modes", "", "Band", "must hold at least one natural frequency");
    return modes;
  } catch (const modes::TooManyModes &too_many) {
    throw DefinitionError("Modes", "", "Number",
                          "must not exceed the number of free degrees of freedom with mass, " +
                              std::to_string(too_many.available));
  }
}

Matrix ruled(const AssembledBody &body, const Vector &eigenvalues, const Matrix &free_shapes) {
  std::vector<int> point_nodes;
  for (const structure::NamedNode &point : body.model.points)
    point_nodes.push_back(point.node);
  Matrix shapes = node_rows(body.free, free_shapes);
  fix_basis(eigenvalues, point_nodes, body.model.mesh.extent(), shapes);
  return shapes;
}

void check_loads(const BodyDefinition &definition, const AssembledBody &body, bool held) {
  if (!held && body.model.loaded)
    throw DefinitionError(
        "Body", definition.name, "Type",
        "must have supports against every rigid motion when there is a subsection Load");
}

std::vector<InterfaceDof> interface_dofs(const BodyDefinition &definition,
                                         const AssembledBody &body) {
  std::vector<InterfaceDof> dofs;
  for (const Attachment &attachment : definition.attachments)
    for (const structure::NamedNode &point : body.model.points)
      if ((point.name == attachment.point || point.interface == attachment.point) &&
          !body.free.terms(point.node, attachment.axis).empty())
        dofs.push_back({point.node, attachment.axis});
  return dofs;
}

namespace {

void add_attachment_modes(const AssembledBody &body, const modes::EigenProblem &problem,
                          const modes::NormalModes &modes, const std::vector<InterfaceDof> &dofs,
                          Basis &basis) {
  if (modes.eigenvalues[modes.eigenvalues.size() - 1] == 0)
    throw DefinitionError("Modes", "", "Number",
                          "must take in an elastic mode of a free body with Attachments");
  Matrix loads = Matrix::Zero(body.free.size, static_cast<Index>(dofs.size()));
  for (std::size_t j = 0; j < dofs.size(); ++j)
    for (const auto &[row, factor] : body.free.terms(dofs[j].node, dofs[j].axis))
      loads(row, static_cast<Index>(j)) = factor;
  const modes::AttachmentModes more = modes::residual_attachment_modes(problem, modes, loads);
  const Index size = modes.number + more.eigenvalues.size();
  basis.stiffness.conservativeResize(size);
  basis.stiffness.tail(more.eigenvalues.size()) = more.eigenvalues;
  basis.shapes.conservativeResize(Eigen::NoChange, size);
  basis.shapes.rightCols(more.eigenvalues.size()) = ruled(body, more.eigenvalues, more.shapes);
}

} // namespace

Basis free_interface_basis(const BodyDefinition &definition, const AssembledBody &body,
                           const modes::EigenProblem &problem) {
  const modes::NormalModes modes = solve_modes(problem, definition.selection);
  const Matrix all = ruled(body, modes.eigenvalues, modes.shapes);
  Basis basis{.stiffness = merge_multiple(modes.eigenvalues).segment(modes.first, modes.number),
              .shapes = all.middleCols(modes.first, modes.number),
              .normal = modes.number,
              .held = modes.eigenvalues[0] > 0,
              .orthogonality_residual = modes.orthogonality_residual};
  check_loads(definition, body, basis.held);
  const auto elastic = std::find_if(modes.eigenvalues.begin(), modes.eigenvalues.end(),
                                    [](double value) { return value > 0; });
  basis.first_elastic = elastic == modes.eigenvalues.end() ? 0 : *elastic;
  if (const auto dofs = interface_dofs(definition, body); !dofs.empty())
    add_attachment_modes(body, problem, modes, dofs, basis);
  // Attachment modes are no eigenvectors: nothing bounds their error as such.
  basis.error_bounds =
      Vector::Constant(basis.stiffness.size(), std::numeric_limits<double>::quiet_NaN());
  basis.error_bounds.head(modes.number) = modes.error_bounds.segment(modes.first, modes.number);
  return basis;
}

} // namespace vibroimpact::reduction
