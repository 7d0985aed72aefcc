// What the three- and four-node shell elements have in common: their nodes in space, their mass,
// and products without the round-off of rigid motions.
//
// The mass is consistent with a displacement that knows the rotations: an edge e from node i to
// node j bows by (theta_i - theta_j) x e / 8 in its middle, as a beam with these end rotations
// does. For bending this is the linked interpolation that the assumed shear of the MITC elements
// implies (zienkiewicz1993), for the membrane Allman's (allman1984). It leaves rigid motions alone
// and takes two thirds of the error out of the frequencies of bending that the plain interpolation
// of displacements has.
#pragma once

#include "structure/rigid_part.h"
#include "structure/shell_properties.h"

namespace vibroimpact::structure {

class ShellElement : public Element {
public:
  std::span<const int> nodes() const override { return nodes_; }
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness, const NodalMatrix &u) const override;
  double total_mass() const override { return properties_.mass_per_area * area(); }

  /// Of the mid-surface [m^2].
  virtual double area() const = 0;
  /// Integral of shape function times unit normal over the mid-surface, by node [m^2]: a pressure
  /// of 1 Pa that pushes along the normal. The normal follows the numbering by the right-hand rule.
  virtual std::vector<Vector3> pressure_areas() const = 0;

protected:
  ShellElement(std::vector<int> nodes, std::vector<Vector3> positions,
               const ShellProperties &properties);

  const ShellProperties &properties() const { return properties_; }
  /// From their mean [m].
  const std::vector<Vector3> &positions() const { return rigid_.positions(); }
  /// Stress at the top and the bottom, 6 x 6 nodes, from the membrane strain (e_11, e_22, 2 e_12)
  /// and the curvature (k_11, k_22, 2 k_12).
  Matrix surface_stress(const Eigen::Matrix<double, 3, 24> &strain,
                        const Eigen::Matrix<double, 3, 24> &curvature) const;
  /// Adds the mass of a piece of the mid-surface [m^2] where the shape functions have these values;
  /// `bows` are 1 in the middle of the edge from node i to the next and vanish on the others.
  void add_mass(const Eigen::Vector4d &shapes, const Eigen::Vector4d &bows, double area,
                NodalMatrix &mass) const;

private:
  std::vector<int> nodes_;
  RigidPart rigid_;
  ShellProperties properties_;
};

} // namespace vibroimpact::structure
