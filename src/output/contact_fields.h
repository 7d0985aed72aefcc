// What contacts do to the nodes of meshes at an instant of a motion, and where their stops are.
#pragma once

#include "common/result_sink.h"
#include "reduction/reduced_body.h"

#include <vector>

namespace vibroimpact::output {

/// A column for each node: three components of the force [N], the gap [m] (0 at nodes without a
/// contact), the largest force up to the instant [N], and the state: 0 without a contact, 1 while
/// no force acts, 2 while one does.
using ContactFields = Eigen::Matrix<float, 6, Eigen::Dynamic>;

/// Whether any contact has a side on a mesh.
bool touches_mesh(const Motion &motion);

/// No columns when no contact touches a mesh. A node of several contacts has the sum of their
/// forces, the smallest of their gaps, the largest of their peaks and of their states.
ContactFields contact_fields(const Motion &motion, std::size_t body, Index nodes,
                             std::size_t instant);

/// The face that a node meets, where the other side of its contact is no mesh. It is given at the
/// place of the undeformed node, with a displacement in which the clearance is included: drawn with
/// any factor of the displacements, node and stop meet where the gap is 0.
struct StopFace {
  Vector3 place;        ///< of the undeformed node [m]
  Vector3 normal;       ///< unit vector from the node to the stop
  Vector3 displacement; ///< [m]
  Eigen::Matrix<float, 6, 1> contact;
};

/// `node_motion`: of each body, 6N, as in the file of its mesh; empty for bodies without one.
std::vector<StopFace> stop_faces(const std::vector<reduction::ReducedBody> &bodies,
                                 const Motion &motion, const std::vector<Vector> &node_motion,
                                 std::size_t instant);

} // namespace vibroimpact::output
