#include "structure/membrane_triangle.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using Eigen::Matrix3d;
using Lumping = Eigen::Matrix<double, 9, 3>;
using RotationFilter = Eigen::Matrix<double, 3, 9>;

// Free parameters of the template at their optimum, in the notation of felippa2003.
constexpr double alpha_b = 1.5;
constexpr std::array<double, 9> beta = {1, 2, 1, 0, 1, -1, -1, -1, -2};
// Of the higher-order stiffness; its optimum (1 - 4 nu^2) / 2 would vanish with incompressibility.
constexpr double least_beta_0 = 0.01;

/// Differences of the coordinates: x(i, j) = x_i - x_j, corners counted from 0.
struct Sides {
  std::array<Eigen::Vector2d, 3> corner;
  double x(int i, int j) const { return corner[i].x() - corner[j].x(); }
  double y(int i, int j) const { return corner[i].y() - corner[j].y(); }
  double square(int i, int j) const { return (corner[i] - corner[j]).squaredNorm(); }
  double area() const { return (y(2, 0) * x(1, 0) - x(2, 0) * y(1, 0)) / 2; }
};

/// Nodal forces of a constant membrane force (N_x, N_y, N_xy).
Lumping lumping(const Sides &s) {
  Lumping l;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    l.row(3 * i) << s.y(j, k), 0, s.x(k, j);
    l.row(3 * i + 1) << 0, s.x(k, j), s.y(j, k);
    l.row(3 * i + 2) << alpha_b / 6 * s.y(j, k) * (s.y(i, k) - s.y(j, i)),
        alpha_b / 6 * s.x(k, j) * (s.x(k, i) - s.x(i, j)),
        alpha_b / 3 * (s.x(k, i) * s.y(i, k) - s.x(i, j) * s.y(j, i));
  }
  return l / 2;
}

/// Corner rotations less the mean rotation of the triangle.
RotationFilter rotation_filter(const Sides &s) {
  RotationFilter filter;
  const double four_areas = 4 * s.area();
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      filter(row, 3 * i) = s.x(k, j) / four_areas;
      filter(row, 3 * i + 1) = s.y(k, j) / four_areas;
      filter(row, 3 * i + 2) = row == i ? 1 : 0;
    }
  return filter;
}

/// Strains along the sides 21, 32, 13 to strains in x and y.
Matrix3d natural_to_cartesian(const Sides &s) {
  Matrix3d t;
  const std::array<std::array<int, 3>, 3> sides = {{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}}};
  for (int column = 0; column < 3; ++column) {
    const auto [j, i, k] = sides[column]; // the side from i to j, the opposite corner k
    t.col(column) << s.y(j, k) * s.y(i, k), s.x(j, k) * s.x(i, k),
        s.y(j, k) * s.x(k, i) + s.x(k, j) * s.y(i, k);
    t.col(column) *= s.square(j, i);
  }
  return t / (4 * s.area() * s.area());
}

/// Natural strains at the corners from the filtered rotations.
std::array<Matrix3d, 3> corner_strains(const Sides &s) {
  const double scale = 2 * s.area() / 3;
  const Eigen::Vector3d inverse = {scale / s.square(1, 0), scale / s.square(2, 1),
                                   scale / s.square(0, 2)};
  const auto b = [](int i) { return beta[i - 1]; };
  Matrix3d first;
  Matrix3d second;
  Matrix3d third;
  first << b(1), b(2), b(3), b(4), b(5), b(6), b(7), b(8), b(9);
  second << b(9), b(7), b(8), b(3), b(1), b(2), b(6), b(4), b(5);
  third << b(5), b(6), b(4), b(8), b(9), b(7), b(2), b(3), b(1);
  return {inverse.asDiagonal() * first, inverse.asDiagonal() * second,
          inverse.asDiagonal() * third};
}

MembraneMatrix higher_order(const Sides &s, const ShellProperties &properties) {
  const double nu = properties.poisson_ratio;
  const double beta_0 = std::max((1 - 4 * nu * nu) / 2, least_beta_0);
  const Matrix3d t = natural_to_cartesian(s);
  const Matrix3d natural = t.transpose() * properties.membrane_stiffness * t;
  const std::array<Matrix3d, 3> q = corner_strains(s);
  Matrix3d rotational = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) { // strains vary linearly: the rule of the three mid-sides
    const Matrix3d middle = (q[i] + q[(i + 1) % 3]) / 2;
    rotational += middle.transpose() * natural * middle;
  }
  const RotationFilter filter = rotation_filter(s);
  return 0.75 * beta_0 * s.area() * filter.transpose() * rotational * filter;
}

} // namespace

MembraneMatrix membrane_triangle(const std::array<Eigen::Vector2d, 3> &corners,
                                 const ShellProperties &properties) {
  const Sides sides{corners};
  const Lumping l = lumping(sides);
  const MembraneMatrix stiffness =
      l * properties.membrane_stiffness * l.transpose() / sides.area() +
      higher_order(sides, properties);
  return (stiffness + stiffness.transpose()) / 2;
}

Eigen::Matrix<double, 3, 9> membrane_strain(const std::array<Eigen::Vector2d, 3> &corners) {
  const Sides sides{corners};
  return lumping(sides).transpose() / sides.area();
}

} // namespace vibroimpact::structure
