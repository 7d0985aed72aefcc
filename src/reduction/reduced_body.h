// A body after the Galerkin reduction: plain dense data, no finite element left.
//
//   diag(mass) q'' + damping q' + diag(stiffness) q = f(t) + sum over points row(point, axis)^T
//   force
//
// Displacement of a point along an axis, relative to the base the body stands on: row . q. A base
// acceleration a (3 components) acts as the generalised force -base_participation a.
// Modal bodies have mass = 1 and stiffness = omega^2; lumped bodies have a coordinate for each
// mass and axis, a rotor has its angle.
#pragma once

#include "common/linear_algebra.h"
#include "structure/cell.h"

#include <array>
#include <string>
#include <vector>

namespace vibroimpact::reduction {

/// Square of the von Mises stress at a place [Pa^2] from its components: two direct stresses and
/// the shear stress of plane stress, or the six xx, yy, zz, xy, yz, zx.
double squared_von_mises(const double *stress, Index components);

/// A named place of a body where something can connect, touch, push or be looked at.
struct BodyPoint {
  std::string name;
  Vector3 position = Vector3::Zero(); ///< undeformed [m]
  Matrix rows; ///< 6 x n: three displacements [m], three rotations [rad] per unit coordinate
  /// 6, under the body's loads [m, rad]; empty without loads.
  Vector static_displacement{};
  /// 3 x 3, static displacement along an axis (row) per unit force along another (column), of the
  /// body before reduction [m/N]; empty for bodies without a mesh and for those that no support
  /// holds.
  Matrix flexibility{};
  /// 3 x 3, velocity along an axis (row) right after a unit impulse along another (column), of the
  /// body before reduction: P M^-1 P^T over the free degrees of freedom, with the consistent mass
  /// [1/kg]. Empty for bodies without a mesh, where the point moves without mass, and where the
  /// mass matrix is singular.
  Matrix inverse_mass{};
  std::string interface {}; ///< the interface the point is one of; empty for a point by itself
  int node = -1;            ///< column of Recovery::nodes; -1 for bodies without a mesh
  /// Stress per unit coordinate at each of the k places where the elements that meet here are
  /// looked at, (stress_components k) x n [Pa]; empty without a mesh and for cross-sections of
  /// unknown shape.
  Matrix stress{};
  Index stress_components = 3; ///< see squared_von_mises()
};

/// Stress in the elements of each cell per unit coordinate.
struct CellStress {
  Matrix rows{};          ///< (components k) x n for k places [Pa]
  std::vector<int> first; ///< each cell's first place, then k
  Index components = 3;   ///< see squared_von_mises()

  bool empty() const { return rows.rows() == 0; }
};

/// Nodes, cells and mode shapes, to expand coordinates to the mesh.
struct Recovery {
  Matrix nodes;                          ///< 3 x N, undeformed positions [m]
  std::vector<std::array<int, 2>> lines; ///< node pairs of beam elements
  std::vector<structure::Cell> cells;    ///< of shell and solid elements
  Matrix shapes;                         ///< 6N x n: rows 6 i + component of node i
  /// 6N, displacement of the mesh under the body's loads [m, rad]; empty without loads.
  Vector static_displacement{};
  /// The extreme fibres at the first node, then as many at the second; none where the cross-section
  /// has no known shape.
  CellStress line_stress{};
  /// In the middle of an element: of shells at the face that the normal points to, then the other.
  CellStress cell_stress{};

  bool empty() const { return lines.empty() && cells.empty(); }
};

/// What turning about an axis at a constant speed Omega adds:
///
///   ... + Omega gyroscopic q' + (Omega circulatory + Omega^2 centrifugal) q
///       = ... + Omega^2 centrifugal_load
///
/// In the fixed frame these are gyroscopic moments, and circulatory forces of the damping that
/// turns with the body. In the rotating frame, with which the displacements turn, the first are
/// Coriolis forces.
struct SpinMatrices {
  Vector3 axis = Vector3::Zero(); ///< unit vector, about which the speed is positive
  bool rotating_frame = false;
  Matrix gyroscopic;       ///< n x n, skew; does no work
  Matrix centrifugal;      ///< n x n, symmetric; 0 x 0 in the fixed frame
  Vector centrifugal_load; ///< n; empty in the fixed frame
  /// n x n, skew: u'. (axis x u) over the mass, with rotations likewise. In a vibration it is
  /// positive where points go round as the body turns, forward whirl, and negative backward.
  Matrix turning;
  Matrix crosswise;     ///< n x n, symmetric: |axis x u|^2 over the mass, with rotations likewise
  Matrix circulatory{}; ///< n x n, skew; 0 x 0 without internal damping and in the rotating frame

  bool empty() const { return gyroscopic.size() == 0; }
};

struct ReducedBody {
  std::string name;
  std::string type; ///< "beam", "shell", "solid", "matrices", "lumped", "rotor" or "modes"

  Vector mass;               ///< n
  Vector stiffness;          ///< n
  Matrix damping;            ///< n x n, symmetric
  Matrix base_participation; ///< n x 3: Phi^T M r for a unit base displacement along each axis [kg
                             ///< / unit]

  std::vector<BodyPoint> points;
  Recovery recovery;   ///< empty for lumped bodies
  SpinMatrices spin{}; ///< empty where nothing turns

  Vector3 total_mass = Vector3::Zero(); ///< mass that a base motion along each axis moves [kg]
  /// n, for modal bodies: bound of the relative error of omega^2, from r = K phi - omega^2 M phi in
  /// the norm of K^-1: sqrt(r^T K^-1 r / phi^T K phi), K slightly shifted. The plain norm
  /// |r| / |K phi| says nothing on a fine mesh, where round-off alone makes it large.
  Vector eigen_residual;
  double orthogonality_residual = 0; ///< max |Phi^T M Phi - I|, for modal bodies

  Index size() const { return mass.size(); }
  bool modal() const { return type != "lumped" && type != "rotor"; }
  /// Undamped natural angular frequency of each coordinate by itself [rad/s]; 0 for rigid modes.
  Vector omega() const { return (stiffness.array() / mass.array()).max(0.0).sqrt(); }
  /// Fraction of critical damping of each coordinate by itself; 0 where omega is 0.
  Vector damping_ratio() const;
  /// Share of a point's flexibility along a direction that the coordinates carry; 1 where there is
  /// nothing to carry or the flexibility is not known.
  double flexibility_share(const BodyPoint &point, const Vector3 &direction) const;
  /// base_participation^2 / mass: n x 3 [kg].
  Matrix effective_mass() const;
  /// Throws std::logic_error when there is no such point.
  const BodyPoint &point(const std::string &point_name) const;
};

} // namespace vibroimpact::reduction
