// Stresses from the coordinates of reduced bodies against closed forms.
#include "reduction/beam_bodies.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

namespace stress_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

/// Largest von Mises stress at a point.
double von_mises(const ReducedBody &body, const std::string &point, const Vector &q) {
  const Vector stress = body.point(point).stress * q;
  double largest = 0;
  for (Index row = 0; row < stress.size(); row += 3) {
    const double a = stress[row];
    const double b = stress[row + 1];
    const double t = stress[row + 2];
    largest = std::max(largest, std::sqrt(a * a - a * b + b * b + 3 * t * t));
  }
  return largest;
}

/// Clamped at the root, free in space, of 4 elements with all their modes.
ReducedBody clamped(const structure::SectionShape &section) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(2, 0, 0), 4};
  beam.section = section;
  beam.material = {200e9, 0.3, 8000};
  clamp_start(beam);
  beam.points = {{"root", {"start", {}}, 0, Vector3::Zero()},
                 {"middle", {"", Vector3(1, 0, 0)}, 0, Vector3::Zero()},
                 {"tip", {"end", {}}, 0, Vector3::Zero()}};
  return reduced(beam, 24);
}

/// Coordinates under a static unit force (components 0 to 2) or moment (3 to 5) at the tip.
Vector pushed(const ReducedBody &body, Index component) {
  return (body.point("tip").rows.row(component).transpose().array() / body.stiffness.array())
      .matrix();
}

constexpr double width = 0.06;     // along y
constexpr double thickness = 0.02; // along z

structure::SectionShape bar() {
  structure::SectionShape shape;
  shape.kind = structure::SectionShape::Kind::rectangle;
  shape.width = width;
  shape.thickness = thickness;
  return shape;
}

structure::SectionShape shaft(double wall) {
  structure::SectionShape shape;
  shape.kind =
      wall > 0 ? structure::SectionShape::Kind::tube : structure::SectionShape::Kind::circle;
  shape.diameter = 0.05;
  shape.wall_thickness = wall;
  return shape;
}

/// Middle of a simply supported square plate under a uniform pressure of 1 Pa.
double stress_in_the_middle(int elements, CellShape shape) {
  BodyDefinition definition;
  definition.type = BodyDefinition::Type::shell;
  definition.shell = simply_supported_plate(elements, shape);
  definition.shell.points.push_back({"middle", {"", Vector3(5, 5, 0)}, 0, Vector3::Zero()});
  definition.selection.number = 60;
  const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
  const double mass_per_area = 8000 * 0.05;
  const Vector q = (body.base_participation.col(2).array() / body.stiffness.array()).matrix();
  return von_mises(body, "middle", q / mass_per_area);
}

/// Stress of both faces of each shell element, six rows, and the middles of the elements.
struct Faces {
  Matrix stress; // 6 x elements
  Matrix middle; // 3 x elements
};

Faces faces_of(const ReducedBody &body, const Vector &q) {
  const auto &surfaces = body.recovery.cells;
  const Vector stress = body.recovery.cell_stress.rows * q;
  Faces faces{stress.reshaped(6, stress.size() / 6), Matrix::Zero(3, stress.size() / 6)};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const int node : surfaces[i].nodes())
      faces.middle.col(static_cast<Index>(i)) += body.recovery.nodes.col(node) / surfaces[i].size;
  }
  return faces;
}

/// Largest von Mises stress at the first (0) or second end (1) of a line.
double von_mises_of_line(const ReducedBody &body, std::size_t line, Index end, const Vector &q) {
  const CellStress &places = body.recovery.line_stress;
  const Vector stress = places.rows * q;
  const Index half = 3 * (places.first[line + 1] - places.first[line]) / 2;
  const Vector own = stress.segment(3 * places.first[line] + end * half, half);
  double largest = 0;
  for (Index row = 0; row < half; row += 3)
    largest = std::max(largest, std::hypot(own[row], std::sqrt(3) * own[row + 2]));
  return largest;
}

} // namespace

