// The straight two-node frame element: axial force, St Venant torsion and bending in two planes,
// after Euler-Bernoulli or Timoshenko. Per node: displacements u, v, w [m] and rotations rx, ry, rz
// [rad].
//
// Local axes: x from the first node to the second, y and z the principal axes of the section.
// Bending in the x-y plane has the slope v' = rz, bending in the x-z plane w' = -ry, both with the
// shear angle besides in Timoshenko's theory. The deflection is the one under forces at the ends
// (see beam_matrices); the mass matrix is consistent with it.
#pragma once

#include "structure/beam_matrices.h"
#include "structure/element.h"

#include <array>
#include <optional>

namespace vibroimpact::structure {

/// Length [m] and local axes of one element, the rows of `axes` in global components.
struct ElementFrame {
  double length = 0;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// `local_y` is projected onto the plane normal to the element. Without it the global y axis is
/// used, or the global z axis for an element along y. Throws DefinitionError when it is parallel to
/// the element.
ElementFrame element_frame(const Vector3 &first, const Vector3 &second,
                           const std::optional<Vector3> &local_y);

/// Of the cross-section at the first and at the second end.
using EndPlaces = std::array<std::shared_ptr<const SectionPlaces>, 2>;

/// The element in a body. Its axis may run beside the line of its nodes: `offset` is the vector
/// from a node to the axis [m], a rigid link, u_axis = u + theta x offset.
class FrameElement : public Element {
public:
  /// Throws like beam_matrices().
  FrameElement(const std::array<int, 2> &nodes, const PropertiesAlong &properties,
               const ElementFrame &frame, const Vector3 &offset = Vector3::Zero(),
               EndPlaces places = {}, const Releases &releases = {});

  std::span<const int> nodes() const override { return nodes_; }
  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  /// The forces are worked out from the element's deformations, so that the large rigid part of a
  /// displacement cancels before it is multiplied: the round-off of the 4th-order operator stays
  /// small.
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness, const NodalMatrix &u) const override;
  /// A fibre's direct stress along the beam (first row) and shear stress (third row).
  Matrix stress(int node) const override;
  Matrix outline() const override;
  double total_mass() const override;

private:
  /// Motion of the ends of the axis in local axes from that of the nodes.
  ElementMatrix to_local() const;
  ElementMatrix local_stiffness() const;
  /// Of the motion `u` of the nodes in global components.
  ElementVector local_force(const ElementVector &u) const;
  ElementMatrix in_nodes(const ElementMatrix &local) const;

  std::array<int, 2> nodes_;
  ElementFrame frame_;
  Vector3 offset_;
  EndPlaces places_;
  BeamMatrices matrices_;
  bool prestressed_;
};

} // namespace vibroimpact::structure
