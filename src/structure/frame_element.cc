#include "structure/frame_element.h"

#include <cmath>

namespace vibroimpact::structure {

namespace {

constexpr double parallel_tolerance = 1e-3; // sine of the smallest angle between y axis and element

Vector3 reference_direction(const Vector3 &x, const std::optional<Vector3> &local_y) {
  if (local_y)
    return local_y->normalized();
  const bool along_y = x.cross(Vector3::UnitY()).norm() < parallel_tolerance;
  return along_y ? Vector3::UnitZ() : Vector3::UnitY();
}

/// End moments of a bent element from its end rotations relative to the chord.
struct EndMoments {
  double first, second;
};
EndMoments end_moments(double bending_stiffness, double length, double first, double second) {
  const double factor = 2 * bending_stiffness / length;
  return {factor * (2 * first + second), factor * (first + 2 * second)};
}

/// Where displacement and rotation of both ends stand in the element vector, for one plane.
/// `sense` is +1 when the slope equals the rotation, -1 when it is opposite to it.
struct Plane {
  std::array<int, 4> dofs;
  double sense;
};
constexpr Plane plane_xy{{1, 5, 7, 11}, 1.0};
constexpr Plane plane_xz{{2, 4, 8, 10}, -1.0};

void add_plane_mass(ElementMatrix &mass, const Plane &plane, double mass_per_length,
                    double length) {
  const double l = length;
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l,             //
      22 * l, 4 * l * l, 13 * l, -3 * l * l, //
      54, 13 * l, 156, -22 * l,              //
      -13 * l, -3 * l * l, -22 * l, 4 * l * l;
  const Eigen::Vector4d sign(1, plane.sense, 1, plane.sense);
  m = mass_per_length * l / 420 * (sign.asDiagonal() * m * sign.asDiagonal());
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      mass(plane.dofs[i], plane.dofs[j]) += m(i, j);
}

void add_linear_mass(ElementMatrix &mass, int dof, double inertia) {
  mass(dof, dof) += inertia / 3;
  mass(dof + 6, dof + 6) += inertia / 3;
  mass(dof, dof + 6) += inertia / 6;
  mass(dof + 6, dof) += inertia / 6;
}

} // namespace

ElementFrame element_frame(const Vector3 &first, const Vector3 &second,
                           const std::optional<Vector3> &local_y) {
  ElementFrame frame;
  frame.length = (second - first).norm();
  const Vector3 x = (second - first) / frame.length;
  const Vector3 z = x.cross(reference_direction(x, local_y));
  if (!(z.norm() > parallel_tolerance))
    throw DefinitionError("Geometry", "", "Orientation",
                          "must not be zero or parallel to an element of the body");
  frame.axes.row(0) = x;
  frame.axes.row(2) = z.normalized();
  frame.axes.row(1) = z.normalized().cross(x);
  return frame;
}

ElementVector stiffness_product(const BeamProperties &properties, const ElementFrame &frame,
                                const ElementVector &u) {
  const double length = frame.length;
  const Vector3 stretch = frame.axes * (u.segment<3>(6) - u.segment<3>(0));
  const Vector3 first = frame.axes * u.segment<3>(3);
  const Vector3 second = frame.axes * u.segment<3>(9);
  const double chord_y = -stretch[2] / length; // rotation of the chord about local y
  const double chord_z = stretch[1] / length;

  const EndMoments y =
      end_moments(properties.bending_stiffness_y, length, first[1] - chord_y, second[1] - chord_y);
  const EndMoments z =
      end_moments(properties.bending_stiffness_z, length, first[2] - chord_z, second[2] - chord_z);
  const double twist = properties.torsional_stiffness / length * (second[0] - first[0]);
  const Vector3 end_force(properties.axial_stiffness / length * stretch[0],
                          -(z.first + z.second) / length, (y.first + y.second) / length);

  const Eigen::Matrix3d to_global = frame.axes.transpose();
  ElementVector force;
  force.segment<3>(6) = to_global * end_force;
  force.segment<3>(0) = -force.segment<3>(6);
  force.segment<3>(3) = to_global * Vector3(-twist, y.first, z.first);
  force.segment<3>(9) = to_global * Vector3(twist, y.second, z.second);
  return force;
}

ElementMatrix stiffness_matrix(const BeamProperties &properties, const ElementFrame &frame) {
  ElementMatrix stiffness;
  for (int j = 0; j < 12; ++j)
    stiffness.col(j) = stiffness_product(properties, frame, ElementVector::Unit(j));
  return (stiffness + stiffness.transpose()) / 2;
}

ElementMatrix mass_matrix(const BeamProperties &properties, const ElementFrame &frame) {
  ElementMatrix local = ElementMatrix::Zero();
  add_linear_mass(local, 0, properties.mass_per_length * frame.length);
  add_linear_mass(local, 3, properties.polar_inertia * frame.length);
  add_plane_mass(local, plane_xy, properties.mass_per_length, frame.length);
  add_plane_mass(local, plane_xz, properties.mass_per_length, frame.length);
  ElementMatrix rotation = ElementMatrix::Zero();
  for (int block = 0; block < 4; ++block)
    rotation.block<3, 3>(3 * block, 3 * block) = frame.axes;
  const ElementMatrix mass = rotation.transpose() * local * rotation;
  return (mass + mass.transpose()) / 2;
}

FrameElement::FrameElement(const std::array<int, 2> &nodes, const BeamProperties &properties,
                           const ElementFrame &frame, const Vector3 &offset,
                           std::shared_ptr<const SectionPlaces> places)
    : nodes_(nodes), properties_(properties), frame_(frame), offset_(offset),
      places_(std::move(places)) {}

ElementMatrix FrameElement::link() const {
  ElementMatrix link = ElementMatrix::Identity();
  for (const int node : {0, 6})
    for (int axis = 0; axis < 3; ++axis)
      link.block<3, 1>(node, node + 3 + axis) = Vector3::Unit(axis).cross(offset_);
  return link;
}

NodalMatrix FrameElement::stiffness() const {
  return link().transpose() * stiffness_matrix(properties_, frame_) * link();
}

// The section faces along x at the second node, against it at the first.
Matrix FrameElement::stress(int node) const {
  if (!places_)
    return {};
  const std::vector<Fibre> &fibres = places_->fibres;
  const double face = node == 0 ? -1 : 1;
  const ElementMatrix forces = stiffness_matrix(properties_, frame_) * link();
  const Eigen::Matrix<double, 3, 12> force = face * frame_.axes * forces.middleRows<3>(6 * node);
  const Eigen::Matrix<double, 3, 12> moment =
      face * frame_.axes * forces.middleRows<3>(6 * node + 3);
  Matrix rows = Matrix::Zero(3 * static_cast<Index>(fibres.size()), 12);
  for (std::size_t i = 0; i < fibres.size(); ++i) {
    const Fibre &fibre = fibres[i];
    rows.row(static_cast<Index>(3 * i)) = fibre.by_axial_force * force.row(0) +
                                          fibre.by_moment_y * moment.row(1) +
                                          fibre.by_moment_z * moment.row(2);
    rows.row(static_cast<Index>(3 * i + 2)) = fibre.by_torque * moment.row(0);
  }
  return rows;
}

Matrix FrameElement::outline() const {
  if (!places_)
    return {};
  Matrix around(3, static_cast<Index>(places_->outline.size()));
  for (Index i = 0; i < around.cols(); ++i) {
    const Eigen::Vector2d &place = places_->outline[static_cast<std::size_t>(i)];
    around.col(i) = offset_ + frame_.axes.transpose() * Vector3(0, place.x(), place.y());
  }
  return around;
}

NodalMatrix FrameElement::mass() const {
  return link().transpose() * mass_matrix(properties_, frame_) * link();
}

NodalMatrix FrameElement::force(const Eigen::Ref<const Matrix> & /*stiffness*/,
                                const NodalMatrix &u) const {
  NodalMatrix forces(u.rows(), u.cols());
  for (Index j = 0; j < u.cols(); ++j)
    if (offset_.isZero(0))
      forces.col(j) = stiffness_product(properties_, frame_, u.col(j));
    else
      forces.col(j) =
          link().transpose() * stiffness_product(properties_, frame_, link() * u.col(j));
  return forces;
}

} // namespace vibroimpact::structure
