#include "structure/cross_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cross_section_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;
using std::numbers::pi;
using Kind = SectionShape::Kind;

namespace {

std::string key_of(const SectionShape &shape) {
  try {
    cross_section(shape);
  } catch (const DefinitionError &error) {
    return error.key();
  }
  return "";
}

/// Integral of z^2 over a rectangle around the origin, by the places of its corners.
double second_moment_y(const std::vector<Eigen::Vector2d> &corners) {
  const Eigen::Vector2d diagonal = corners[2] - corners[0];
  return diagonal.x() * std::pow(diagonal.y(), 3) / 12;
}

} // namespace

TEST(CrossSection, RectangleMomentsFollowTheLocalAxes) {
  const CrossSection s = cross_section({.width = 0.03, .thickness = 0.01});
  EXPECT_NEAR(s.area, 3e-4, 1e-18);
  EXPECT_NEAR(s.second_moment_y, 0.03 * 1e-6 / 12, 1e-22);
  EXPECT_NEAR(s.second_moment_z, 0.01 * 2.7e-5 / 12, 1e-22);
}

// Torsion constants J = k a b^3 of rectangles, from the tables of Timoshenko and Goodier.
TEST(CrossSection, RectangleTorsionMatchesTheTables) {
  const auto factor = [](double ratio) {
    return cross_section({.width = ratio, .thickness = 1}).torsion_constant / ratio;
  };
  EXPECT_NEAR(factor(1), 0.1406, 5e-5);
  EXPECT_NEAR(factor(2), 0.2287, 5e-5);
  EXPECT_NEAR(factor(5), 0.2913, 5e-5);
  EXPECT_NEAR(factor(1e6), 1.0 / 3, 1e-6);
}

TEST(CrossSection, RectangleTorsionDoesNotDependOnTheOrder) {
  EXPECT_DOUBLE_EQ(cross_section({.width = 2, .thickness = 3}).torsion_constant,
                   cross_section({.width = 3, .thickness = 2}).torsion_constant);
}

TEST(CrossSection, CircleAndTube) {
  const CrossSection circle = cross_section({.kind = Kind::circle, .diameter = 0.2});
  EXPECT_NEAR(circle.area, pi * 0.01, 1e-16);
  EXPECT_NEAR(circle.second_moment_y, pi * 1e-4 / 4, 1e-18);
  EXPECT_NEAR(circle.torsion_constant, pi * 1e-4 / 2, 1e-18);
  const CrossSection tube =
      cross_section({.kind = Kind::tube, .diameter = 0.2, .wall_thickness = 0.05});
  EXPECT_NEAR(tube.area, pi * (0.01 - 0.0025), 1e-16);
  EXPECT_NEAR(tube.second_moment_z, pi / 4 * (1e-4 - 6.25e-6), 1e-18);
  const CrossSection full =
      cross_section({.kind = Kind::tube, .diameter = 0.2, .wall_thickness = 0.1});
  EXPECT_DOUBLE_EQ(full.second_moment_y, circle.second_moment_y);
}

TEST(CrossSection, ImpossibleShapesNameTheKey) {
  EXPECT_EQ(key_of({.width = 1}), "Thickness");
  EXPECT_EQ(key_of({.width = -1, .thickness = 1}), "Width");
  EXPECT_EQ(key_of({.kind = Kind::circle}), "Diameter");
  EXPECT_EQ(key_of({.kind = Kind::tube, .diameter = 1, .wall_thickness = 0.6}), "Wall thickness");
  EXPECT_EQ(key_of({.kind = Kind::given, .area = 1, .second_moment_y = 1}), "Second moment z");
}

// J of a square is 0.1406 a^4, the largest shear stress T / (0.208 a^3) [Timoshenko and Goodier,
// table of section 109], in the middle of all sides: the two series for these agree.
TEST(CrossSection, TorsionOfASquare) {
  const SectionShape square{.width = 0.1, .thickness = 0.1};
  EXPECT_NEAR(cross_section(square).torsion_constant / 1e-4, 0.1406, 5e-5);
  double largest = 0;
  double other = 1e9;
  for (const Fibre &fibre : extreme_fibres(square))
    if (fibre.by_torque > 0) {
      largest = std::max(largest, fibre.by_torque);
      other = std::min(other, fibre.by_torque);
    }
  EXPECT_NEAR(largest / other, 1, 1e-12);
  EXPECT_NEAR(1 / largest / 1e-3, 0.208, 5e-4);
}

TEST(CrossSection, DimensionsOfATaperedBeamChangeLinearly) {
  const SectionShape shape{.width = 0.1, .thickness = 0.2, .end_thickness = 0.1};
  EXPECT_TRUE(tapered(shape));
  const SectionShape quarter = shape_at(shape, 0.25);
  EXPECT_FALSE(tapered(quarter));
  EXPECT_DOUBLE_EQ(quarter.width, 0.1);
  EXPECT_DOUBLE_EQ(quarter.thickness, 0.175);
}

// Cowper 1966: a rectangle 10 (1 + nu) / (12 + 11 nu), a circle 6 (1 + nu) / (7 + 6 nu), a thin
// tube 2 (1 + nu) / (4 + 3 nu).
TEST(CrossSection, ShearCorrectionIsCowpers) {
  EXPECT_NEAR(shear_correction({.width = 1, .thickness = 2}, 0.3)[0], 13 / 15.3, 1e-15);
  EXPECT_NEAR(shear_correction({.kind = Kind::circle, .diameter = 1}, 0.3)[1], 7.8 / 8.8, 1e-15);
  const SectionShape thin{.kind = Kind::tube, .diameter = 1, .wall_thickness = 1e-6};
  EXPECT_NEAR(shear_correction(thin, 0.3)[0], 2.6 / 4.9, 1e-6);
  const SectionShape full{.kind = Kind::tube, .diameter = 1, .wall_thickness = 0.5};
  EXPECT_NEAR(shear_correction(full, 0.3)[0], 7.8 / 8.8, 1e-15);
  EXPECT_EQ(shear_correction({.shear_correction = {0.4, 0.7}}, 0.3)[1], 0.7);
  EXPECT_THROW(shear_correction({.kind = Kind::given}, 0.3), DefinitionError);
}

TEST(CrossSection, OutlinesHaveTheDimensionsOfTheSection) {
  const SectionShape bar{.width = 0.03, .thickness = 0.01};
  EXPECT_NEAR(second_moment_y(section_outline(bar)), cross_section(bar).second_moment_y, 1e-22);
  for (const SectionShape &round :
       {SectionShape{.kind = Kind::circle, .diameter = 0.2},
        SectionShape{.kind = Kind::tube, .diameter = 0.2, .wall_thickness = 0.01}}) {
    const auto outline = section_outline(round);
    EXPECT_EQ(outline.size(), 12U);
    for (const auto &place : outline)
      EXPECT_NEAR(place.norm(), 0.1, 1e-15);
  }
}

// I_y / A = thickness^2 / 12 and I_z / A = width^2 / 12 of a rectangle.
TEST(CrossSection, ASectionOfConstantsHasTheOutlineOfItsRadiiOfGyration) {
  const auto outline = section_outline({.kind = Kind::given,
                                        .area = 2,
                                        .second_moment_y = 6,
                                        .second_moment_z = 24,
                                        .torsion_constant = 1});
  EXPECT_NEAR(outline[2].x(), 6, 1e-14);
  EXPECT_NEAR(outline[2].y(), 3, 1e-14);
}

} // namespace cross_section_tests
