#include "structure/cross_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::structure {

namespace {

using std::numbers::pi;

double positive(const std::string &key, double value) {
  if (!(value > 0))
    throw DefinitionError("Section", "", key, "must be given and greater than 0 for this shape");
  return value;
}

/// 1 - tanh(n pi a / 2b), a >= b: below 1e-17 from n = 13 on.
double tail(int n, double a, double b) { return 2 / (std::exp(n * pi * a / b) + 1); }

// Prandtl's stress function of a rectangle a >= b as a Fourier series (Timoshenko and Goodier,
// Theory of Elasticity, section 109):
//   J = a b^3 / 3 (1 - 192 b / (pi^5 a) sum over odd n of tanh(n pi a / 2b) / n^5)
// The sum of 1 / n^5 over odd n is 31/32 zeta(5).
double rectangle_torsion_constant(double width, double thickness) {
  const double a = std::max(width, thickness);
  const double b = std::min(width, thickness);
  double sum = 31.0 / 32 * 1.0369277551433699;
  for (int n = 13; n >= 1; n -= 2)
    sum -= tail(n, a, b) / std::pow(n, 5);
  return a * b * b * b / 3 * (1 - 192 * b / (std::pow(pi, 5) * a) * sum);
}

CrossSection rectangle(const SectionShape &shape) {
  const double width = positive("Width", shape.width);
  const double thickness = positive("Thickness", shape.thickness);
  return {width * thickness, width * std::pow(thickness, 3) / 12,
          thickness * std::pow(width, 3) / 12, rectangle_torsion_constant(width, thickness)};
}

CrossSection ring(double outer_radius, double inner_radius) {
  const double moment = pi / 4 * (std::pow(outer_radius, 4) - std::pow(inner_radius, 4));
  const double area = pi * (outer_radius * outer_radius - inner_radius * inner_radius);
  return {area, moment, moment, 2 * moment};
}

CrossSection tube(const SectionShape &shape) {
  const double radius = positive("Diameter", shape.diameter) / 2;
  const double wall = positive("Wall thickness", shape.wall_thickness);
  if (wall > radius)
    throw DefinitionError("Section", "", "Wall thickness",
                          "must not exceed the radius of the tube, half its Diameter");
  return ring(radius, radius - wall);
}

CrossSection given(const SectionShape &shape) {
  return {positive("Area", shape.area), positive("Second moment y", shape.second_moment_y),
          positive("Second moment z", shape.second_moment_z),
          positive("Torsion constant", shape.torsion_constant)};
}

} // namespace

CrossSection cross_section(const SectionShape &shape) {
  switch (shape.kind) {
  case SectionShape::Kind::rectangle:
    return rectangle(shape);
  case SectionShape::Kind::circle:
    return ring(positive("Diameter", shape.diameter) / 2, 0);
  case SectionShape::Kind::tube:
    return tube(shape);
  case SectionShape::Kind::given:
    return given(shape);
  }
  throw std::logic_error("unknown cross-section shape");
}

bool tapered(const SectionShape &shape) {
  return shape.end_width > 0 || shape.end_thickness > 0 || shape.end_diameter > 0 ||
         shape.end_wall_thickness > 0;
}

SectionShape shape_at(const SectionShape &shape, double along) {
  const auto between = [&](double start, double end) {
    return end > 0 ? (1 - along) * start + along * end : start;
  };
  SectionShape local = shape;
  local.width = between(shape.width, shape.end_width);
  local.thickness = between(shape.thickness, shape.end_thickness);
  local.diameter = between(shape.diameter, shape.end_diameter);
  local.wall_thickness = between(shape.wall_thickness, shape.end_wall_thickness);
  local.end_width = local.end_thickness = local.end_diameter = local.end_wall_thickness = 0;
  return local;
}

namespace {

// Cowper, The shear coefficient in Timoshenko's beam theory (1966), of a ring with the ratio m of
// its inner to its outer radius:
//   6 (1 + nu) (1 + m^2)^2 / ((7 + 6 nu) (1 + m^2)^2 + (20 + 12 nu) m^2)
double cowper_ring(double ratio, double nu) {
  const double m = ratio * ratio;
  const double square = (1 + m) * (1 + m);
  return 6 * (1 + nu) * square / ((7 + 6 * nu) * square + (20 + 12 * nu) * m);
}

double cowper(const SectionShape &shape, double nu) {
  switch (shape.kind) {
  case SectionShape::Kind::rectangle:
    return 10 * (1 + nu) / (12 + 11 * nu);
  case SectionShape::Kind::circle:
    return cowper_ring(0, nu);
  case SectionShape::Kind::tube:
    return cowper_ring(1 - 2 * shape.wall_thickness / shape.diameter, nu);
  case SectionShape::Kind::given:
    throw DefinitionError("Section", "", "Shear correction",
                          "must be set when Shape = given and Theory = Timoshenko");
  }
  throw std::logic_error("unknown cross-section shape");
}

} // namespace

