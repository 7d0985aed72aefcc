// Nodes that move together like one rigid body, by elimination: their motion is that of the six
// coordinates of one of them, the master, u = T z. Masses, stiffness and forces at them become T^T
// M T, T^T K T and T^T f, exactly; no large stiffness stands in for the rigid body.
#pragma once

#include "structure/body_model.h"

namespace vibroimpact::structure {

/// Rows and columns u, v, w, rx, ry, rz.
using NodeMotion = Eigen::Matrix<double, 6, 6>;

/// Motion of a node at `arm` [m] from another one that is rigidly joined to it: u + theta x arm,
/// theta.
NodeMotion rigid_motion(const Vector3 &arm);

/// A node whose motion is `motion` times the coordinates of the node `master`.
struct LinkedNode {
  int master = 0;
  NodeMotion motion = NodeMotion::Identity();
};

/// The rigid bodies of a model: nodes of one link are one, and so are links that share a node. Its
/// points are there. `members` are positions in the list of names for each line of the mesh, -1 for
/// others. Throws DefinitionError for a link without two nodes.
std::vector<std::vector<int>> rigid_bodies(const BodyModel &model,
                                           const std::vector<RigidLink> &links,
                                           const std::vector<std::string> &member_names,
                                           const std::vector<int> &members);

struct Elimination {
  std::map<int, LinkedNode> nodes; ///< all of rigid bodies, masters too; others are not there
  /// Coordinates that are zero, per node and component: all of linked nodes but masters. Those of
  /// masters that are not zero are displacements and rotations of the master itself.
  std::vector<std::array<bool, 6>> zero;
};

/// What supports hold anywhere on a rigid body holds its coordinates.
Elimination eliminate(const BodyModel &model);

/// All elements in terms of the nodes that are left; those without a linked node are the same.
/// Springs at linked nodes are among them.
Elements eliminated_elements(const BodyModel &model, const Elimination &elimination);

/// Masses at the nodes that are left.
std::map<int, LumpedMass> eliminated_masses(const BodyModel &model, const Elimination &elimination);

} // namespace vibroimpact::structure
