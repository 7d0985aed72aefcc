#include "structure/rigid_part.h"

#include <Eigen/Dense>

namespace vibroimpact::structure {

namespace {

Vector3 mean(const std::vector<Vector3> &vectors) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3 &vector : vectors)
    sum += vector;
  return sum / static_cast<double>(vectors.size());
}

} // namespace

RigidPart::RigidPart(std::vector<Vector3> positions) : positions_(std::move(positions)) {
  const Vector3 centre = mean(positions_);
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (Vector3 &position : positions_) {
    position -= centre;
    inertia +=
        position.squaredNorm() * Eigen::Matrix3d::Identity() - position * position.transpose();
  }
  inverse_inertia_ = inertia.inverse();
}

NodalMatrix RigidPart::removed_from(const NodalMatrix &u) const {
  NodalMatrix deformations(u.rows(), u.cols());
  for (Index j = 0; j < u.cols(); ++j)
    deformations.col(j) = deformation(u.col(j));
  return deformations;
}

NodalVector RigidPart::deformation(const NodalVector &u) const {
  const auto size = static_cast<int>(positions_.size());
  const Index components = u.size() / size;
  const Vector3 origin = u.head<3>();
  Vector3 shift = Vector3::Zero();
  for (int i = 1; i < size; ++i)
    shift += (u.segment<3>(components * i) - origin) / size;
  Vector3 momentum = Vector3::Zero();
  for (int i = 0; i < size; ++i)
    momentum += positions_[i].cross(u.segment<3>(components * i) - origin - shift);
  const Vector3 rotation = inverse_inertia_ * momentum;
  NodalVector rest(u.size());
  for (int i = 0; i < size; ++i) {
    const Index row = components * i;
    rest.segment<3>(row) = u.segment<3>(row) - origin - shift - rotation.cross(positions_[i]);
    if (components == 6)
      rest.segment<3>(row + 3) = u.segment<3>(row + 3) - rotation;
  }
  return rest;
}

} // namespace vibroimpact::structure
