// The membrane of the quadrilateral shell element, flat or warped, with the rotations about the
// normals (drilling) as rotations of the material.
//
// *Strain.* The bilinear displacements of a warped element cannot bend without stretching: the part
// x_d . u_d of their strain responds to it. MITC4+ (ko2017) replaces it by what the strains along
// the four sides (A: s = 1, B: s = -1, C: r = 1, D: r = -1) and the shear E in the middle say of
// it,
//
//   e_b  = [c_r (c_r-1) A + c_r (c_r+1) B + c_s (c_s-1) C + c_s (c_s+1) D + 4 c_r c_s E] / (2 d),
//   e_rr = (A+B)/2 + s (A-B)/2 + (s^2-1) e_b,        d = c_r^2 + c_s^2 - 1,
//   e_ss = (C+D)/2 + r (C-D)/2 + (r^2-1) e_b,        x_d = c_r x_r + c_s x_s + (..) n
//   e_rs = E + r (A-B)/4 + s (C-D)/4 + r s e_b,
//
// which in a flat element is x_d . u_d itself. All five follow from lengths: the sides are
// straight, and 16 E is the difference of the diagonals D, of which each is an arc of the surface
// that turns its normal V from one end to the other,
//
//   S^2 = |D|^2 + (D . (V_j - V_i))^2 / 12.
//
// The second term, which MITC4+ does not have, makes bending without stretching free of E.
//
// *In-plane bending.* The incompatible displacements (1 - r^2) a_1, (1 - s^2) a_2 along one axis
// and a_3, a_4 along the other (taylor1976) add to the strain and, after ibrahimbegovic1991, to the
// spin; they are eliminated in the element.
//
// *Drilling.* G t gamma integral (sum h_i D_i - omega)^2 dA (hughes1989), with the spin omega of
// the displacements as they would be in the mean plane and the drilling D_i of corner i relative to
// the element, about the normal V_i of the surface there. About n it would answer to bending:
// neighbours turn against each other by axes that lie in the surface, but not in the plane of a
// warped element. What is left of that is an error of the order of the sagitta s of the surface
// over the element, relative to the thickness t, and gamma = 1 / (1 + (10 s/t)^2) keeps its energy
// below that of bending. gamma is 1 in flat parts and tends to 1 with the square of the size of the
// elements.
#pragma once

#include "structure/quadrilateral_geometry.h"
#include "structure/shell_properties.h"

namespace vibroimpact::structure {

class MembraneQuadrilateral {
public:
  /// `corners` relative to their mean [m], `directors`: corner_normals of them; `surface_normals`:
  /// unit normals at the corners of the surface that the whole mesh stands for.
  MembraneQuadrilateral(const NodeVectors &corners, const NodeVectors &directors,
                        const NodeVectors &surface_normals, const ShellProperties &properties);

  Eigen::Matrix<double, 24, 24> stiffness() const;
  /// (e_11, e_22, 2 e_12) from the nodal displacements, in the TangentBasis of the point (r, s).
  Eigen::Matrix<double, 3, 24> strain(double r, double s) const;
  /// gamma, the share of the shear stiffness that resists drilling; 0 ... 1.
  double drilling_share() const { return drilling_share_; }

private:
  static constexpr int n_lines = 5;  ///< strains A ... E
  static constexpr int n_points = 4; ///< of integration, where the drilling is compared
  static constexpr int n_given = n_lines + n_points;
  static constexpr int n_modes = 4;
  using Energy = Eigen::Matrix<double, n_given + n_modes, n_given + n_modes>;

  DirectorPoint at(double r, double s) const;
  void add_line_strains();
  void add_drilling();
  void eliminate_modes(const ShellProperties &properties);
  Energy energy(const ShellProperties &properties) const;
  Eigen::Matrix<double, 3, n_lines> interpolation(double r, double s) const;
  NodeVectors mode_gradients(double r, double s, double area) const;
  Eigen::Matrix<double, 3, n_modes> mode_strain(double r, double s,
                                                const TangentBasis &basis) const;
  Eigen::Matrix<double, 1, n_modes> mode_spin(double r, double s, const TangentBasis &basis) const;

  NodeVectors corners_;
  NodeVectors directors_;
  MeanPlane plane_;
  double drilling_share_ = 1;
  double area_in_the_middle_ = 0; ///< per dr ds
  /// Strains A ... E and the differences of drilling at the Gauss points from nodal displacements.
  Eigen::Matrix<double, n_given, 24> given_ = Eigen::Matrix<double, n_given, 24>::Zero();
  Eigen::Matrix<double, n_given, n_given> condensed_; ///< energy in terms of them
  Eigen::Matrix<double, n_modes, n_given> modes_;     ///< amplitudes from them
};

} // namespace vibroimpact::structure
