// How the shell elements converge in public cases, with the table of the gallery's page.
#include "modes/solve_shell.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <optional>

namespace shell_convergence_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

struct Case {
  const char *name;
  std::vector<int> meshes;
  std::function<Vector(int, CellShape)> ratios; ///< to the references
  double tolerance = 0.01;                      ///< of the finest mesh of quadrilaterals
  std::optional<double> triangles = {};         ///< of the finest mesh of triangles, if another
};

Vector one(double value) { return Vector::Constant(1, value); }

/// Rigid-body modes come first; a double mode at the end may have brought its twin.
Vector ratios(const Vector &found, const std::vector<double> &reference, Index rigid = 0) {
  const auto size = static_cast<Index>(reference.size());
  return found.segment(rigid, size).array() /
         Eigen::Map<const Vector>(reference.data(), size).array();
}

std::vector<double> navier() {
  const double scale = plate_frequency_scale(square_plate(1)) * M_PI / 2;
  std::vector<double> values;
  for (const int sum : {2, 5, 5, 8, 10, 10})
    values.push_back(scale * sum);
  return values;
}

std::vector<double> free_series() {
  std::vector<double> values = free_plate_series;
  for (double &value : values)
    value *= plate_frequency_scale(square_plate(1)) / (2 * M_PI);
  return values;
}

Vector twisted(TwistedBeam beam, int along, CellShape shape) {
  beam.along = along;
  beam.across = along / 6;
  beam.shape = shape;
  Vector ratios(2);
  for (const int axis : {2, 1}) {
    beam.axis = axis;
    ratios[2 - axis] = static_at_point(twisted_beam(beam))[axis] / twisted_beam_reference(beam);
  }
  return ratios;
}

/// Triangles on these meshes: s/t is up to 60, and the program warns.
constexpr double locked = 1;

const std::vector<Case> cases = {
    {"twisted beam, t = 0.32",
     {12, 24, 48},
     [](int n, CellShape shape) { return twisted({}, n, shape); }},
    {"twisted beam, t = 0.32, skewed mesh",
     {12, 24, 48},
     [](int n, CellShape shape) { return twisted({.skewed = true}, n, shape); }},
    {"twisted beam, t = 0.0032",
     {12, 24, 48},
     [](int n, CellShape shape) { return twisted({.thickness = 0.0032}, n, shape); },
     0.01,
     locked},
    {"twisted beam, t = 0.0032, skewed mesh",
     {12, 24, 48},
     [](int n, CellShape shape) {
       return twisted({.thickness = 0.0032, .skewed = true}, n, shape);
     },
     0.01,
     locked},
    {"simply supported plate, closed form",
     {8, 16, 32},
     [](int n, CellShape shape) {
       return ratios(frequencies(simply_supported_plate(n, shape), 6), navier());
     }},
    {"free plate FV12, series",
     {8, 16, 32},
     [](int n, CellShape shape) {
       return ratios(frequencies(square_plate(n, shape), 12), free_series(), 6);
     }},
    {"free plate FV12, target",
     {8, 16, 32},
     [](int n, CellShape shape) {
       return ratios(frequencies(square_plate(n, shape), 12), free_plate_reference, 6);
     },
     0.012}, // the targets of modes 4 to 6 lie 1 % above the series
    {"clamped rhombus FV22",
     {16, 32, 48},
     [](int n, CellShape shape) {
       return ratios(frequencies(clamped_rhombus(n, shape), 5), rhombus_reference);
     }},
    {"Scordelis-Lo roof",
     {4, 8, 16, 32},
     [](int n, CellShape shape) {
       return one(static_at_point(scordelis_lo_roof(n, shape))[2] / scordelis_lo_reference);
     }},
    {"pinched cylinder",
     {8, 16, 32, 64},
     [](int n, CellShape shape) {
       return one(static_at_point(pinched_cylinder(n, shape))[2] / pinched_cylinder_reference);
     }},
    {"Raasch's hook",
     {9, 18, 36, 72},
     [](int n, CellShape shape) {
       const int across = n == 9 ? 1 : n == 18 ? 3 : n == 36 ? 5 : 10;
       return one(static_at_point(raasch_hook(n, across, shape))[2] / raasch_hook_reference);
     }},
    {"hypar along lines of curvature",
     {8, 16, 32, 64},
     [](int n, CellShape shape) {
       return one(static_at_point(hypar(n, false, shape))[2] / hypar_reference);
     },
     0.01,
     0.03},
    {"hypar along its straight lines",
     {8, 16, 32, 64},
     [](int n, CellShape shape) {
       return one(static_at_point(hypar(n, true, shape))[2] / hypar_straight_reference);
     },
     0.01,
     0.03},
    {"hemisphere with hole", {8, 16, 32, 64}, [](int n, CellShape shape) {
       return one(static_at_point(hemisphere(n, shape))[0] / hemisphere_reference);
     }}};

void print(const Case &example, CellShape shape, int mesh, const Vector &found) {
  std::printf("| %s | %s | %d |", example.name,
              shape == CellShape::triangle ? "triangles" : "quadrilaterals", mesh);
  for (const double ratio : found)
    std::printf(" %+.2f", 100 * (ratio - 1));
  std::printf(" |\n");
}

} // namespace

TEST(ShellConvergence, ThePublicCasesAreReached) {
  for (const Case &example : cases)
    for (const CellShape shape : {CellShape::quadrilateral, CellShape::triangle}) {
      Vector found;
      for (const int mesh : example.meshes) {
        found = example.ratios(mesh, shape);
        print(example, shape, mesh, found);
      }
      const double tolerance = shape == CellShape::triangle
                                   ? example.triangles.value_or(example.tolerance)
                                   : example.tolerance;
      EXPECT_LT((found.array() - 1).abs().maxCoeff(), tolerance) << example.name;
    }
}

} // namespace shell_convergence_tests
