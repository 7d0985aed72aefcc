#include "structure/beam_spin.h"

namespace vibroimpact::structure {

namespace {

/// a^T b - b^T a
ElementMatrix wedge(const EndRow &a, const EndRow &b) {
  return a.transpose() * b - b.transpose() * a;
}

/// Of rotations r1 = rz and r2 = -ry about an axis along local x: rho I_p (r1^T r2 - r2^T r1).
/// With shear the same bending inside the element belongs to it as to the rotary inertia (see
/// inner_inertia() of the mass matrix), which the moments of both bend alike.
ElementMatrix gyroscopic(const SectionSample &sample, double length) {
  const BeamProperties &p = sample.properties;
  const Bending &xy = sample.xy;
  const Bending &xz = sample.xz;
  ElementMatrix matrix = wedge(xy.rotation, xz.rotation);
  if (p.shear_flexibility_y > 0)
    matrix += length * length / 12 *
              (wedge(xy.curvature, xz.curvature) -
               (wedge(xy.shear_force, xz.rotation) + wedge(xy.rotation, xz.shear_force)) /
                   (2 * p.bending_stiffness_y));
  return p.polar_inertia * matrix;
}

void add_whirl(const SectionSample &sample, const Eigen::Matrix3d &cross, BeamSpin &spin) {
  const auto add = [&](const auto &rows, double mass) {
    spin.turning += sample.part * mass * rows.transpose() * cross * rows;
    spin.crosswise -= sample.part * mass * rows.transpose() * cross * cross * rows;
  };
  add(sample.motion.topRows<3>(), sample.properties.mass_per_length);
  add(sample.motion.bottomRows<3>(), sample.properties.rotary_inertia_y);
}

/// Without rotary inertia in bending only the twist turns the section.
TurningPiece turning_section(const BeamProperties &p, const Vector3 &axis) {
  const double bending = p.bending_stiffness_y + p.bending_stiffness_z;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  moments(1, 1) = p.polar_inertia * p.bending_stiffness_z / bending;
  moments(2, 2) = p.polar_inertia * p.bending_stiffness_y / bending;
  TurningPiece piece = turning_piece(moments, axis);
  if (p.rotary_inertia_y > 0)
    return piece;
  const Vector3 twist = Vector3::UnitX();
  piece.gyroscopic.setZero();
  piece.centrifugal = Eigen::Matrix3d(piece.centrifugal(0, 0) * twist * twist.transpose());
  piece.load = Vector3(piece.load.x() * twist);
  return piece;
}

void add_rotating(const SectionSample &sample, const SpinPlace &place, double length,
                  BeamSpin &spin) {
  const BeamProperties &p = sample.properties;
  const Eigen::Matrix3d cross = cross_matrix(place.axis);
  const Eigen::Matrix3d across = -cross * cross;
  const Vector3 arm = place.start + sample.along * length * Vector3::UnitX();
  const auto u = sample.motion.topRows<3>();
  const auto theta = sample.motion.bottomRows<3>();
  const double mass = sample.part * p.mass_per_length;
  spin.gyroscopic += 2 * mass * u.transpose() * cross * u;
  spin.centrifugal -= mass * u.transpose() * across * u;
  spin.load += mass * u.transpose() * across * arm;
  const TurningPiece piece = turning_section(p, place.axis);
  spin.gyroscopic += sample.part * theta.transpose() * piece.gyroscopic * theta;
  spin.centrifugal += sample.part * theta.transpose() * piece.centrifugal * theta;
  spin.load += sample.part * theta.transpose() * piece.load;
}

/// In terms of the nodes, whose motion the ends leave at releases.
BeamSpin at_nodes(BeamSpin spin, const ElementMatrix &ends) {
  const auto skew = [](const ElementMatrix &a) -> ElementMatrix { return (a - a.transpose()) / 2; };
  spin.gyroscopic = skew(ends.transpose() * spin.gyroscopic * ends);
  spin.turning = skew(ends.transpose() * spin.turning * ends);
  spin.crosswise = (ends.transpose() * spin.crosswise * ends).eval();
  spin.centrifugal = (ends.transpose() * spin.centrifugal * ends).eval();
  spin.load = (ends.transpose() * spin.load).eval();
  return spin;
}

/// Centrifugal force along the element between a fraction of its length and the second end.
double pull_beyond(const PropertiesAlong &properties, double length, const SpinPlace &place,
                   double along) {
  const Eigen::Matrix3d cross = cross_matrix(place.axis);
  double force = 0;
  for (const auto &[point, weight] : line_gauss_points()) {
    const double at = along + (1 - along) * point;
    const Vector3 arm = place.start + at * length * Vector3::UnitX();
    force +=
        weight * (1 - along) * length * properties(at).mass_per_length * (-cross * cross * arm).x();
  }
  return force;
}

/// K R is skew where the element turns into itself; of anything else its skew part.
void add_strain(const BeamMatrices &matrices, double length, const Vector3 &axis, BeamSpin &spin) {
  const auto deformation = deformation_matrix(length);
  spin.stiffness = deformation.transpose() * matrices.stiffness * deformation;
  ElementMatrix turn = ElementMatrix::Zero();
  for (int block = 0; block < 4; ++block)
    turn.block<3, 3>(3 * block, 3 * block) = cross_matrix(axis);
  const ElementMatrix turned = spin.stiffness * turn;
  spin.circulatory = (turned.transpose() - turned) / 2;
}

} // namespace

Eigen::Matrix3d cross_matrix(const Vector3 &w) {
  Eigen::Matrix3d matrix;
  matrix << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return matrix;
}

// With Theta = sum of theta_i E_i, A the cross matrix of the axis and Q = A^T A, the kinetic energy
// tr((R' + Omega A R) P (R' + Omega A R)^T) / 2 has
//   Omega theta'_i theta_j tr(E_i P E_j A), of which the skew part counts,
//   Omega^2 theta_i theta_j (tr(Q E_i E_j P) - tr(Q E_i P E_j)) / 2  and  Omega^2 theta_i tr(Q E_i
//   P).
TurningPiece turning_piece(const Eigen::Matrix3d &second_moments, const Vector3 &axis) {
  const Eigen::Matrix3d &p = second_moments;
  const Eigen::Matrix3d a = cross_matrix(axis);
  const Eigen::Matrix3d q = -a * a;
  TurningPiece piece{};
  Eigen::Matrix3d both;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Matrix3d ei = cross_matrix(Vector3::Unit(i));
    piece.load[i] = (q * ei * p).trace();
    for (int j = 0; j < 3; ++j) {
      const Eigen::Matrix3d ej = cross_matrix(Vector3::Unit(j));
      piece.gyroscopic(i, j) = (ei * p * ej * a).trace() - (ej * p * ei * a).trace();
      both(i, j) = (q * ei * p * ej).trace() - (q * ei * ej * p).trace();
    }
  }
  piece.centrifugal = (both + both.transpose()) / 2;
  return piece;
}