std::array<double, 2> shear_correction(const SectionShape &shape, double poisson_ratio) {
  if (shape.shear_correction[0] > 0)
    return shape.shear_correction;
  const double factor = cowper(shape, poisson_ratio);
  return {factor, factor};
}

namespace {

Fibre fibre(const CrossSection &section, double y, double z, double by_torque) {
  return {1 / section.area, z / section.second_moment_y, -y / section.second_moment_z, by_torque};
}

// Shear stress in the middle of the sides of a rectangle a >= b, by the same series as its torsion
// constant, as a fraction of b times torque / torsion constant.
double middle_of_long_side(double a, double b) {
  double sum = 0;
  for (int n = 201; n >= 1; n -= 2)
    sum += 1 / (n * n * std::cosh(std::min(n * pi * a / (2 * b), 700.0)));
  return 1 - 8 / (pi * pi) * sum;
}
// The sum of +-1 / n^2 over odd n is Catalan's constant.
double middle_of_short_side(double a, double b) {
  double sum = 0.91596559417721902;
  for (int n = 13; n >= 1; n -= 2)
    sum -= (n % 4 == 1 ? 1 : -1) * tail(n, a, b) / (n * n);
  return 8 / (pi * pi) * sum;
}

std::vector<Fibre> fibres_of_rectangle(const SectionShape &shape) {
  const CrossSection section = cross_section(shape);
  const double y = shape.width / 2;
  const double z = shape.thickness / 2;
  const double a = 2 * std::max(y, z);
  const double b = 2 * std::min(y, z);
  const double long_side = b * middle_of_long_side(a, b) / section.torsion_constant;
  const double short_side = b * middle_of_short_side(a, b) / section.torsion_constant;
  std::vector<Fibre> fibres;
  for (const double side : {-1.0, 1.0}) {
    fibres.push_back(fibre(section, side * y, z, 0));
    fibres.push_back(fibre(section, side * y, -z, 0));
    fibres.push_back(fibre(section, side * y, 0, y < z ? long_side : short_side));
    fibres.push_back(fibre(section, 0, side * z, y < z ? short_side : long_side));
  }
  return fibres;
}

std::vector<Fibre> fibres_of_ring(const SectionShape &shape) {
  constexpr int count = 32;
  const CrossSection section = cross_section(shape);
  const double radius = shape.diameter / 2;
  std::vector<Fibre> fibres;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    fibres.push_back(fibre(section, radius * std::cos(angle), radius * std::sin(angle),
                           radius / section.torsion_constant));
  }
  return fibres;
}

} // namespace

std::vector<Fibre> extreme_fibres(const SectionShape &shape) {
  if (shape.kind == SectionShape::Kind::rectangle)
    return fibres_of_rectangle(shape);
  if (shape.kind == SectionShape::Kind::given)
    return {};
  return fibres_of_ring(shape);
}

namespace {

std::vector<Eigen::Vector2d> corners(double width, double thickness) {
  const double y = width / 2;
  const double z = thickness / 2;
  return {{-y, -z}, {y, -z}, {y, z}, {-y, z}};
}

std::vector<Eigen::Vector2d> circle(double radius) {
  constexpr int count = 12;
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < count; ++i)
    places.emplace_back(radius * std::cos(2 * pi * i / count),
                        radius * std::sin(2 * pi * i / count));
  return places;
}

} // namespace

std::vector<Eigen::Vector2d> section_outline(const SectionShape &shape) {
  const CrossSection section = cross_section(shape);
  if (shape.kind == SectionShape::Kind::rectangle)
    return corners(shape.width, shape.thickness);
  if (shape.kind == SectionShape::Kind::given) // of a rectangle: I_z / A = width^2 / 12
    return corners(std::sqrt(12 * section.second_moment_z / section.area),
                   std::sqrt(12 * section.second_moment_y / section.area));
  return circle(shape.diameter / 2);
}

} // namespace vibroimpact::structure
