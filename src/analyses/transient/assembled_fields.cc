#include "analyses/transient/assembled_fields.h"

#include "analyses/recorders/observables.h"
#include "common/log.h"
#include "model/whirl.h"

#include <algorithm>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

using model::AssembledModes;
using model::DampedModes;
using model::Model;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr const char *mode_dimension = "system_mode";
constexpr const char *damped_dimension = "damped_mode";
constexpr Index most_damped_modes = 250; // eigenvalues of twice as many states take seconds

std::vector<double> numbers(const Vector &vector) { return {vector.begin(), vector.end()}; }

// Generalised force of an inertia field along an axis, on all bodies: n.
Vector base_participation(const Model &model, int axis) {
  Vector participation(model.size());
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    participation.segment(model.offset(b), model.bodies()[b]->size()) =
        model.bodies()[b]->base_participation.col(axis);
  return participation;
}

double total_mass(const Model &model, int axis) {
  double mass = 0;
  for (const auto &body : model.bodies())
    mass += body->total_mass[axis];
  return mass;
}

void add_participation(const FieldWriter &of, const Model &model, const AssembledModes &modes) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector participation = base_participation(model, axis);
    if (!participation.allFinite() || participation.isZero(0))
      continue;
    const std::string name(1, static_cast<char>('x' + axis));
    const Vector factors = modes.shapes.transpose() * participation;
    of.series("participation_factor_" + name, mode_dimension, numbers(factors), "1",
              "participation of a base motion along " + name + ", modal masses of 1 kg");
    of.series("effective_modal_mass_" + name, mode_dimension, numbers(factors.cwiseAbs2()), "kg",
              "effective modal mass along " + name);
    of.line("effective_modal_mass_share." + name, factors.squaredNorm() / total_mass(model, axis),
            "1");
  }
}

/// Twice the energies of each mode in one body or connection; empty where it has none.
struct Energies {
  Vector strain, kinetic, loss;
};

// Half the square of the frequency and half the modal mass of 1 kg make the whole; the loss is that
// of a cycle, as the damping matrix has it.
void add_shares(const FieldWriter &of, const AssembledModes &modes, const Energies &part) {
  const auto share = [](const Vector &some, const Vector &whole) {
    return numbers((whole.array() > 0).select(some.array() / whole.array(), 0.0));
  };
  if (part.strain.size() > 0)
    of.series("strain_energy_share", mode_dimension, share(part.strain, modes.stiffness), "1",
              "share in the strain energy of each mode");
  if (part.kinetic.size() > 0)
    of.series("kinetic_energy_share", mode_dimension, numbers(part.kinetic), "1",
              "share in the kinetic energy of each mode");
  of.series("loss_share", mode_dimension, share(part.loss, modes.damping.diagonal()), "1",
            "share in the damping of each mode");
}

Energies of_body(const Model &model, std::size_t b, const AssembledModes &modes) {
  const reduction::ReducedBody &body = *model.bodies()[b];
  const auto shapes = modes.shapes.middleRows(model.offset(b), body.size());
  const Matrix squared = shapes.cwiseAbs2();
  return {.strain = squared.transpose() * body.stiffness,
          .kinetic = squared.transpose() * body.mass,
          .loss = shapes.cwiseProduct(body.damping * shapes).colwise().sum().transpose()};
}

Energies of_connection(const model::Connection &connection, const AssembledModes &modes) {
  const Vector squared = (connection.elongation.row * modes.shapes).cwiseAbs2().transpose();
  return {.strain = connection.stiffness * squared,
          .kinetic = {},
          .loss = connection.damping * squared};
}

Energies of_bearing(const model::Bearing &bearing, const AssembledModes &modes) {
  const Matrix motion = bearing.rows() * modes.shapes;
  const auto by = [&](const Eigen::Matrix2d &matrix) -> Vector {
    return motion.cwiseProduct(matrix * motion).colwise().sum().transpose();
  };
  return {.strain = by(bearing.stiffness), .kinetic = {}, .loss = by(bearing.damping)};
}

Energies of_system_damping(const Model &model, const AssembledModes &modes) {
  Energies energies{.strain = {}, .kinetic = {}, .loss = Vector::Zero(modes.shapes.cols())};
  for (const model::ModalDashpot &dashpot : model.modal_dashpots())
    energies.loss +=
        dashpot.damping * (dashpot.coordinate.row * modes.shapes).cwiseAbs2().transpose();
  return energies;
}

void add_shapes(const FieldWriter &of, const Model &model, const AssembledModes &modes) {
  for (const Observable &observed : point_observables(
           model, {.points = {}, .kinds = {"displacement", "rotation", "elongation"}})) {
    const RowVector &row = std::get<motion::PointForm>(observed.form).projection.row;
    of.series(observed.path, mode_dimension, numbers((row * modes.shapes).transpose()),
              observed.unit, "mode shape, modal mass 1 kg: " + observed.description());
  }
}

