#include "structure/shell_element.h"

#include <Eigen/Dense>

namespace vibroimpact::structure {

ShellElement::ShellElement(std::vector<int> nodes, std::vector<Vector3> positions,
                           const ShellProperties &properties)
    : nodes_(std::move(nodes)), rigid_(std::move(positions)), properties_(properties) {}

NodalMatrix ShellElement::force(const Eigen::Ref<const Matrix> &stiffness,
                                const NodalMatrix &u) const {
  // too small for packed copies to pay
  return stiffness.lazyProduct(rigid_.removed_from(u));
}

Matrix ShellElement::surface_stress(const Eigen::Matrix<double, 3, 24> &strain,
                                    const Eigen::Matrix<double, 3, 24> &curvature) const {
  const Index columns = 6 * static_cast<Index>(positions().size());
  const Eigen::Matrix3d modulus = properties_.membrane_stiffness / properties_.thickness;
  const Matrix membrane = modulus * strain.leftCols(columns);
  const Matrix bending = properties_.thickness / 2 * modulus * curvature.leftCols(columns);
  Matrix stress(6, columns);
  stress << membrane + bending, membrane - bending;
  return stress;
}

void ShellElement::add_mass(const Eigen::Vector4d &shapes, const Eigen::Vector4d &bows, double area,
                            NodalMatrix &mass) const {
  const auto size = static_cast<int>(positions().size());
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 24> displacement(3, 6 * size);
  displacement.setZero();
  for (int i = 0; i < size; ++i) {
    displacement.block<3, 3>(0, 6 * i).diagonal().setConstant(shapes[i]);
    const int next = (i + 1) % size;
    const Vector3 edge = positions()[next] - positions()[i];
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
