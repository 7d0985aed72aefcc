// The straight two-node frame element: axial force, St Venant torsion and Euler-Bernoulli bending
// in two planes. Per node: displacements u, v, w [m] and rotations rx, ry, rz [rad].
//
// Local axes: x from the first node to the second, y and z the principal axes of the section.
// Bending in the x-y plane has slope v' = rz, bending in the x-z plane w' = -ry; the displacement
// is the cubic Hermite interpolant. The mass matrix is the consistent one, without the rotary
// inertia of the cross-section in bending (that is the Euler-Bernoulli assumption).
#pragma once

#include "structure/cross_section.h"
#include "structure/element.h"

#include <Eigen/Dense>

#include <array>

#include <optional>

namespace vibroimpact::structure {

using ElementVector = Eigen::Matrix<double, 12, 1>;
using ElementMatrix = Eigen::Matrix<double, 12, 12>;

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

/// Nodal forces [N, N m] that belong to the nodal displacements u, both in global components. They
/// are worked out from the element's deformations, so that the large rigid part of a displacement
/// cancels before it is multiplied: the round-off of the 4th-order operator stays small.
ElementVector stiffness_product(const BeamProperties &properties, const ElementFrame &frame,
                                const ElementVector &u);

/// Both symmetric, in global components.
ElementMatrix stiffness_matrix(const BeamProperties &properties, const ElementFrame &frame);
ElementMatrix mass_matrix(const BeamProperties &properties, const ElementFrame &frame);

/// The element in a body. Its axis may run beside the line of its nodes: `offset` is the vector
/// from a node to the axis [m], a rigid link, u_axis = u + theta x offset.
class FrameElement : public Element {
public:
  FrameElement(const std::array<int, 2> &nodes, const BeamProperties &properties,
               const ElementFrame &frame, const Vector3 &offset = Vector3::Zero(),
               std::shared_ptr<const SectionPlaces> places = {});

  std::span<const int> nodes() const override { return nodes_; }
  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness, const NodalMatrix &u) const override;
  /// A fibre's direct stress along the beam (first row) and shear stress (third row).
  Matrix stress(int node) const override;
  Matrix outline() const override;
  double total_mass() const override { return properties_.mass_per_length * frame_.length; }

private:
  ElementMatrix link() const;

  std::array<int, 2> nodes_;
  BeamProperties properties_;
  ElementFrame frame_;
  Vector3 offset_;
  std::shared_ptr<const SectionPlaces> places_;
};

} // namespace vibroimpact::structure