void add_damped(const FieldWriter &of, const Model &model, const DampedModes &damped) {
  const FieldWriter below = of.below("damped/");
  const Vector size = damped.eigenvalues.cwiseAbs();
  below.series("frequency", damped_dimension, numbers(damped.eigenvalues.imag() / two_pi), "Hz",
               "frequency of the damped vibration; 0: it only decays");
  below.series("decay_rate", damped_dimension, numbers(-damped.eigenvalues.real()), "1/s",
               "rate at which the motion decays");
  below.series(
      "damping_ratio", damped_dimension,
      numbers((size.array() > 0).select(-damped.eigenvalues.real().array() / size.array(), 0.0)),
      "1", "share of the decay rate in the size of the eigenvalue");
  if (!model.spins().empty())
    below.series("whirl", damped_dimension, numbers(whirl_numbers(model, damped.shapes)), "1",
                 "1: forward whirl in circles, -1: backward, 0: to and fro");
  for (const Observable &observed : point_observables(
           model, {.points = {}, .kinds = {"displacement", "rotation", "elongation"}})) {
    const RowVector &row = std::get<motion::PointForm>(observed.form).projection.row;
    const ComplexVector shape = (row.cast<std::complex<double>>() * damped.shapes).transpose();
    below.series(observed.path + "/amplitude", damped_dimension, numbers(shape.cwiseAbs()), "1",
                 "complex mode shape, largest coordinate 1: " + observed.description());
    below.series(observed.path + "/phase", damped_dimension, numbers(shape.array().arg()), "rad",
                 "phase of the complex mode shape: " + observed.description());
  }
}

// The diagonal of the box around all nodes of the largest body; 0 without meshes.
double largest_size(const Model &model) {
  double size = 0;
  for (const auto &body : model.bodies())
    if (const Matrix &nodes = body->recovery.nodes; nodes.cols() > 0)
      size = std::max(size, (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm());
  return size;
}

double largest_displacement(const Model &model, const Vector &shape) {
  double largest = 0;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const reduction::ReducedBody &body = *model.bodies()[b];
    const Vector motion = shape.segment(model.offset(b), body.size());
    const auto look_at = [&](const Matrix &rows) {
      const Vector moved = rows * motion;
      for (Index row = 0; row + 6 <= moved.size(); row += 6)
        largest = std::max(largest, moved.segment<3>(row).norm());
    };
    look_at(body.recovery.shapes);
    for (const reduction::BodyPoint &point : body.points)
      look_at(point.rows);
  }
  return largest;
}

} // namespace

void add_assembled_modes(const FieldWriter &result, const Model &model,
                         const AssembledModes &modes) {
  const FieldWriter of = result.below("system/");
  of.series("frequency", mode_dimension, numbers(modes.angular_frequency() / two_pi), "Hz",
            "undamped natural frequency of the whole system");
  of.series("damping_ratio", mode_dimension, numbers(modes.damping_ratio()), "1",
            "fraction of critical damping, forces between modes left out");
  of.listed().number("rigid_modes", static_cast<double>(modes.rigid), "1",
                     "motions of the whole system that store no energy");
  of.listed().number("modal_damping", modes.modal_damping ? 1 : 0, "1",
                     "1: damping, gyroscopic and circulatory forces couple no modes, 0: they do");
  add_participation(of, model, modes);
  add_shapes(of, model, modes);
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    add_shares(of.below("body/" + model.bodies()[b]->name + "/"), modes, of_body(model, b, modes));
  for (const model::Connection &connection : model.connections())
    add_shares(of.below("connection/" + connection.name + "/"), modes,
               of_connection(connection, modes));
  for (const model::Bearing &bearing : model.bearings())
    add_shares(of.below("bearing/" + bearing.name + "/"), modes, of_bearing(bearing, modes));
  if (!model.modal_dashpots().empty())
    add_shares(of.below("system_damping/"), modes, of_system_damping(model, modes));
  if (modes.modal_damping)
    return;
  if (modes.stiffness.size() > most_damped_modes)
    return log::warning("the damped motions of the whole system are not computed: it has " +
                        std::to_string(modes.stiffness.size()) + " modes, more than " +
                        std::to_string(most_damped_modes));
  add_damped(of, model, damped_modes(modes));
}

Motion motion_of_modes(const Model &model, const AssembledModes &modes) {
  constexpr double shown = 0.1;
  const double size = largest_size(model);
  const Vector frequency = modes.angular_frequency() / two_pi;
  Matrix shapes = modes.shapes;
  for (Index j = 0; j < shapes.cols() && size > 0; ++j)
    if (const double largest = largest_displacement(model, shapes.col(j)); largest > 0)
      shapes.col(j) *= shown * size / largest;
  Motion motion{.time = numbers(frequency), .coordinates = {}, .base_displacement = {}};
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    motion.coordinates.emplace_back(
        shapes.middleRows(model.offset(b), model.bodies()[b]->size()).transpose());
    motion.base_displacement.emplace_back(Matrix::Zero(shapes.cols(), 3));
  }
  return motion;
}

} // namespace vibroimpact::analyses
