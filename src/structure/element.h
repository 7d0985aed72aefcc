// What assembly knows of an element, whatever its kind: its nodes, its matrices and a product with
// little round-off. Bodies hold elements of several kinds that share nodes; a node has the
// components u, v, w [m] and, where one of its elements turns with it, rx, ry, rz [rad], in global
// axes.
#pragma once

#include "common/linear_algebra.h"

#include <memory>
#include <span>
#include <vector>

namespace vibroimpact::structure {

/// Rows of an element: components() * i + component of its node i; at most eight nodes.
using NodalVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 48, 1>;
using NodalMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 48, 48>;

struct MeshPart;

/// What the element on a cell is made of.
struct CellPart {
  std::span<const int> nodes;         ///< positions in the list of the mesh's nodes
  std::span<const Vector3> positions; ///< of these [m]
  std::span<const Vector3> normals;   ///< of a surface at its corners (surface_normals.h)
  const MeshPart &part;
};

class Element {
public:
  Element() = default;
  Element(const Element &) = delete;
  Element &operator=(const Element &) = delete;
  virtual ~Element() = default;

  /// Positions in the list of the mesh's nodes.
  virtual std::span<const int> nodes() const = 0;
  /// Of each of its nodes: 6, or 3 where it does not turn with them.
  virtual int components() const { return 6; }
  /// Both symmetric, in global components.
  virtual NodalMatrix stiffness() const = 0;
  virtual NodalMatrix mass() const = 0;
  /// stiffness * u for the matrix that stiffness() returned, such that a large rigid part of a
  /// column of u leaves no round-off behind.
  virtual NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness,
                            const NodalMatrix &u) const = 0;
  /// Stress at one of its nodes from its nodal displacements: rows of stress_components() for each
  /// place looked at [Pa]. None when it is not known.
  virtual Matrix stress(int node) const = 0;
  /// 3: two direct stresses and the shear stress, plane stress in axes of their own;
  /// 6: xx, yy, zz, xy, yz, zx.
  virtual int stress_components() const { return 3; }
  /// Places around the cross-section of a beam, from the line of its nodes: 3 x k in global axes
  /// [m]; none of a shell.
  virtual Matrix outline() const { return {}; }
  /// Without lumped masses [kg].
  virtual double total_mass() const = 0;
};

using Elements = std::vector<std::shared_ptr<const Element>>;

} // namespace vibroimpact::structure