BeamSpin beam_spin(const PropertiesAlong &properties, double length, const Releases &releases,
                   const SpinPlace &place) {
  BeamSpin spin;
  for (const SectionSample &sample :
       section_samples(properties, length, deformation_stiffness(properties, length))) {
    spin.gyroscopic += place.axis.x() * sample.part * gyroscopic(sample, length);
    add_whirl(sample, cross_matrix(place.axis), spin);
  }
  const BeamMatrices matrices = beam_matrices(properties, length, releases);
  spin = at_nodes(spin, matrices.ends);
  add_strain(matrices, length, place.axis, spin);
  return spin;
}

BeamSpin rotating_beam(const PropertiesAlong &properties, double length, const Releases &releases,
                       const SpinPlace &place) {
  BeamSpin spin;
  for (const SectionSample &sample :
       section_samples(properties, length, deformation_stiffness(properties, length))) {
    add_rotating(sample, place, length, spin);
    add_whirl(sample, cross_matrix(place.axis), spin);
  }
  const BeamMatrices matrices = beam_matrices(properties, length, releases);
  spin = at_nodes(spin, matrices.ends);
  add_strain(matrices, length, place.axis, spin);
  return spin;
}

// N(x) = N_0 + the pull of what lies beyond x; the integral of N / EA is the stretch.
ElementMatrix centrifugal_stiffening(const PropertiesAlong &properties, double length,
                                     const Releases &releases, const SpinPlace &place,
                                     const ElementVector &displacement) {
  const ElementMatrix ends = beam_matrices(properties, length, releases).ends;
  const auto samples =
      section_samples(properties, length, deformation_stiffness(properties, length));
  const ElementVector moved = ends * displacement;
  double stretch = moved[6] - moved[0];
  double flexibility = 0;
  for (const SectionSample &sample : samples) {
    flexibility += sample.part / sample.properties.axial_stiffness;
    stretch -= sample.part / sample.properties.axial_stiffness *
               pull_beyond(properties, length, place, sample.along);
  }
  const double at_end = stretch / flexibility;
  ElementMatrix stiffness = ElementMatrix::Zero();
  for (const SectionSample &sample : samples)
    stiffness += sample.part *
                 axial_work(sample, at_end + pull_beyond(properties, length, place, sample.along));
  return ends.transpose() * stiffness * ends;
}

} // namespace vibroimpact::structure