// Along the whole beam: M c / I with M = F (L - x) at both ends of each of the four elements.
TEST(Stress, LinesOfACantileverUnderATipForce) {
  const ReducedBody body = clamped(bar());
  const double modulus = width * thickness * thickness / 6;
  const Vector q = pushed(body, 2);
  ASSERT_EQ(body.recovery.line_stress.first.size(), 5U);
  for (std::size_t line = 0; line < 4; ++line)
    for (const Index end : {0, 1}) {
      const double arm = 2 - 0.5 * static_cast<double>(line + static_cast<std::size_t>(end));
      EXPECT_NEAR(von_mises_of_line(body, line, end, q) * modulus, arm, 1e-6) << line << " " << end;
    }
  EXPECT_TRUE(body.recovery.cell_stress.empty());
}

// M c / I with M = F (L - x), in either plane.
TEST(Stress, CantileverUnderATipForce) {
  const ReducedBody body = clamped(bar());
  for (const Index axis : {1, 2}) {
    const double depth = axis == 1 ? width : thickness;
    const double modulus = width * thickness * depth / 6;
    const Vector q = pushed(body, axis);
    EXPECT_NEAR(von_mises(body, "root", q) * modulus, 2, 1e-6);
    EXPECT_NEAR(von_mises(body, "middle", q) * modulus, 1, 1e-6);
    EXPECT_NEAR(von_mises(body, "tip", q) * modulus, 0, 1e-6);
  }
}

TEST(Stress, AForceAlongTheBeamIsSpreadOverItsSection) {
  const ReducedBody body = clamped(bar());
  for (const char *point : {"root", "middle", "tip"})
    EXPECT_NEAR(von_mises(body, point, pushed(body, 0)) * width * thickness, 1, 1e-9) << point;
}

// Both bending moments and the axial force add up in a corner.
TEST(Stress, EverythingAddsUpInACorner) {
  const ReducedBody body = clamped(bar());
  const Vector q = pushed(body, 0) + pushed(body, 1) + pushed(body, 2);
  const double area = width * thickness;
  const double expected = 1 / area + 2 * 6 / (area * width) + 2 * 6 / (area * thickness);
  EXPECT_NEAR(von_mises(body, "root", q) / expected, 1, 1e-6);
}

// tau = T r / J with J = pi / 2 (r^4 - r_i^4); von Mises sqrt(3) tau.
TEST(Stress, TorsionOfShaftsAndTubes) {
  for (const double wall : {0.0, 0.005}) {
    const ReducedBody body = clamped(shaft(wall));
    const double inner = wall > 0 ? 0.025 - wall : 0;
    const double polar = M_PI / 2 * (std::pow(0.025, 4) - std::pow(inner, 4));
    EXPECT_NEAR(von_mises(body, "middle", pushed(body, 3)) * polar / 0.025, std::sqrt(3), 1e-8);
  }
}

// Torsion of rectangles by tables (Timoshenko and Goodier): largest shear stress T / (k a b^2) in
// the middle of the long side, k = 0.267 at a / b = 3; 0.208 for the square.
TEST(Stress, TorsionOfRectangles) {
  EXPECT_NEAR(std::sqrt(3) / von_mises(clamped(bar()), "root", pushed(clamped(bar()), 3)) /
                  (width * thickness * thickness),
              0.267, 5e-4);
  structure::SectionShape square = bar();
  square.width = square.thickness = 0.02;
  const ReducedBody body = clamped(square);
  EXPECT_NEAR(std::sqrt(3) / von_mises(body, "root", pushed(body, 3)) / 8e-6, 0.208, 5e-4);
}

// The bending moments are 0.0479 p a^2 both ways (Timoshenko and Woinowsky-Krieger, nu = 0.3).
TEST(Stress, SimplySupportedPlateUnderPressure) {
  const double expected = 0.0479 * 100 * 6 / (0.05 * 0.05);
  EXPECT_NEAR(stress_in_the_middle(24, CellShape::quadrilateral) / expected, 1, 0.01);
  EXPECT_NEAR(stress_in_the_middle(24, CellShape::triangle) / expected, 1, 0.03);
}

