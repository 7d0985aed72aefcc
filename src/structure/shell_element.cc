#include "structure/shell_element.h"

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

ShellElement::ShellElement(std::vector<int> nodes, std::vector<Vector3> positions,
                           const ShellProperties &properties)
    : nodes_(std::move(nodes)), positions_(std::move(positions)), properties_(properties) {
  const Vector3 centre = mean(positions_);
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (Vector3 &position : positions_) {
    position -= centre;
    inertia +=
        position.squaredNorm() * Eigen::Matrix3d::Identity() - position * position.transpose();
  }
  inverse_inertia_ = inertia.inverse();
}

// Mean displacement and mean rotation of the nodes are taken out before the large entries of the
// matrix multiply what is left.
NodalMatrix ShellElement::force(const Eigen::Ref<const Matrix> &stiffness,
                                const NodalMatrix &u) const {
  NodalMatrix deformations(u.rows(), u.cols());
  for (Index j = 0; j < u.cols(); ++j)
    deformations.col(j) = deformation(u.col(j));
  return stiffness.lazyProduct(deformations); // too small for packed copies to pay
}

// What is left of u without the mean displacement and rotation.
NodalVector ShellElement::deformation(const NodalVector &u) const {
  const auto size = static_cast<int>(positions_.size());
  const Vector3 origin = u.head<3>();
  Vector3 shift = Vector3::Zero();
  for (int i = 1; i < size; ++i)
    shift += (u.segment<3>(6 * i) - origin) / size;
  Vector3 momentum = Vector3::Zero();
  for (int i = 0; i < size; ++i)
    momentum += positions_[i].cross(u.segment<3>(6 * i) - origin - shift);
  const Vector3 rotation = inverse_inertia_ * momentum;
  NodalVector rest(6 * size);
  for (int i = 0; i < size; ++i) {
    rest.segment<3>(6 * i) = u.segment<3>(6 * i) - origin - shift - rotation.cross(positions_[i]);
    rest.segment<3>(6 * i + 3) = u.segment<3>(6 * i + 3) - rotation;
  }
  return rest;
}

Matrix ShellElement::surface_stress(const Eigen::Matrix<double, 3, 24> &strain,
                                    const Eigen::Matrix<double, 3, 24> &curvature) const {
  const Index columns = 6 * static_cast<Index>(positions_.size());
  const Eigen::Matrix3d modulus = properties_.membrane_stiffness / properties_.thickness;
  const Matrix membrane = modulus * strain.leftCols(columns);
  const Matrix bending = properties_.thickness / 2 * modulus * curvature.leftCols(columns);
  Matrix stress(6, columns);
  stress << membrane + bending, membrane - bending;
  return stress;
}

void ShellElement::add_mass(const Eigen::Vector4d &shapes, const Eigen::Vector4d &bows, double area,
                            NodalMatrix &mass) const {
  const auto size = static_cast<int>(positions_.size());
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 24> displacement(3, 6 * size);
  displacement.setZero();
  for (int i = 0; i < size; ++i) {
    displacement.block<3, 3>(0, 6 * i).diagonal().setConstant(shapes[i]);
    const int next = (i + 1) % size;
    const Vector3 edge = positions_[next] - positions_[i];
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 bow = bows[i] / 8 * Vector3::Unit(axis).cross(edge);
      displacement.col(6 * i + 3 + axis) += bow;
      displacement.col(6 * next + 3 + axis) -= bow;
    }
  }
  mass += area * properties_.mass_per_area * displacement.transpose() * displacement;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      mass.block<3, 3>(6 * i + 3, 6 * j + 3).diagonal().array() +=
          area * properties_.rotary_inertia * shapes[i] * shapes[j];
}

} // namespace vibroimpact::structure
