#include "structure/membrane_quadrilateral.h"

#include "structure/surface_normals.h"

#include <Eigen/Dense>

namespace vibroimpact::structure {

namespace {

// Errors change by less than 1 % between 5 and 20 (docs/gallery/plates-and-shells.md).
constexpr double sagitta_weight = 10;

/// Half the change of the squared length of the arc from corner i to corner j.
StrainRow arc(const NodeVectors &corners, const NodeVectors &directors, int i, int j) {
  const Vector3 chord = corners[j] - corners[i];
  const Vector3 turn = directors[j] - directors[i];
  const double bend = turn.dot(chord) / 12;
  StrainRow row = StrainRow::Zero();
  row.segment<3>(6 * j) = chord + bend * turn;
  row.segment<3>(6 * i) = -chord - bend * turn;
  row.segment<3>(6 * j + 3) = bend * directors[j].cross(chord);
  row.segment<3>(6 * i + 3) = -bend * directors[i].cross(chord);
  return row;
}

/// Of a straight side.
StrainRow chord(const NodeVectors &corners, int i, int j) {
  StrainRow row = StrainRow::Zero();
  row.segment<3>(6 * j) = corners[j] - corners[i];
  row.segment<3>(6 * i) = corners[i] - corners[j];
  return row;
}

/// About the normal, of displacements carried to the mean plane: u_i + z_i grad w with w = n . u
/// and the gradient of the middle. So a rotation about an axis in the plane has none.
StrainRow spin(const MeanPlane &plane, const NodeVectors &corners, const NodeVectors &gradients,
               const NodeVectors &middle) {
  StrainRow row = StrainRow::Zero();
  Vector3 by_slope = Vector3::Zero();
  for (int i = 0; i < 4; ++i) {
    const Vector3 by_displacement = plane.normal.cross(gradients[i]) / 2;
    row.segment<3>(6 * i) = by_displacement;
    by_slope += plane.normal.dot(corners[i]) * by_displacement;
  }
  for (int i = 0; i < 4; ++i)
    row.segment<3>(6 * i) += by_slope.dot(middle[i]) * plane.normal;
  return row;
}

} // namespace

MembraneQuadrilateral::MembraneQuadrilateral(const NodeVectors &corners,
                                             const NodeVectors &directors,
                                             const NodeVectors &surface_normals,
                                             const ShellProperties &properties)
    : corners_(corners), directors_(directors), plane_(corners) {
  const double weighted =
      sagitta_weight * sagitta(corners, surface_normals, plane_.normal) / properties.thickness;
  drilling_share_ = 1 / (1 + weighted * weighted);
  area_in_the_middle_ = TangentBasis(at(0, 0)).area;
  add_line_strains();
  add_drilling();
  eliminate_modes(properties);
}

DirectorPoint MembraneQuadrilateral::at(double r, double s) const {
  const Shape shape = bilinear(r, s);
  return director_point(shape, shape, corners_, directors_);
}

void MembraneQuadrilateral::add_line_strains() {
  given_.row(0) = chord(corners_, 3, 2) / 4;
  given_.row(1) = chord(corners_, 0, 1) / 4;
  given_.row(2) = chord(corners_, 1, 2) / 4;
  given_.row(3) = chord(corners_, 0, 3) / 4;
  given_.row(4) = (arc(corners_, directors_, 0, 2) - arc(corners_, directors_, 1, 3)) / 16;
}

// D_i = V_i . (theta_i - Omega) + omega_0 with the mean rotation of the element,
// Omega = grad w x n + omega_0 n, and the spin omega_0 of its middle.
void MembraneQuadrilateral::add_drilling() {
  const NodeVectors middle = plane_.gradients(at(0, 0));
  const StrainRow middle_spin = spin(plane_, corners_, middle, middle);
  const auto points = gauss_points();
  for (int p = 0; p < n_points; ++p) {
    const DirectorPoint point = at(points[p][0], points[p][1]);
    const Vector3 tilt = plane_.normal.cross(point.director);
    StrainRow row = (1 - plane_.normal.dot(point.director)) * middle_spin -
                    spin(plane_, corners_, plane_.gradients(point), middle);
    for (int i = 0; i < 4; ++i) {
      row.segment<3>(6 * i) -= tilt.dot(middle[i]) * plane_.normal;
      row.segment<3>(6 * i + 3) += point.translation.value[i] * directors_[i];
    }
    given_.row(n_lines + p) = row;
  }
}

// Rows e_rr, e_ss, 2 e_rs; columns A ... E.
Eigen::Matrix<double, 3, 5> MembraneQuadrilateral::interpolation(double r, double s) const {
  const double c_r = plane_.twist_r;
  const double c_s = plane_.twist_s;
  Eigen::Matrix<double, 1, 5> twist;
  twist << c_r * (c_r - 1), c_r * (c_r + 1), c_s * (c_s - 1), c_s * (c_s + 1), 4 * c_r * c_s;
  twist /= 2 * (c_r * c_r + c_s * c_s - 1);
  Eigen::Matrix<double, 3, 5> rows;
  rows << (1 + s) / 2, (1 - s) / 2, 0, 0, 0, //
      0, 0, (1 + r) / 2, (1 - r) / 2, 0,     //
      r / 2, -r / 2, s / 2, -s / 2, 2;
  rows.row(0) += (s * s - 1) * twist;
  rows.row(1) += (r * r - 1) * twist;
  rows.row(2) += 2 * r * s * twist;
  return rows;
}

// With the metric of the middle and the ratio of the areas their mean over the element vanishes, so
// that they leave constant strains alone.
NodeVectors MembraneQuadrilateral::mode_gradients(double r, double s, double area) const {
  const Vector3 of_r = -2 * r * area_in_the_middle_ / area * plane_.dual_r;
  const Vector3 of_s = -2 * s * area_in_the_middle_ / area * plane_.dual_s;
  return {of_r, of_s, of_r, of_s};
}

Eigen::Matrix<double, 3, 4> MembraneQuadrilateral::mode_strain(double r, double s,
                                                               const TangentBasis &basis) const {
  const NodeVectors gradients = mode_gradients(r, s, basis.area);
  Eigen::Matrix<double, 3, n_modes> strain;
  for (int m = 0; m < n_modes; ++m) {
    const Vector3 &axis = m < 2 ? plane_.first : plane_.second;
    const double axis_1 = axis.dot(basis.first);
    const double axis_2 = axis.dot(basis.second);
    const double gradient_1 = gradients[m].dot(basis.first);
    const double gradient_2 = gradients[m].dot(basis.second);
    strain.col(m) << axis_1 * gradient_1, axis_2 * gradient_2,
        axis_1 * gradient_2 + axis_2 * gradient_1;
  }
  return strain;
}

Eigen::Matrix<double, 1, 4> MembraneQuadrilateral::mode_spin(double r, double s,
                                                             const TangentBasis &basis) const {
  const NodeVectors gradients = mode_gradients(r, s, basis.area);
  Eigen::Matrix<double, 1, n_modes> spin;
  for (int m = 0; m < n_modes; ++m)
    spin[m] = plane_.normal.dot(gradients[m].cross(m < 2 ? plane_.first : plane_.second)) / 2;
  return spin;
}

MembraneQuadrilateral::Energy
MembraneQuadrilateral::energy(const ShellProperties &properties) const {
  const double drilling_stiffness = drilling_share_ * properties.membrane_stiffness(2, 2);
  Energy energy = Energy::Zero();
  const auto points = gauss_points();
  for (int p = 0; p < n_points; ++p) {
    const auto [r, s] = points[p];
    const TangentBasis basis(at(r, s));
    Eigen::Matrix<double, 3, n_given + n_modes> strain;
    strain << basis.in_plane * interpolation(r, s), Eigen::Matrix<double, 3, n_points>::Zero(),
        mode_strain(r, s, basis);
    Eigen::Matrix<double, 1, n_given + n_modes> drilling;
    drilling << Eigen::Matrix<double, 1, n_given>::Unit(n_lines + p), -mode_spin(r, s, basis);
    energy += basis.area * strain.transpose() * properties.membrane_stiffness * strain;
    energy += basis.area * drilling_stiffness * drilling.transpose() * drilling;
  }
  return energy;
}

void MembraneQuadrilateral::eliminate_modes(const ShellProperties &properties) {
  const Energy all = energy(properties);
  const Eigen::Matrix<double, n_modes, n_given> coupling = all.bottomLeftCorner<n_modes, n_given>();
  modes_ = -all.bottomRightCorner<n_modes, n_modes>().ldlt().solve(coupling);
  condensed_ = all.topLeftCorner<n_given, n_given>() + coupling.transpose() * modes_;
}

Eigen::Matrix<double, 24, 24> MembraneQuadrilateral::stiffness() const {
  const Eigen::Matrix<double, n_given, 24> forces = condensed_ * given_;
  return given_.transpose() * forces;
}

Eigen::Matrix<double, 3, 24> MembraneQuadrilateral::strain(double r, double s) const {
  const TangentBasis basis(at(r, s));
  Eigen::Matrix<double, 3, n_given> from_given = mode_strain(r, s, basis) * modes_;
  from_given.leftCols<n_lines>() += basis.in_plane * interpolation(r, s);
  return from_given * given_;
}

} // namespace vibroimpact::structure
