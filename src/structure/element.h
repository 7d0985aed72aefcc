// What assembly knows of an element, whatever its kind: its nodes, its matrices and a product with
// little round-off. Bodies hold elements of several kinds that share nodes; each node has the six
// components u, v, w [m] and rx, ry, rz [rad] in global axes.
#pragma once

#include "common/linear_algebra.h"

#include <memory>
#include <span>
#include <vector>

namespace vibroimpact::structure {

/// Rows of an element: 6 i + component of its node i; at most four nodes.
using NodalVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 24, 1>;
using NodalMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 24, 24>;

struct ShellPart;

/// What the element on a cell is made of.
struct CellPart {
  std::span<const int> nodes;         ///< positions in the list of the mesh's nodes
  std::span<const Vector3> positions; ///< of these [m]
  std::span<const Vector3> normals;   ///< of a surface at its corners (surface_normals.h)
  const ShellPart &part;
};

class Element {
public:
  Element() = default;
  Element(const Element &) = delete;
  Element &operator=(const Element &) = delete;
  virtual ~Element() = default;

  /// Positions in the list of the mesh's nodes.
  virtual std::span<const int> nodes() const = 0;
  /// Both symmetric, in global components.
  virtual NodalMatrix stiffness() const = 0;
  virtual NodalMatrix mass() const = 0;
  /// stiffness * u for the matrix that stiffness() returned, such that a large rigid part of a
  /// column of u leaves no round-off behind.
  virtual NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness,
                            const NodalMatrix &u) const = 0;
  /// Plane stress at one of its nodes from its nodal displacements: three rows (two direct stresses
  /// and the shear stress, in axes of their own) for each place looked at [Pa]. None when it is not
  /// known.
  virtual Matrix stress(int node) const = 0;
  /// Places around the cross-section of a beam, from the line of its nodes: 3 x k in global axes
  /// [m]; none of a shell.
  virtual Matrix outline() const { return {}; }
  /// Without lumped masses [kg].
  virtual double total_mass() const = 0;
};

using Elements = std::vector<std::shared_ptr<const Element>>;

} // namespace vibroimpact::structure
