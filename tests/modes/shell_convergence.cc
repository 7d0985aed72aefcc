// How the shell elements converge in public cases, with the table of the gallery's page.
#include "modes/solve_shell.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

struct Case {
  const char *name;
  std::vector<int> meshes;
  std::function<Vector(int, CellShape)> ratios; ///< to the references
  double tolerance = 0.01;                      ///< of the finest mesh
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

const std::vector<Case> cases = {
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
    {"twisted beam, within",
     {6, 12, 24},
     [](int n, CellShape shape) {
       return one(static_at_point(twisted_beam(n, n / 6 * 2, 2, shape))[2] /
                  twisted_beam_within_reference);
     }},
    {"twisted beam, across",
     {6, 12, 24},
     [](int n, CellShape shape) {
       return one(static_at_point(twisted_beam(n, n / 6 * 2, 1, shape))[1] /
                  twisted_beam_across_reference);
     }},
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
      EXPECT_LT((found.array() - 1).abs().maxCoeff(), example.tolerance) << example.name;
    }
}
