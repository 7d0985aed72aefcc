#include "structure/spin.h"

#include "structure/beam_spin.h"
#include "structure/rigid_links.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

namespace {

constexpr double spin_tolerance = 1e-6; // of directions and inertia, which are typed by hand

[[noreturn]] void refuse_line(const Member &member, const std::string &key,
                              const std::string &problem) {
  if (member.name.empty())
    throw DefinitionError("Spin axis", "", key.empty() ? "Members" : key, problem);
  throw DefinitionError("Member", member.name, "", problem);
}

void check_section(const Member &member, const BeamProperties &p) {
  const double sum = p.bending_stiffness_y + p.bending_stiffness_z;
  if (std::abs(p.bending_stiffness_y - p.bending_stiffness_z) > spin_tolerance * sum)
    refuse_line(member, "",
                "turns about the Spin axis, so that its section must be equally stiff in all "
                "directions, as a circle or tube");
  if (p.mass_per_length > 0 && p.rotary_inertia_y == 0)
    refuse_line(member, "",
                "turns about the Spin axis, so that its Theory must be Rayleigh or Timoshenko: "
                "Euler-Bernoulli leaves out the rotary inertia of sections, which is as large as "
                "their gyroscopic moment");
}

std::vector<std::string> names_of_members(const BeamDefinition &definition) {
  std::vector<std::string> names;
  for (const Member &member : definition.members)
    names.push_back(member.name);
  return names;
}

bool named_or_all(const std::vector<std::string> &names, const std::string &name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

void require_all(const std::vector<std::string> &wanted, const std::vector<std::string> &known,
                 const std::string &key) {
  for (const std::string &name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw DefinitionError("Spin axis", "", key,
                            "must name what the body has, but there is no " + name);
}

/// Both ends: local axes from global ones, and the arm to the member's axis.
ElementMatrix local_motion(const ElementFrame &frame, const Vector3 &offset) {
  ElementMatrix local = ElementMatrix::Zero();
  for (int block = 0; block < 4; ++block)
    local.block<3, 3>(3 * block, 3 * block) = frame.axes;
  for (const int end : {0, 6})
    local.block<3, 3>(end, end + 3) = -frame.axes * cross_matrix(offset);
  return local;
}

/// An element of the body that turns.
struct SpinningLine {
  std::array<int, 2> nodes;
  PropertiesAlong properties;
  ElementFrame frame;
  Vector3 offset;
  Releases releases;
  SpinPlace place;
};

SpinPart part_of_line(const SpinningLine &line, bool rotating) {
  const auto of = rotating ? rotating_beam : beam_spin;
  const BeamSpin spin = of(line.properties, line.frame.length, line.releases, line.place);
  const ElementMatrix local = local_motion(line.frame, line.offset);
  const auto in_nodes = [local](const ElementMatrix &matrix) -> NodalMatrix {
    return local.transpose() * matrix * local;
  };
  SpinPart part{.nodes = {line.nodes[0], line.nodes[1]},
                .gyroscopic = in_nodes(spin.gyroscopic),
                .turning = in_nodes(spin.turning),
                .crosswise = in_nodes(spin.crosswise),
                .stiffness = in_nodes(spin.stiffness)};
  if (!rotating) {
    part.circulatory = in_nodes(spin.circulatory);
    return part;
  }
  part.centrifugal = in_nodes(spin.centrifugal);
  part.load = local.transpose() * spin.load;
  part.stiffening = [line, local, in_nodes](const NodalVector &displacement) {
    return in_nodes(centrifugal_stiffening(line.properties, line.frame.length, line.releases,
                                           line.place, local * displacement));
  };
  return part;
}

void check_shaft(const BodyModel &model, const Member &member, const SpinningLine &line) {
  const Vector3 along = Vector3::UnitX();
  if (along.cross(line.place.axis).norm() > spin_tolerance)
    refuse_line(member, "Direction",
                "must be along the lines that turn, but the one at " +
                    coordinates(model.mesh.nodes[line.nodes[0]]) + " is not");
  for (const double end : {0.0, 1.0})
    check_section(member, line.properties(end));
}

/// Damping that turns has constant coefficients in the fixed frame only where hinges do not turn.
void check_hinges(const Member &member, const SpinningLine &line) {
  for (const std::size_t end : {0U, 6U})
    if (line.releases[end + 1] != line.releases[end + 2] ||
        line.releases[end + 4] != line.releases[end + 5])
      refuse_line(member, "",
                  "turns with Internal damping, so that a Hinge of it must release the motion "
                  "along, or the rotation about, both directions across the axis or none");
}

void add_lines(BodyModel &model, const BeamDefinition &definition, const FrameLines &lines) {
  const SpinAxis &spin = *definition.spin;
  const auto properties = properties_of_lines(model.mesh, definition, lines);
  for (std::size_t i = 0; i < model.mesh.lines.size(); ++i) {
    const Member member = member_at(definition, lines.members[i]);
    if (!named_or_all(spin.members, member.name))
      continue;
    const ElementFrame &frame = lines.frames[i];
    const Vector3 start = model.mesh.nodes[model.mesh.lines[i][0]] - spin.through;
    const SpinningLine line{
        .nodes = model.mesh.lines[i],
        .properties = properties[i],
        .frame = frame,
        .offset = offset_of(member, frame),
        .releases = lines.releases[i],
        .place = {.axis = frame.axes * spin.direction, .start = frame.axes * start}};
    if (spin.rotating_frame && !line.offset.isZero(0))
      refuse_line(member, "", "turns in the rotating frame, so that its Offset must be 0 m, 0 m");
    if (!spin.rotating_frame)
      check_shaft(model, member, line);
    if (!spin.rotating_frame && spin.internal_damping > 0)
      check_hinges(member, line);
    model.spinning.push_back(part_of_line(line, spin.rotating_frame));
  }
}

/// In the rotating frame: a rigid mass whose centre is beside the node by the offset r moves there
/// by u + theta x r + theta x (theta x r) / 2, in the field at its place y.
SpinPart rotating_mass(int node, const Vector3 &place, const Point &point, const SpinAxis &spin) {
  const Eigen::Matrix3d cross = cross_matrix(spin.direction);
  const Eigen::Matrix3d across = -cross * cross;
  const Vector3 arm = place + point.offset - spin.through;
  Point centred = point;
  centred.offset.setZero();
  const Eigen::Matrix3d inertia = lumped_mass(centred).bottomRightCorner<3, 3>();
  const Eigen::Matrix3d moments = inertia.trace() / 2 * Eigen::Matrix3d::Identity() - inertia;
  const TurningPiece piece = turning_piece(moments, spin.direction);
  const NodeMotion centre = rigid_motion(point.offset);
  const auto at_node = [&](const Eigen::Matrix3d &translation,
                           const Eigen::Matrix3d &rotation) -> NodalMatrix {
    NodeMotion both = NodeMotion::Zero();
    both.topLeftCorner<3, 3>() = point.mass * translation;
    both.bottomRightCorner<3, 3>() = rotation;
    return centre.transpose() * both * centre;
  };
  SpinPart part{.nodes = {node},
                .gyroscopic = at_node(2 * cross, piece.gyroscopic),
                .turning = at_node(cross, Eigen::Matrix3d::Zero()),
                .crosswise = at_node(across, Eigen::Matrix3d::Zero()),
                .centrifugal = at_node(-across, piece.centrifugal)};
  const Vector3 pull = point.mass * across * arm;
  const Eigen::Matrix3d turned =
      (point.offset * pull.transpose() + pull * point.offset.transpose()) / 2;
  part.centrifugal.bottomRightCorner(3, 3) -=
      turned - pull.dot(point.offset) * Eigen::Matrix3d::Identity();
  NodalVector load(6);
  load << pull, piece.load;
  part.load = centre.transpose() * load;
  return part;
}

/// Polar and diametral inertia about the centre of a mass that is balanced about the axis through
/// its node.
std::array<double, 2> balanced_inertia(Point point, const Vector3 &axis) {
  if (point.offset.cross(axis).norm() > spin_tolerance * point.offset.norm())
    throw DefinitionError("Point", point.name, "Offset",
                          "must be along the Spin axis about which the point turns; an unbalance "
                          "is an Excitation");
  point.offset.setZero();
  const Eigen::Matrix3d inertia = lumped_mass(point).bottomRightCorner<3, 3>();
  const double polar = axis.dot(inertia * axis);
  const double diametral = (inertia.trace() - polar) / 2;
  const Eigen::Matrix3d round =
      diametral * Eigen::Matrix3d::Identity() + (polar - diametral) * axis * axis.transpose();
  if ((inertia - round).norm() > spin_tolerance * inertia.norm())
    throw DefinitionError("Point", point.name, "Rotary inertia",
                          "must be equal about all directions across the Spin axis about which "
                          "the point turns");
  return {polar, diametral};
}

SpinPart part_of_mass(int node, const Point &point, const Vector3 &axis) {
  const auto [polar, diametral] = balanced_inertia(point, axis);
  const Eigen::Matrix3d cross = cross_matrix(axis);
  const NodeMotion centre = rigid_motion(point.offset);
  const auto at_node = [&](const Eigen::Matrix3d &matrix, double mass,
                           double inertia) -> NodalMatrix {
    NodeMotion both = NodeMotion::Zero();
    both.topLeftCorner<3, 3>() = mass * matrix;
    both.bottomRightCorner<3, 3>() = inertia * matrix;
    return centre.transpose() * both * centre;
  };
  return {.nodes = {node},
          .gyroscopic = at_node(-cross, 0, polar),
          .turning = at_node(cross, point.mass, diametral),
          .crosswise = at_node(-cross * cross, point.mass, diametral)};
}

} // namespace

void add_spin(BodyModel &model, const BeamDefinition &definition, const FrameLines &lines) {
  const SpinAxis &spin = *definition.spin;
  std::vector<std::string> points;
  for (const Point &point : definition.points)
    points.push_back(point.name);
  require_all(spin.members, names_of_members(definition), "Members");
  require_all(spin.points, points, "Points");
  if (spin.rotating_frame && !model.rigid.empty())
    throw DefinitionError(
        "Spin axis", "", "Frame",
        "must be fixed for a body with a Rigid link, whose arms have no centrifugal "
        "forces here");
  add_lines(model, definition, lines);
  for (const Point &point : definition.points) {
    if (!named_or_all(spin.points, point.name))
      continue;
    if (lumped_mass(point).isZero(0))
      continue;
    const auto node =
        std::find_if(model.points.begin(), model.points.end(),
                     [&](const NamedNode &named) { return named.name == point.name; });
    model.spinning.push_back(
        spin.rotating_frame ? rotating_mass(node->node, model.mesh.nodes[node->node], point, spin)
                            : part_of_mass(node->node, point, spin.direction));
  }
}

} // namespace vibroimpact::structure
