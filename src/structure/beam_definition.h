// What a beam body is made of, as plain data in SI units: a line or a mesh file, members with their
// cross-sections and materials, hinges, supports and named points.
#pragma once

#include "common/error.h"
#include "common/linear_algebra.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::structure {

/// The user's definition cannot be built. It says which key is wrong, so that whoever read the
/// definition from a file can add where the key stands.
class DefinitionError : public InputError {
public:
  /// `kind` and `name` tell the subsection ("Support", "root"); a fixed subsection has no name.
  /// `problem` is a sentence part that follows the key: "must ...".
  DefinitionError(std::string kind, std::string name, std::string key, std::string problem);

  const std::string &kind() const { return kind_; }
  const std::string &name() const { return name_; }
  const std::string &key() const { return key_; }
  const std::string &problem() const { return problem_; }

private:
  std::string kind_;
  std::string name_;
  std::string key_;
  std::string problem_;
};

/// A straight line from `start` to `end` [m], of equal elements as far as the places allow.
struct Line {
  Vector3 start = Vector3::Zero();
  Vector3 end = Vector3::Zero();
  int elements = 40;            ///< none is longer than the length / elements
  std::vector<double> places{}; ///< where nodes must be, from the start [m]
};

/// Euler-Bernoulli: cross-sections stay normal to the axis, and only their polar inertia counts.
/// Rayleigh: they stay normal and have rotary inertia in bending. Timoshenko: they are sheared
/// besides.
enum class BeamTheory { euler_bernoulli, rayleigh, timoshenko };

/// Dimensions of the cross-section [m]; those that its shape does not use stay 0.
struct SectionShape {
  enum class Kind { rectangle, circle, tube, given };
  Kind kind = Kind::rectangle;
  double width = 0;     ///< along the local y axis
  double thickness = 0; ///< along the local z axis
  double diameter = 0;  ///< outer
  double wall_thickness = 0;
  double area = 0;             ///< [m^2], given shape
  double second_moment_y = 0;  ///< integral of z^2 [m^4], given shape
  double second_moment_z = 0;  ///< integral of y^2 [m^4], given shape
  double torsion_constant = 0; ///< [m^4], given shape
  BeamTheory theory = BeamTheory::euler_bernoulli;
  /// Timoshenko's factors of the area for forces along local y and z; 0: Cowper's for the shape.
  std::array<double, 2> shear_correction{};
  /// Dimensions at the end of a tapered beam; 0: as at its start. They change linearly.
  double end_width = 0;
  double end_thickness = 0;
  double end_diameter = 0;
  double end_wall_thickness = 0;
};

struct Material {
  double young_modulus = 0; ///< [Pa]
  double poisson_ratio = 0;
  double density = 0; ///< [kg/m^3]
};

/// Where a support or a point is: at the nodes of a group ("start" and "end" of a generated line,
/// the physical groups of a mesh file, "all"), at the node with these coordinates, at the node
/// nearest to them, or at the node with a number.
struct Location {
  std::string group;
  std::optional<Vector3> position; ///< [m]
  bool nearest = false;            ///< the position need not be that of a node
  std::optional<int> number{};     ///< or: of the node in its file
};

/// Degrees of freedom held, and springs to the base. Components: x, y, z, rx, ry, rz.
struct Support {
  std::string name;
  Location at;
  std::array<bool, 6> fixed{};
  std::array<double, 6> stiffness{}; ///< [N/m] and [N m/rad]
  bool names_rotations = false;      ///< rotations are held by their own names, not with all
};

/// A named node, with or without a lumped mass that is fixed to it, by a rigid arm if need be.
struct Point {
  std::string name;
  Location at;
  double mass = 0;                               ///< [kg]
  Vector3 rotary_inertia = Vector3::Zero();      ///< about global axes through its centre [kg m^2]
  Vector3 products_of_inertia = Vector3::Zero(); ///< integrals of x y, y z, z x [kg m^2]
  Vector3 offset = Vector3::Zero();              ///< of the centre of mass from the node [m]
};

/// Before any motion, tension positive [N]; it changes linearly along the member.
struct AxialForce {
  double start = 0, end = 0;

  AxialForce() = default;
  AxialForce(double uniform) : start(uniform), end(uniform) {}
  AxialForce(double at_start, double at_end) : start(at_start), end(at_end) {}
  bool any() const { return start != 0 || end != 0; }
  bool changes() const { return start != end; }
};

/// Beams along some lines of a body.
struct Member {
  std::string name;
  std::string on = "all"; ///< group of lines
  std::optional<std::array<double, 2>>
      between{}; ///< part of the generated line, from its start [m]
  SectionShape section{};
  Material material{};
  std::optional<Vector3> local_y{};
  std::array<double, 2> offset{}; ///< of the axis from the nodes along local y and z [m]
  AxialForce axial_force{};
};

/// What of a body turns at a given speed, how its motion is described, and what it loses in itself.
struct SpinAxis {
  Vector3 direction = Vector3::UnitX(); ///< unit vector
  std::vector<std::string> members{};   ///< whose lines turn; empty: all lines
  std::vector<std::string> points{};    ///< whose lumped masses turn; empty: all
  bool rotating_frame = false;          ///< the displacements turn with the body
  Vector3 through = Vector3::Zero();    ///< a place of the axis [m]; counts in the rotating frame
  double internal_damping = 0;          ///< stress of a strain rate, over that of a strain [s]
};

/// Where the ends of a member do not follow the nodes: released displacements and rotations, along
/// and about the local axes of each of its elements that ends there.
struct Hinge {
  std::string name;
  std::string member;
  Location at;
  std::array<bool, 6> free{};
};

/// Nodes that move together like one rigid body: those of groups and of named points, and those of
/// members, each connected part of a member by itself.
struct RigidLink {
  std::string name;
  std::vector<std::string> groups{};
  std::vector<std::string> points{};
  std::vector<std::string> members{};
};

/// Nodes at which a body can touch others, one contact each. Their points are called NAME.1,
/// NAME.2...
struct Interface {
  std::string name;
  std::string group = "all";     ///< the nodes to choose from
  std::vector<Vector3> near;     ///< the nodes nearest to these, in this order [m]; empty: all
  std::string near_key = "Near"; ///< the key these positions come from, for messages
};

/// What acts on a body in its static solution. Force and moment act at each node of the location.
struct Load {
  std::string name;
  Location at;                            ///< empty without force and moment
  Vector3 force = Vector3::Zero();        ///< [N]
  Vector3 moment = Vector3::Zero();       ///< [N m]
  Vector3 acceleration = Vector3::Zero(); ///< of gravity, on all mass [m/s^2]
  double pressure = 0;    ///< along the normals of shells, against faces of solids [Pa]
  std::string on = "all"; ///< surfaces under pressure
};

struct BeamDefinition {
  std::string mesh_content;       ///< text of a Gmsh mesh file; empty: the generated line
  Line line;                      ///< used without a mesh
  std::optional<Vector3> local_y; ///< direction of the section's local y axis; need not be normal
  SectionShape section;
  Material material;
  std::vector<Member> members{}; ///< lines that belong to none have the section above
  std::vector<Hinge> hinges{};
  std::optional<int> plane_normal{}; ///< axis along which nothing moves
  std::vector<Support> supports;
  std::vector<Point> points;
  std::vector<RigidLink> links{};
  std::vector<Interface> interfaces{};
  std::vector<Load> loads{};
  std::optional<SpinAxis> spin{};
};

} // namespace vibroimpact::structure
