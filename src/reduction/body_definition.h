// Everything a parameter file says about one body, as plain data in SI units.
#pragma once

#include "modes/normal_modes.h"
#include "reduction/attachment.h"
#include "reduction/modal_definition.h"
#include "structure/matrix_definition.h"
#include "structure/solid_definition.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::reduction {

struct Damping {
  enum class Model {
    ratio,    ///< a fraction of critical damping for each mode
    rayleigh, ///< C = alpha M + beta K
    viscous,  ///< external, spread like the mass of the body: C = (constant / mass) M
    given     ///< a matrix of the body's degrees of freedom
  };
  Model model = Model::ratio;
  std::vector<double> ratios{0.0};          ///< for the kept modes in order; the last one repeats
  std::optional<double> attachment_ratio{}; ///< of attachment modes; the last of the ratios without
  double alpha = 0;                         ///< [1/s]
  double beta = 0;                          ///< [s]
  double viscous_constant = 0;              ///< of the whole body [N s/m]
};

/// A spring and a dashpot to the base.
struct Mount {
  double stiffness = 0; ///< [N/m], of rotations [N m/rad]
  double damping = 0;   ///< [N s/m], of rotations [N m s/rad]
};

/// One mass of a lumped body: moves along its axes and turns about others, held to the base by the
/// same mount along each, and by another one about each.
struct LumpedMass {
  std::string name;
  double mass = 0; ///< [kg]; 0 for one that only turns
  std::vector<int> axes{
      0}; ///< 0, 1, 2 for x, y, z, then rotations about them; a coordinate for each
  Mount mount{};
  Vector3 position = Vector3::Zero(); ///< [m]
  Vector3 inertia = Vector3::Zero();  ///< about axes along x, y, z through its centre [kg m^2]
  Mount rotational_mount{};
  std::optional<double> damping_ratio{}; ///< of each coordinate by itself, instead of dashpots
};

/// A place that a mass of a lumped body carries.
struct LumpedPoint {
  std::string name;
  std::string mass;
  Vector3 arm = Vector3::Zero(); ///< from the centre of the mass [m]
};

/// The rotation of a rotor.
struct RotorDefinition {
  double inertia = 0;  ///< about its centre of mass > 0 [kg m^2]
  double friction = 0; ///< torque per speed >= 0 [N m s/rad]
};

struct BodyDefinition {
  enum class Type { beam, shell, solid, matrices, lumped, rotor, modes };
  enum class Reduction { free_interface, fixed_interface };
  std::string name;
  Type type = Type::beam;
  structure::BeamDefinition beam;
  structure::ShellDefinition shell;
  structure::SolidDefinition solid;
  structure::MatrixDefinition matrices;
  modes::Selection selection; ///< of the modes of the body that is free or held at its attachments
  Reduction reduction = Reduction::free_interface;
  std::vector<Attachment> attachments;
  Damping damping;
  std::vector<LumpedMass> masses;
  std::vector<LumpedPoint> lumped_points;
  std::optional<structure::SpinAxis> lumped_spin{}; ///< of a lumped body, without members
  RotorDefinition rotor;
  ModalDefinition modal;
};

} // namespace vibroimpact::reduction
