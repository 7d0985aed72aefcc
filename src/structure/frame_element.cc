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

FrameElement::FrameElement(const std::array<int, 2> &nodes, const PropertiesAlong &properties,
                           const ElementFrame &frame, const Vector3 &offset, EndPlaces places,
                           const Releases &releases)
    : nodes_(nodes), frame_(frame), offset_(offset), places_(std::move(places)),
      matrices_(beam_matrices(properties, frame.length, releases)),
      prestressed_(!matrices_.geometric.isZero(0)) {}

ElementMatrix FrameElement::to_local() const {
  ElementMatrix local = ElementMatrix::Zero();
  for (int block = 0; block < 4; ++block)
    local.block<3, 3>(3 * block, 3 * block) = frame_.axes;
  for (const int end : {0, 6})
    for (int axis = 0; axis < 3; ++axis)
      local.block<3, 1>(end, end + 3 + axis) = frame_.axes * Vector3::Unit(axis).cross(offset_);
  return local;
}

ElementMatrix FrameElement::local_stiffness() const {
  const Eigen::Matrix<double, 6, 12> deformation = deformation_matrix(frame_.length);
  return deformation.transpose() * matrices_.stiffness * deformation + matrices_.geometric;
}

NodalMatrix FrameElement::stiffness() const { return in_nodes(local_stiffness()); }

NodalMatrix FrameElement::mass() const { return in_nodes(matrices_.mass); }

ElementMatrix FrameElement::in_nodes(const ElementMatrix &local) const {
  const ElementMatrix matrix = to_local().transpose() * local * to_local();
  return (matrix + matrix.transpose()) / 2;
}

double FrameElement::total_mass() const { return matrices_.total_mass; }

// From the ends' difference, with the first end as the origin: whatever moves both alike is gone.
ElementVector FrameElement::local_force(const ElementVector &u) const {
  const double length = frame_.length;
  const Vector3 turned = u.segment<3>(9) - u.segment<3>(3);
  const Vector3 stretch = frame_.axes * (u.segment<3>(6) - u.segment<3>(0) + turned.cross(offset_));
  const Vector3 first = frame_.axes * u.segment<3>(3);
  const Vector3 second = frame_.axes * u.segment<3>(9);
  const double chord_y = -stretch[2] / length; // rotation of the chord about local y
  const double chord_z = stretch[1] / length;
  DeformationVector deformation;
  deformation << stretch[0], (frame_.axes * turned)[0], first[1] - chord_y, second[1] - chord_y,
      first[2] - chord_z, second[2] - chord_z;
  ElementVector force =
      deformation_matrix(length).transpose() * (matrices_.stiffness * deformation);
  if (prestressed_) {
    ElementVector relative;
    relative << Vector3::Zero(), first, stretch, second;
    force += matrices_.geometric * relative;
  }
  return force;
}

NodalMatrix FrameElement::force(const Eigen::Ref<const Matrix> & /*stiffness*/,
                                const NodalMatrix &u) const {
  const ElementMatrix local = to_local();
  NodalMatrix forces(u.rows(), u.cols());
  for (Index j = 0; j < u.cols(); ++j)
    forces.col(j) = local.transpose() * local_force(u.col(j));
  return forces;
}

// The section faces along x at the second node, against it at the first. Shear stress follows from
// St Venant's torque, without the part that the axial force has in it.
Matrix FrameElement::stress(int node) const {
  if (!places_[node])
    return {};
  const std::vector<Fibre> &fibres = places_[node]->fibres;
  const double face = node == 0 ? -1 : 1;
  const ElementMatrix forces = face * local_stiffness() * to_local();
  const Eigen::Matrix<double, 6, 12> elastic =
      matrices_.stiffness * deformation_matrix(frame_.length) * to_local();
  const auto end = forces.middleRows<6>(6 * node);
  Matrix rows = Matrix::Zero(3 * static_cast<Index>(fibres.size()), 12);
  for (std::size_t i = 0; i < fibres.size(); ++i) {
    const Fibre &fibre = fibres[i];
    rows.row(static_cast<Index>(3 * i)) = fibre.by_axial_force * end.row(0) +
                                          fibre.by_moment_y * end.row(4) +
                                          fibre.by_moment_z * end.row(5);
    rows.row(static_cast<Index>(3 * i + 2)) = fibre.by_torque * elastic.row(1);
  }
  return rows;
}

// The mean of both ends.
Matrix FrameElement::outline() const {
  if (!places_[0])
    return {};
  const auto &first = places_[0]->outline;
  const auto &second = places_[1]->outline;
  Matrix around(3, static_cast<Index>(first.size()));
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Eigen::Vector2d place = (first[i] + second[i]) / 2;
    around.col(static_cast<Index>(i)) =
        offset_ + frame_.axes.transpose() * Vector3(0, place.x(), place.y());
  }
  return around;
}

} // namespace vibroimpact::structure
