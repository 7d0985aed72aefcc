#include "output/vtu_patches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::output {
namespace vtu_patches_tests {

using reduction::Recovery;

/// A beam element of 2 m along x.
Recovery beam() {
  Recovery recovery;
  recovery.nodes = Matrix::Zero(3, 2);
  recovery.nodes(0, 1) = 2;
  recovery.lines = {{0, 1}};
  return recovery;
}

/// Values of the rows from `first` on, at one point.
std::vector<float> values(const dealii::Table<2, float> &data, unsigned first, unsigned count,
                          unsigned point) {
  std::vector<float> found;
  for (unsigned row = first; row < first + count; ++row)
    found.push_back(data(row, point));
  return found;
}

using Values = std::vector<float>;

TEST(VtuPatches, NamesAndVectorsFollowTheOrderOfTheData) {
  const PointData data{.velocity = true, .contact = true, .von_mises = 3};
  ASSERT_EQ(data.names().size(), data.size());
  EXPECT_EQ(data.names()[7], "velocity");
  EXPECT_EQ(data.names()[15], "contact_state");
  EXPECT_EQ(data.names()[18], "von_mises_stress_second_face");
  ASSERT_EQ(data.vectors().size(), 4U);
  EXPECT_EQ(std::get<0>(data.vectors()[3]), 10U);
  EXPECT_EQ(std::get<1>(data.vectors()[3]), 12U);
  EXPECT_EQ(std::get<2>(data.vectors()[3]), "contact_force");
}

// The second node moves by 1 m along y without turning: y^2 (3 - 2 x) of a cubic with flat ends.
TEST(VtuPatches, VelocityOfABeamIsThatOfItsBendingLine) {
  const Recovery recovery = beam();
  BodyShape shape{.recovery = &recovery, .number = 3, .motion = Vector::Zero(12)};
  shape.velocity = Vector::Zero(12);
  shape.velocity[7] = 1;
  Patches<1> patches;
  add_lines(shape, shape.line_data(), patches);
  for (unsigned i = 0; i <= 4; ++i) {
    const double t = i / 4.0;
    EXPECT_EQ(values(patches[0].data, 6, 1, i), Values{3});
    EXPECT_FLOAT_EQ(patches[0].data(8, i), static_cast<float>(t * t * (3 - 2 * t)));
  }
}

// The same where the shapes know of no rotation.
TEST(VtuPatches, ALineWithoutKnownRotationsStaysStraight) {
  Recovery recovery = beam();
  recovery.shapes = Matrix::Zero(12, 1);
  recovery.shapes(7, 0) = 1;
  const BodyShape shape{.recovery = &recovery, .motion = recovery.shapes.col(0)};
  Patches<1> patches;
  add_lines(shape, shape.line_data(), patches);
  for (unsigned i = 0; i <= 4; ++i)
    EXPECT_FLOAT_EQ(patches[0].data(1, i), static_cast<float>(i) / 4);
}

// Two fibres: bending of +-1 Pa at the first node that vanishes at the second, and a shear stress.
TEST(VtuPatches, StressOfABeamIsLinearAlongItsElements) {
  Recovery recovery = beam();
  recovery.line_stress = {.rows = Matrix::Zero(12, 1), .first = {0, 4}};
  BodyShape shape{.recovery = &recovery, .motion = Vector::Zero(12)};
  shape.line_stress = Vector::Zero(12);
  shape.line_stress[0] = 1;
  shape.line_stress[3] = -1;
  shape.line_stress[2] = shape.line_stress[8] = 0.5; // of the first fibre, at both ends
  Patches<1> patches;
  add_lines(shape, shape.line_data(), patches);
  for (unsigned i = 0; i <= 4; ++i)
    EXPECT_FLOAT_EQ(patches[0].data(7, i),
                    static_cast<float>(std::sqrt(std::pow(1 - i / 4.0, 2) + 0.75)));
}

// The second node turns by 0.1 rad about the beam and moves by 1 m along z: r x (0, y, z) = 0.1 (0,
// -z, y).
TEST(VtuPatches, SidesOfABeamMoveWithItsSections) {
  const Recovery recovery = beam();
  const Matrix outline = (Matrix(3, 3) << 0, 0, 0, -1, 1, 0, -1, -1, 2).finished();
  BodyShape shape{.recovery = &recovery, .number = 2, .motion = Vector::Zero(12)};
  shape.outlines = {outline};
  shape.motion[6 + 2] = 1;
  shape.motion[6 + 3] = 0.1;
  Patches<2> patches;
  add_sections(shape, {}, patches);
  ASSERT_EQ(patches.size(), 3U);
  for (unsigned side = 0; side < 3; ++side)
    for (unsigned corner = 0; corner < 4; ++corner) {
      const Vector3 place = outline.col((side + corner % 2) % 3);
      const auto &vertex = patches[side].vertices[corner];
      EXPECT_EQ(Vector3(vertex[0], vertex[1], vertex[2]),
                place + (corner < 2 ? 0 : 2) * Vector3::UnitX());
      const Values moved = corner < 2 ? Values{0, 0, 0, 0}
                                      : Values{0, static_cast<float>(-0.1 * place.z()),
                                               static_cast<float>(1 + 0.1 * place.y()), 0.1F};
      EXPECT_EQ(values(patches[side].data, 0, 4, corner), moved);
      EXPECT_EQ(values(patches[side].data, 6, 1, corner), Values{2});
    }
}

// Bending of 1 Pa at the first node that vanishes at the second.
TEST(VtuPatches, SidesOfABeamHaveTheStressOfItsEnds) {
  Recovery recovery = beam();
  recovery.line_stress = {.rows = Matrix::Zero(6, 1), .first = {0, 2}};
  BodyShape shape{.recovery = &recovery, .motion = Vector::Zero(12)};
  shape.outlines = {Matrix::Zero(3, 4)};
  shape.line_stress = Vector::Unit(6, 0);
  Patches<2> patches;
  add_sections(shape, shape.line_data(), patches);
  for (unsigned corner = 0; corner < 4; ++corner)
    EXPECT_EQ(values(patches[3].data, 7, 1, corner), Values{corner < 2 ? 1.0F : 0.0F});
}

TEST(VtuPatches, StressOfUnknownSectionsIsNoNumber) {
  Recovery recovery = beam();
  recovery.line_stress.first = {0, 0};
  BodyShape shape{.recovery = &recovery, .motion = Vector::Zero(12)};
  Patches<1> patches;
  add_lines(shape, {.von_mises = 1}, patches);
  EXPECT_TRUE(std::isnan(patches[0].data(7, 2)));
}

// First face: s = (3, 0, 0); second: a pure shear of 2, von Mises 2 sqrt(3).
TEST(VtuPatches, ShellsHaveTheStressOfBothFacesAndTheLarger) {
  Recovery recovery;
  recovery.nodes = Matrix::Zero(3, 3);
  recovery.nodes(0, 1) = recovery.nodes(1, 2) = 1;
  recovery.cells = {structure::cell_of(structure::CellShape::triangle, {0, 1, 2})};
  recovery.cell_stress = {.rows = Matrix::Zero(6, 1), .first = {0, 2}};
  BodyShape shape{.recovery = &recovery, .motion = Vector::Zero(18)};
  shape.cell_stress = (Vector(6) << 3, 0, 0, 0, 0, 2).finished();
  Patches<2> patches;
  add_cells(shape, shape.cell_data(2), patches);
  const auto shear = static_cast<float>(2 * std::sqrt(3));
  for (unsigned corner = 0; corner < 3; ++corner)
    EXPECT_EQ(values(patches[0].data, 7, 3, corner), (Values{shear, 3, shear}));
}

// VTK's hexahedron 12, corners line by line as deal.II has them; s_xx = 3 and a shear s_xy = 2.
TEST(VtuPatches, SolidsHaveAllComponentsOfTheirStress) {
  Recovery recovery;
  recovery.nodes = (Matrix(3, 8) << 0, 1, 1, 0, 0, 1, 1, 0, //
                    0, 0, 1, 1, 0, 0, 1, 1,                 //
                    0, 0, 0, 0, 1, 1, 1, 1)
                       .finished();
  recovery.cells = {structure::cell_of(structure::CellShape::hexahedron, {0, 1, 2, 3, 4, 5, 6, 7})};
  recovery.cell_stress = {.rows = Matrix::Zero(6, 1), .first = {0, 1}, .components = 6};
  BodyShape shape{.recovery = &recovery, .motion = Vector::Zero(48)};
  shape.motion[6 * 2] = 5;
  shape.cell_stress = (Vector(6) << 3, 0, 0, 2, 0, 0).finished();
  const PointData data = shape.cell_data(3);
  EXPECT_EQ(data.names()[7], "von_mises_stress");
  EXPECT_EQ(data.names()[8], "stress_xx");
  EXPECT_EQ(data.names()[13], "stress_zx");
  Patches<3> patches;
  add_cells(shape, data, patches);
  ASSERT_EQ(patches.size(), 1U);
  const auto &third = patches[0].vertices[3]; // node 2
  EXPECT_EQ(Vector3(third[0], third[1], third[2]), Vector3(1, 1, 0));
  EXPECT_EQ(values(patches[0].data, 0, 1, 3), Values{5});
  for (unsigned corner = 0; corner < 8; ++corner)
    EXPECT_EQ(values(patches[0].data, 7, 7, corner),
              (Values{static_cast<float>(std::sqrt(21.0)), 3, 0, 0, 2, 0, 0}));
  shape.largest_stress = true;
  EXPECT_EQ(shape.cell_data(3).size(), 8U);
}

TEST(VtuPatches, VonMisesStressOfPlaneStress) {
  EXPECT_DOUBLE_EQ(largest_von_mises((Vector(3) << 5, 5, 0).finished()), 5);
  EXPECT_DOUBLE_EQ(largest_von_mises((Vector(3) << 5, -5, 0).finished()), 5 * std::sqrt(3));
  EXPECT_DOUBLE_EQ(largest_von_mises((Vector(6) << 0, 0, 1, -4, 0, 0).finished()), 4);
}

TEST(VtuPatches, StopsAreSquaresAcrossTheirNormal) {
  const StopFace face{.place = Vector3(1, 2, 3),
                      .normal = Vector3(0.6, 0, 0.8),
                      .displacement = Vector3(0, 0, 0.5),
                      .contact = Eigen::Matrix<float, 6, 1>::Constant(7)};
  Patches<2> patches;
  add_stop(face, 0.1, patches);
  for (unsigned corner = 0; corner < 4; ++corner) {
    const auto &vertex = patches[0].vertices[corner];
    const Vector3 from = Vector3(vertex[0], vertex[1], vertex[2]) - face.place;
    EXPECT_NEAR(from.dot(face.normal), 0, 1e-15);
    EXPECT_NEAR(from.norm(), 0.1 * std::sqrt(2), 1e-15);
    EXPECT_EQ(values(patches[0].data, 0, 7, corner), (Values{0, 0, 0.5, 0, 0, 0, 0}));
    EXPECT_EQ(values(patches[0].data, 7, 6, corner), Values(6, 7));
  }
}

} // namespace vtu_patches_tests
} // namespace vibroimpact::output
