#include "structure/beam_matrices.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <deal.II/base/quadrature_lib.h>

namespace vibroimpact::structure {

// Exact for polynomials of degree 15: all integrals of a uniform beam (degree 6), and those of a
// tapered element, whose 1 / EI is smooth, to rounding unless its depth changes by a large factor.
const std::vector<std::pair<double, double>> &line_gauss_points() {
  static const auto points = [] {
    const dealii::QGauss<1> rule(8);
    std::vector<std::pair<double, double>> list;
    for (unsigned i = 0; i < rule.size(); ++i)
      list.emplace_back(rule.point(i)[0], rule.weight(i));
    return list;
  }();
  return points;
}

namespace {

/// Motion (rows u, v, w, rx, ry, rz) of the section at x by unit forces that belong to the
/// deformations, with the first end held: with these forces the internal moments are
///   M_z = -(1 - t/L) s_4 + t/L s_5,   V_y = -(s_4 + s_5) / L,   and likewise
///   M_y = -(1 - t/L) s_2 + t/L s_3,   V_z = (s_2 + s_3) / L,
/// curvatures r_z' = M_z / EI_z, r_y' = M_y / EI_y, slopes v' = r_z + V_y / (kappa_y G A) and
/// w' = -r_y + V_z / (kappa_z G A).
DeformationMatrix motion_by_forces(const PropertiesAlong &properties, double length, double x) {
  DeformationMatrix motion = DeformationMatrix::Zero();
  for (const auto &[point, weight] : line_gauss_points()) {
    const double t = point * x;
    const double part = weight * x;
    const double lever = x - t;
    const BeamProperties p = properties(t / length);
    const Eigen::RowVector2d moment(-(1 - t / length), t / length);
    const Eigen::RowVector2d shear = Eigen::RowVector2d::Constant(1 / length);
    motion(0, 0) += part / p.axial_stiffness;
    motion(3, 1) += part / p.torsional_stiffness;
    motion.block<1, 2>(4, 2) += part / p.bending_stiffness_y * moment;
    motion.block<1, 2>(5, 4) += part / p.bending_stiffness_z * moment;
    motion.block<1, 2>(2, 2) +=
        part * (p.shear_flexibility_z * shear - lever / p.bending_stiffness_y * moment);
    motion.block<1, 2>(1, 4) +=
        part * (lever / p.bending_stiffness_z * moment - p.shear_flexibility_y * shear);
  }
  return motion;
}

/// The second end stays on the chord: v(L) = 0 = L d_4 + ..., w(L) = 0 = -L d_2 + ...
DeformationMatrix flexibility(const PropertiesAlong &properties, double length) {
  const DeformationMatrix end = motion_by_forces(properties, length, length);
  DeformationMatrix by_forces;
  by_forces.row(0) = end.row(0);
  by_forces.row(1) = end.row(3);
  by_forces.row(2) = end.row(2) / length;
  by_forces.row(3) = by_forces.row(2) + end.row(4);
  by_forces.row(4) = -end.row(1) / length;
  by_forces.row(5) = by_forces.row(4) + end.row(5);
  return (by_forces + by_forces.transpose()) / 2;
}

DeformationMatrix inverse(const DeformationMatrix &flexibility) {
  DeformationMatrix stiffness = DeformationMatrix::Zero();
  stiffness(0, 0) = 1 / flexibility(0, 0);
  stiffness(1, 1) = 1 / flexibility(1, 1);
  for (const int plane : {2, 4})
    stiffness.block<2, 2>(plane, plane) = flexibility.block<2, 2>(plane, plane).inverse();
  return (stiffness + stiffness.transpose()) / 2;
}

/// Motion of the section at x from that of the ends: the chord, and what deforms from it.
SectionMotion section_motion(const Eigen::Matrix<double, 6, 12> &deformation,
                             const DeformationMatrix &forces, const DeformationMatrix &by_forces,
                             double length, double x) {
  const double along = x / length;
  SectionMotion motion = by_forces * forces * deformation;
  motion.row(1) += x * deformation.row(4); // the first end turns from the chord
  motion.row(2) -= x * deformation.row(2);
  motion.row(4) += deformation.row(2);
  motion.row(5) += deformation.row(4);
  motion(0, 0) += 1;
  motion(3, 3) += 1;
  for (const int axis : {1, 2}) {
    motion(axis, axis) += 1 - along;
    motion(axis, axis + 6) += along;
  }
  motion(4, 2) += 1 / length;
  motion(4, 8) -= 1 / length;
  motion(5, 1) -= 1 / length;
  motion(5, 7) += 1 / length;
  return motion;
}

Bending bending_xy(const SectionMotion &motion, const SectionMotion &forces,
                   const BeamProperties &p, double length, double along) {
  Bending plane;
  plane.rotation = motion.row(5);
  plane.curvature = (along * forces.row(5) - (1 - along) * forces.row(4)) / p.bending_stiffness_z;
  plane.shear_force = -(forces.row(4) + forces.row(5)) / length;
  plane.shear_angle = p.shear_flexibility_y * plane.shear_force;
  plane.slope = plane.rotation + plane.shear_angle;
  return plane;
}

/// The rotation whose slope is w' is -ry.
Bending bending_xz(const SectionMotion &motion, const SectionMotion &forces,
                   const BeamProperties &p, double length, double along) {
  Bending plane;
  plane.rotation = -motion.row(4);
  plane.curvature = ((1 - along) * forces.row(2) - along * forces.row(3)) / p.bending_stiffness_y;
  plane.shear_force = (forces.row(2) + forces.row(3)) / length;
  plane.shear_angle = p.shear_flexibility_z * plane.shear_force;
  plane.slope = plane.rotation + plane.shear_angle;
  return plane;
}

/// What the ends of the beam do at the nodes where they are released.
struct Slip {
  std::vector<int> rows;                               ///< released ones, of an ElementVector
  Eigen::Matrix<double, 6, Eigen::Dynamic> directions; ///< deformations by a unit of each
  Matrix by_deformations;                              ///< of the nodes
};

/// The forces at released ends vanish: with the stiffness S of the deformations and b those by the
/// released displacements, b^T S (d - b a) = 0 gives the slip a = (b^T S b)^-1 b^T S d.
Slip slip(const Eigen::Matrix<double, 6, 12> &deformation, const DeformationMatrix &stiffness,
          const Releases &releases) {
  Slip result;
  for (int row = 0; row < 12; ++row)
    if (releases[row])
      result.rows.push_back(row);
  result.directions = deformation(Eigen::all, result.rows);
  if (result.rows.empty())
    return result;
  const Matrix loose = result.directions.transpose() * stiffness * result.directions;
  const Vector scale = loose.diagonal().array().rsqrt();
  const Matrix scaled = scale.asDiagonal() * loose * scale.asDiagonal();
  constexpr double least = 1e-9; // of rounding: 1e-16
  if (symmetric_eigen(scaled).values[0] < least)
    throw NumericalError("is free to move in itself");
  result.by_deformations = scale.asDiagonal() * vibroimpact::inverse(scaled) * scale.asDiagonal() *
                           result.directions.transpose() * stiffness;
  return result;
}

/// Forces of what is left after the slip. Those that vanish by themselves do so without round-off,
/// so that a mechanism has a frequency of exactly zero.
DeformationMatrix without_released(const DeformationMatrix &stiffness, const Slip &released) {
  DeformationMatrix rest = stiffness - stiffness * released.directions * released.by_deformations;
  for (const auto &direction : released.directions.colwise())
    if ((direction.array() != 0).count() == 1)
      for (int i = 0; i < 6; ++i)
        if (direction[i] != 0) {
          rest.row(i).setZero();
          rest.col(i).setZero();
        }
  return rest;
}

DeformationVector inertia(const BeamProperties &p) {
  DeformationVector diagonal;
  diagonal << p.mass_per_length, p.mass_per_length, p.mass_per_length, p.polar_inertia,
      p.rotary_inertia_y, p.rotary_inertia_z;
  return diagonal;
}

/// What inertia bends inside the element, beyond the deflection under forces at its ends: with the
/// loads p = omega^2 rho A v and m = omega^2 rho I r it has, to the order h^2, the kinetic energy
/// of
///   omega^2 h^2 / 12 ((rho A v)^2 / (kappa G A) + (rho I r)^2 / (E I)),
/// where p = -V' and m = -M' - V. By parts (nothing remains at free, pinned and clamped ends) that
/// is
///   h^2 / 12 (rho A g v' + rho I r'^2 - rho / E V r).
/// With it frequencies converge with the order 4, otherwise with 2. It vanishes for rigid motions,
/// and altogether without shear deformation, where the deflection under end forces is a basis of
/// Ritz with the order 4 by itself.
ElementMatrix inner_inertia(const Bending &plane, double mass_per_length, double rotary_inertia,
                            double bending_stiffness, double length) {
  return length * length / 12 *
         (mass_per_length * plane.shear_angle.transpose() * plane.slope +
          rotary_inertia * plane.curvature.transpose() * plane.curvature -
          rotary_inertia / bending_stiffness * plane.shear_force.transpose() * plane.rotation);
}

void integrate(const PropertiesAlong &properties, double length, const DeformationMatrix &stiffness,
               BeamMatrices &matrices) {
  matrices.mass.setZero();
  matrices.geometric.setZero();
  for (const SectionSample &sample : section_samples(properties, length, stiffness)) {
    const BeamProperties &p = sample.properties;
    const double part = sample.part;
    matrices.total_mass += part * p.mass_per_length;
    matrices.mass += part * sample.motion.transpose() * inertia(p).asDiagonal() * sample.motion;
    if (p.shear_flexibility_y > 0 || p.shear_flexibility_z > 0)
      matrices.mass += part * (inner_inertia(sample.xy, p.mass_per_length, p.rotary_inertia_z,
                                             p.bending_stiffness_z, length) +
                               inner_inertia(sample.xz, p.mass_per_length, p.rotary_inertia_y,
                                             p.bending_stiffness_y, length));
    if (p.axial_force != 0)
      matrices.geometric += part * axial_work(sample, p.axial_force);
  }
}

ElementMatrix symmetric(const ElementMatrix &matrix) { return (matrix + matrix.transpose()) / 2; }

} // namespace

ElementMatrix axial_work(const SectionSample &sample, double axial_force) {
  return axial_force *
         (sample.xy.slope.transpose() * sample.xy.slope +
          sample.xz.slope.transpose() * sample.xz.slope +
          sample.properties.polar_radius_squared * sample.twist.transpose() * sample.twist);
}

std::vector<SectionSample> section_samples(const PropertiesAlong &properties, double length,
                                           const DeformationMatrix &stiffness) {
  const Eigen::Matrix<double, 6, 12> deformation = deformation_matrix(length);
  const SectionMotion forces = stiffness * deformation;
  std::vector<SectionSample> samples;
  for (const auto &[along, weight] : line_gauss_points()) {
    SectionSample sample{.along = along, .part = weight * length, .properties = properties(along)};
    const BeamProperties &p = sample.properties;
    sample.motion =
        section_motion(deformation, stiffness, motion_by_forces(properties, length, along * length),
                       length, along * length);
    sample.xy = bending_xy(sample.motion, forces, p, length, along);
    sample.xz = bending_xz(sample.motion, forces, p, length, along);
    sample.twist = forces.row(1) / p.torsional_stiffness;
    samples.push_back(std::move(sample));
  }
  return samples;
}

DeformationMatrix deformation_stiffness(const PropertiesAlong &properties, double length) {
  return inverse(flexibility(properties, length));
}

Eigen::Matrix<double, 6, 12> deformation_matrix(double length) {
  Eigen::Matrix<double, 6, 12> rows = Eigen::Matrix<double, 6, 12>::Zero();
  for (const int row : {0, 1}) { // stretch from u, twist from rx
    rows(row, 3 * row) = -1;
    rows(row, 3 * row + 6) = 1;
  }
  for (const int end : {0, 1}) {
    rows(2 + end, 4 + 6 * end) = 1;
    rows(4 + end, 5 + 6 * end) = 1;
    rows(2 + end, 2) = rows(4 + end, 7) = -1 / length;
    rows(2 + end, 8) = rows(4 + end, 1) = 1 / length;
  }
  return rows;
}

BeamMatrices beam_matrices(const PropertiesAlong &properties, double length,
                           const Releases &releases) {
  const Eigen::Matrix<double, 6, 12> deformation = deformation_matrix(length);
  const DeformationMatrix stiffness = deformation_stiffness(properties, length);
  BeamMatrices matrices;
  integrate(properties, length, stiffness, matrices);
  const Slip released = slip(deformation, stiffness, releases);
  matrices.ends.setIdentity();
  if (!released.rows.empty()) {
    const Matrix at_nodes = released.by_deformations * deformation;
    for (std::size_t i = 0; i < released.rows.size(); ++i)
      matrices.ends.row(released.rows[i]) -= at_nodes.row(static_cast<Index>(i));
    matrices.stiffness = without_released(stiffness, released);
  } else {
    matrices.stiffness = stiffness;
  }
  matrices.stiffness = (matrices.stiffness + matrices.stiffness.transpose()).eval() / 2;
  matrices.mass = symmetric(matrices.ends.transpose() * matrices.mass * matrices.ends);
  matrices.geometric = symmetric(matrices.ends.transpose() * matrices.geometric * matrices.ends);
  return matrices;
}

} // namespace vibroimpact::structure