// A strip that is pulled along its axis: s = F / (b t), for any cut of the mesh.
TEST(Stress, PlateInItsOwnPlane) {
  for (const CellShape shape : {CellShape::quadrilateral, CellShape::triangle}) {
    BodyDefinition definition;
    definition.type = BodyDefinition::Type::shell;
    definition.shell.plate = structure::Plate{.first_end = {4, 0, 0}, .second_end = {0, 1, 0}};
    definition.shell.plate->elements = {4, 1};
    definition.shell.plate->shape = shape;
    definition.shell.parts = {{.name = "sheet", .thickness = 0.01, .material = {200e9, 0, 8000}}};
    definition.shell.supports = {{"left", {"left", {}}, {true, true, true, true, true, true}, {}},
                                 {"plane", {"all", {}}, {false, true, true, true, true, true}, {}}};
    definition.shell.points = {{"here", {"", Vector3(2, 1, 0)}, 0, Vector3::Zero()},
                               {"low", {"", Vector3(4, 0, 0)}, 0, Vector3::Zero()},
                               {"high", {"", Vector3(4, 1, 0)}, 0, Vector3::Zero()}};
    definition.selection.number = 8;
    const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
    const Vector both =
        (body.point("low").rows.row(0) + body.point("high").rows.row(0)).transpose();
    const Vector q = (both.array() / body.stiffness.array()).matrix() / 2;
    EXPECT_NEAR(von_mises(body, "here", q) * 0.01, 1, 1e-6);
    const Faces faces = faces_of(body, q);
    ASSERT_EQ(faces.stress.cols(), shape == CellShape::quadrilateral ? 4 : 8);
    for (Index i = 0; i < faces.stress.cols(); ++i)
      for (const Index face : {0, 3}) {
        const auto s = faces.stress.col(i).segment(face, 3); // invariants: axes are the element's
        EXPECT_NEAR((s[0] + s[1]) * 0.01, 1, 1e-6);
        EXPECT_NEAR((s[0] * s[1] - s[2] * s[2]) * 1e-4, 0, 1e-6);
      }
  }
}

// Kirchhoff's plate in its first mode w = sin(pi x / a) sin(pi y / a): on a face
// s_x + s_y = E t / (2 (1 - nu)) (w_xx + w_yy), and the opposite on the other.
TEST(Stress, FacesOfAPlateInItsFirstMode) {
  constexpr int n = 24;
  constexpr double side = 10, thick = 0.05, nu = 0.3, young = 200e9;
  for (const CellShape shape : {CellShape::quadrilateral, CellShape::triangle}) {
    BodyDefinition definition;
    definition.type = BodyDefinition::Type::shell;
    definition.shell = simply_supported_plate(n, shape);
    definition.selection.number = 1;
    const ReducedBody body = reduce(definition, MPI_COMM_WORLD);
    const double height = body.recovery.shapes.reshaped(6, body.recovery.nodes.cols())
                              .row(2)
                              .array()
                              .abs()
                              .maxCoeff(); // in the middle
    const Faces faces = faces_of(body, Vector::Constant(1, 1 / height));
    const double expected = young * thick / (2 * (1 - nu)) * 2 * std::pow(M_PI / side, 2);
    double worst = 0;
    for (Index i = 0; i < faces.stress.cols(); ++i) {
      const Vector3 at = faces.middle.col(i);
      const double form = std::sin(M_PI * at.x() / side) * std::sin(M_PI * at.y() / side);
      const double first = faces.stress.col(i).head(2).sum();
      const double second = faces.stress.col(i).segment(3, 2).sum();
      EXPECT_NEAR(first, -second, 1e-6 * expected);
      worst = std::max(worst, std::abs(std::abs(first) / expected - form));
    }
    EXPECT_LT(worst, shape == CellShape::quadrilateral ? 0.01 : 0.03);
  }
}

} // namespace stress_tests
