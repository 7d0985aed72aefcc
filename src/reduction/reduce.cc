#include "reduction/reduce.h"

#include "common/decompositions.h"
#include "common/log.h"
#include "common/stages.h"
#include "reduction/basis.h"
#include "reduction/body_file.h"
#include "reduction/element_stress.h"
#include "reduction/lumped_body.h"
#include "reduction/modal_body.h"
#include "reduction/point_response.h"
#include "reduction/rotor_body.h"
#include "reduction/spin_projection.h"
#include "reduction/stability.h"
#include "structure/matrix_body.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vibroimpact::reduction {

namespace {

using structure::AssembledBody;
using structure::DefinitionError;

/// Nodes without rotations, those of solids, get that of the lines at them, for the pictures: beams
/// are drawn with the slope that rotations give them. Per unit length t x du along the line.
void turn_with_lines(const structure::Mesh &mesh, Matrix &shapes) {
  std::vector<std::vector<std::size_t>> lines(mesh.nodes.size());
  for (std::size_t line = 0; line < mesh.lines.size(); ++line)
    for (const int node : mesh.lines[line])
      lines[static_cast<std::size_t>(node)].push_back(line);
  for (std::size_t node = 0; node < lines.size(); ++node) {
    const auto row = static_cast<Index>(6 * node);
    auto rotation = shapes.middleRows(row + 3, 3);
    if (!rotation.isZero(0) || shapes.middleRows(row, 3).isZero(0)) // it turns, or it is held
      continue;
    for (const std::size_t line : lines[node]) {
      const auto [a, b] = mesh.lines[line];
      const Vector3 along = mesh.nodes[b] - mesh.nodes[a];
      const Matrix change = shapes.middleRows(Index{6} * b, 3) - shapes.middleRows(Index{6} * a, 3);
      for (Index j = 0; j < shapes.cols(); ++j)
        rotation.col(j) += along.cross(Vector3(change.col(j))) / along.squaredNorm() /
                           static_cast<double>(lines[node].size());
    }
  }
}

/// `shapes` and `deflection` have rows for internal nodes too, which nothing shows.
Recovery recovery(const structure::BodyModel &model, Matrix shapes, const Vector &deflection) {
  const structure::Mesh &mesh = model.mesh;
  const auto count = static_cast<Index>(mesh.places().size());
  Recovery result;
  if (mesh.lines.empty() && mesh.cells.empty())
    return result;
  if (model.given)
    turn_with_lines(mesh, shapes);
  result.nodes.resize(3, count);
  for (Index node = 0; node < count; ++node)
    result.nodes.col(node) = mesh.nodes[static_cast<std::size_t>(node)];
  result.lines = mesh.lines;
  result.cells = mesh.cells;
  shapes.conservativeResize(6 * count, Eigen::NoChange);
  result.shapes = std::move(shapes);
  if (deflection.size() > 0)
    result.static_displacement = deflection.head(6 * count);
  return result;
}

// Anything people build sounds between these; a body outside them mostly has a mesh in millimetres.
constexpr double lowest_plausible = 1e-2;  // [Hz]
constexpr double highest_plausible = 1e+6; // [Hz]

void warn_of_implausible(const std::string &name, const AssembledBody &body, double first_elastic) {
  constexpr double two_pi = 6.283185307179586476925;
  if (body.model.mesh.unused_nodes > 0)
    log::warning("body " + name + ": " + std::to_string(body.model.mesh.unused_nodes) +
                 " nodes of the mesh belong to no cell and are left out");
  if (body.model.locking)
    log::warning("body " + name + ": " + locking_sentence(*body.model.locking));
  if (first_elastic == 0)
    return;
  const double frequency = std::sqrt(first_elastic) / two_pi;
  if (frequency >= lowest_plausible && frequency <= highest_plausible)
    return;
  std::ostringstream text;
  text << "body " << name << ": its first natural frequency, " << frequency
       << " Hz, is hardly that of a structure. Are the units right? Its mesh is "
       << body.model.mesh.extent() << " m across ("
       << (body.model.given ? "in the Unit system of its matrices"
                            : "coordinates in a mesh file are metres")
       << ")";
  if (body.model.wave_speed > 0)
    text << ", waves run through it at " << body.model.wave_speed << " m/s";
  text << ", and its mass is " << body.total_mass.maxCoeff() << " kg";
  log::warning(text.str());
}

Matrix diagonal(const Vector &entries) { return entries.asDiagonal(); }

/// Shapes^T M shapes for the masses at nodes alone; the rows of the shapes are 6 node + component.
Matrix project_lumped_masses(const structure::BodyModel &model, const Matrix &shapes) {
  Matrix projected = Matrix::Zero(shapes.cols(), shapes.cols());
  for (const auto &[node, mass] : model.lumped_masses) {
    const auto rows = shapes.middleRows(Index{6} * node, 6);
    projected += rows.transpose() * mass * rows;
  }
  return projected;
}

/// C = (c / m) times the mass matrix of the elements, lumped masses left out.
Matrix viscous_damping(const Damping &damping, const AssembledBody &body, const Matrix &shapes) {
  const double mass = body.model.distributed_mass();
  if (!(mass > 0))
    throw DefinitionError("Modes", "", "Damping model", "must not be viscous when Density = 0");
  const Matrix projected = modes::project(body.mass.get(), free_rows(body.free, shapes)) -
                           project_lumped_masses(body.model, shapes);
  return damping.viscous_constant / mass * (projected + projected.transpose()) / 2;
}

/// Shapes^T C shapes. Throws DefinitionError where C would feed energy to the shapes.
Matrix given_damping(const AssembledBody &body, const Matrix &shapes) {
  const Matrix projected = modes::project(body.damping.get(), free_rows(body.free, shapes));
  const Matrix damping = (projected + projected.transpose()) / 2;
  const Vector values = symmetric_eigen(damping).values;
  if (values[0] < -1e-9 * values.cwiseAbs().maxCoeff())
    throw DefinitionError("Matrices", "", "Damping",
                          "must be positive semidefinite, but feeds energy to the kept modes");
  return damping;
}

/// Those behind the first `normal` shapes have the damping of the attachments.
Matrix modal_damping(const Damping &damping, const AssembledBody &body, const Vector &stiffness,
                     const Matrix &shapes, Index normal) {
  if (damping.model == Damping::Model::viscous)
    return viscous_damping(damping, body, shapes);
  if (damping.model == Damping::Model::given)
    return given_damping(body, shapes);
  if (damping.model == Damping::Model::rayleigh)
    return diagonal((damping.alpha + damping.beta * stiffness.array()).matrix());
  Vector ratio(stiffness.size());
  for (Index j = 0; j < ratio.size(); ++j)
    ratio[j] = damping.ratios[std::min<std::size_t>(j, damping.ratios.size() - 1)];
  ratio.tail(ratio.size() - normal)
      .setConstant(damping.attachment_ratio.value_or(damping.ratios.back()));
  return diagonal((2 * ratio.array() * stiffness.array().max(0.0).sqrt()).matrix());
}

void add_points(const structure::BodyModel &model, const Matrix &shapes,
                const PointResponse &response, ReducedBody &body) {
  const bool shown = !model.mesh.lines.empty() || !model.mesh.cells.empty();
  for (std::size_t p = 0; p < model.points.size(); ++p) {
    const structure::NamedNode &named = model.points[p];
    const Index row = Index{6} * named.node;
    BodyPoint point{.name = named.name,
                    .position = model.mesh.nodes[named.node],
                    .rows = shapes.middleRows(row, 6),
                    .interface = named.interface,
                    .node = shown ? named.node : -1};
    CellStress stress = stress_at_node(model, named.node, shapes);
    point.stress = std::move(stress.rows);
    point.stress_components = stress.components;
    if (response.deflection.size() > 0)
      point.static_displacement = response.deflection.segment(row, 6);
    if (!response.flexibility.empty())
      point.flexibility = response.flexibility[p];
    point.inverse_mass = response.inverse_mass[p];
    body.points.push_back(std::move(point));
  }
}

// A body of so many degrees of freedom takes seconds.
constexpr int large_body = 20000;

bool first_rank(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank == 0;
}

const char *type_name(BodyDefinition::Type type) {
  if (type == BodyDefinition::Type::matrices)
    return "matrices";
  if (type == BodyDefinition::Type::solid)
    return "solid";
  return type == BodyDefinition::Type::shell ? "shell" : "beam";
}

ReducedBody meshed_body(const BodyDefinition &definition, MPI_Comm communicator) {
  // A body that a rank reduces by itself, in the midst of an analysis, is nobody's concern.
  Stages stages("body " + definition.name,
                communicator != MPI_COMM_SELF && first_rank(communicator));
  stages.begin("mesh and matrices", false);
  const AssembledBody assembled =
      structure::assemble(build_model(definition, communicator), communicator);
  const bool large = assembled.free.size >= large_body;
  stages.begin("modes of " + std::to_string(assembled.free.size) + " degrees of freedom", large);
  const modes::EigenProblem problem = problem_of(assembled);
  check_stability(assembled, problem);
  Basis basis = definition.reduction == BodyDefinition::Reduction::fixed_interface
                    ? fixed_interface_basis(definition, assembled, problem, communicator)
                    : free_interface_basis(definition, assembled, problem);
  warn_of_implausible(definition.name, assembled, basis.first_elastic);
  stages.begin("static solutions", large);
  SpinMatrices spin;
  if (!assembled.model.spinning.empty())
    spin = spin_matrices(assembled, problem, basis, *definition.beam.spin);
  const PointResponse response = point_response(assembled, problem, basis.held);

  ReducedBody body;
  body.name = definition.name;
  body.type = type_name(definition.type);
  body.mass = Vector::Ones(basis.stiffness.size());
  body.stiffness = basis.stiffness;
  body.damping =
      modal_damping(definition.damping, assembled, body.stiffness, basis.shapes, basis.normal);
  if (!spin.empty() && definition.beam.spin->internal_damping > 0)
    body.damping += internal_damping(assembled, basis, *definition.beam.spin);
  body.base_participation =
      free_rows(assembled.free, basis.shapes).transpose() * assembled.base_inertia;
  add_points(assembled.model, basis.shapes, response, body);
  body.spin = std::move(spin);
  body.recovery = recovery(assembled.model, std::move(basis.shapes), response.deflection);
  if (!body.recovery.empty()) {
    body.recovery.line_stress = line_stress(assembled.model, body.recovery.shapes);
    body.recovery.cell_stress = cell_stress(assembled.model, body.recovery.shapes);
  }
  body.total_mass = assembled.total_mass;
  body.eigen_residual = std::move(basis.error_bounds);
  body.orthogonality_residual = basis.orthogonality_residual;
  return body;
}

} // namespace

structure::BodyModel build_model(const BodyDefinition &definition, MPI_Comm communicator) {
  if (definition.type == BodyDefinition::Type::matrices)
    return structure::build_matrix_body(definition.matrices, communicator);
  if (definition.type == BodyDefinition::Type::solid)
    return structure::build_solid(definition.solid);
  return definition.type == BodyDefinition::Type::shell ? structure::build_shell(definition.shell)
                                                        : structure::build_frame(definition.beam);
}

ReducedBody reduce(const BodyDefinition &definition, MPI_Comm communicator) {
  if (definition.type == BodyDefinition::Type::lumped)
    return lumped_body(definition);
  if (definition.type == BodyDefinition::Type::rotor)
    return rotor_body(definition);
  if (definition.type == BodyDefinition::Type::modes)
    return modal_body_from_file(definition.name, definition.modal);
  return broadcast(meshed_body(definition, communicator), communicator);
}

} // namespace vibroimpact::reduction
