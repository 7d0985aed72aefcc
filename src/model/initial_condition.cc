#include "model/initial_condition.h"

#include "common/error.h"
#include "model/direction.h"

namespace vibroimpact::model {

using reduction::BodyPoint;
using reduction::ReducedBody;

namespace {

RowVector point_row(const BodyPoint &point, const MotionAxis &axis) {
  return axis.direction.transpose() * point.rows.middleRows(axis.first_row(), 3);
}

// The multiple of mode `mode` (from 1) that moves the point by one unit along the direction.
Vector unit_mode(const parameters::Values &condition, const ReducedBody &body,
                 const RowVector &row) {
  const long mode = condition.integer("Mode");
  if (mode > body.size())
    condition.reject("Mode", "Mode must be from 1 to " + std::to_string(body.size()) +
                                 ", the number of coordinates of body " + body.name + ".");
  if (std::abs(row[mode - 1]) < 1e-9 * row.cwiseAbs().maxCoeff() || row[mode - 1] == 0)
    condition.reject("At", "At must be a point that mode " + std::to_string(mode) +
                               " moves along the direction.");
  Vector shape = Vector::Zero(body.size());
  shape[mode - 1] = 1 / row[mode - 1];
  return shape;
}

Vector unit_shape(const parameters::Values &condition, const ReducedBody &body,
                  const BodyPoint &point, const MotionAxis &axis) {
  const std::string shape = condition.choice("Shape");
  if (shape == "mode")
    return unit_mode(condition, body, point_row(point, axis));
  try {
    return static_deflection(body, point, axis, 1);
  } catch (const NumericalError &error) {
    condition.reject("Shape", std::string(error.what()) + " Use Shape = mode.");
  }
}

EquilibriumStart equilibrium_of(const parameters::Values &condition) {
  const std::string shape = condition.choice("Shape");
  if (shape == "equilibrium")
    return EquilibriumStart::with_contacts;
  return shape == "free equilibrium" ? EquilibriumStart::without_contacts : EquilibriumStart::none;
}

} // namespace

EquilibriumStart equilibrium_start(const parameters::Values &root,
                                   const std::vector<std::string> &names) {
  EquilibriumStart start = EquilibriumStart::none;
  for (const std::string &name : names) {
    const parameters::Values condition = root.instance("Initial condition", name);
    const EquilibriumStart here = equilibrium_of(condition);
    if (here == EquilibriumStart::none)
      continue;
    if (start != EquilibriumStart::none)
      condition.reject("Shape", "Shape must be an equilibrium in one initial condition only.");
    for (const char *unused :
         {"At", "Direction", "Displacement", "Velocity", "Rotation", "Angular velocity", "Mode"})
      if (condition.given(unused))
        condition.reject(unused, std::string(unused) +
                                     " must not be set when Shape = " + condition.choice("Shape"));
    start = here;
  }
  return start;
}

Vector static_deflection(const ReducedBody &body, const BodyPoint &point, const MotionAxis &axis,
                         double displacement) {
  const RowVector row = point_row(point, axis);
  if ((row.array() != 0).count() == 1)
    return (row.array() != 0).select(displacement / row.array(), 0).matrix().transpose();
  if (!((body.stiffness.array() > 0) || (row.transpose().array() == 0)).all())
    throw NumericalError("Body " + body.name +
                         " is free to move, so it has no static shape under a force.");
  Vector shape = Vector::Zero(body.size());
  for (Index j = 0; j < body.size(); ++j)
    if (body.stiffness[j] > 0)
      shape[j] = row[j] / body.stiffness[j];
  const double flexibility = row * shape;
  if (!(flexibility > 0))
    throw NumericalError("Point " + point.name + " of body " + body.name +
                         " does not move along that direction.");
  return shape * (displacement / flexibility);
}

void declare_initial_conditions(parameters::Section &root) {
  using namespace parameters;
  root.named_subsection("Initial condition", "Displacement and velocity of a body at the start, "
                                             "relative to its base. Several ones add up.")
      .text("At", "", "Point whose displacement and velocity are given, as BODY.POINT.")
      .required("Shape = static or mode")
      .text("Direction", "x",
            "Direction they are counted along: x, -y or three numbers; or rx, -ry and so on for a "
            "rotation about it.")
      .choice("Shape", "static", {"static", "mode", "equilibrium", "free equilibrium"},
              "Shape of the body: under a static point force there, or one of its modes (the mass "
              "of a lumped body is a mode by itself). equilibrium: the whole model at rest under "
              "its constant loads, contacts included; free equilibrium: as if nothing touched.")
      .integer("Mode", "1", Range{.lower = 1}, "j", "Number of the mode, for Shape = mode.")
      .quantity("Displacement", "0 m", dimension::length, range::any, "u_0",
                "Displacement of the point along the direction.")
      .quantity("Velocity", "0 m/s", dimension::velocity, range::any, "v_0",
                "Velocity of the point along the direction.")
      .quantity("Rotation", "0 rad", dimension::angle, range::any, "\\theta_0",
                "Rotation of the point, for a Direction such as rz.")
      .quantity("Angular velocity", "0 rad/s", dimension::frequency, range::any, "\\omega_0",
                "Of the point, for a Direction such as rz.");
}

InitialState read_initial_state(const parameters::Values &root,
                                const std::vector<std::string> &names, const Model &model) {
  InitialState state{.displacement = Vector::Zero(model.size()),
                     .velocity = Vector::Zero(model.size())};
  for (const Rotor &rotor : model.rotors().list()) {
    state.displacement[rotor.angle] = rotor.initial_angle;
    state.velocity[rotor.angle] = rotor.initial_speed;
  }
  for (const std::string &name : names) {
    const parameters::Values condition = root.instance("Initial condition", name);
    if (equilibrium_of(condition) != EquilibriumStart::none)
      continue;
    condition.require("At");
    condition.require_known("At", condition.text("At"), model.point_names());
    PointReference at;
    model.find_point(condition.text("At"), at);
    const ReducedBody &body = *model.bodies()[at.body];
    const MotionAxis axis = read_motion_axis(condition, "Direction");
    check_axis_keys(condition, axis, {"Displacement", "Velocity"},
                    {"Rotation", "Angular velocity"});
    const Vector shape = unit_shape(condition, body, body.points[at.point], axis);
    const Index first = model.offset(at.body);
    state.displacement.segment(first, body.size()) +=
        condition.quantity(axis.rotation ? "Rotation" : "Displacement") * shape;
    state.velocity.segment(first, body.size()) +=
        condition.quantity(axis.rotation ? "Angular velocity" : "Velocity") * shape;
  }
  return state;
}

} // namespace vibroimpact::model
