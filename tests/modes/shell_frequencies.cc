// Natural frequencies of plates and shells against closed forms and public cases.
#include "modes/solve_shell.h"
#include "structure/shell_benchmarks.h"
#include "structure/shell_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <sstream>

namespace shell_frequencies_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

constexpr std::array both = {CellShape::quadrilateral, CellShape::triangle};

// pi^2 (m^2 + n^2) of a simply supported square, ascending.
std::vector<double> navier(int count) {
  std::vector<double> values;
  for (int m = 1; m < 20; ++m)
    for (int n = 1; n < 20; ++n)
      values.push_back(M_PI * M_PI * (m * m + n * n));
  std::sort(values.begin(), values.end());
  values.resize(count);
  return values;
}

// Relative errors of the first modes of the simply supported plate.
Vector plate_errors(int elements, int count, CellShape shape) {
  const Vector found = frequencies(simply_supported_plate(elements, shape), count);
  const double scale = plate_frequency_scale(square_plate(1)) / (2 * M_PI);
  Vector errors(count);
  for (int j = 0; j < count; ++j)
    errors[j] = found[j] / (scale * navier(count)[j]) - 1;
  return errors;
}

// Strip along x, 1 x 0.1 x 0.01, clamped at x = 0, without Poisson effect.
ShellDefinition strip(int along, int across, CellShape shape) {
  ShellDefinition shell;
  shell.plate = structure::Plate{.corner = {0, 0, 0},
                                 .first_end = {1, 0, 0},
                                 .second_end = {0, 0.1, 0},
                                 .elements = {along, across},
                                 .shape = shape};
  shell.parts.push_back({"strip", "all", 0.01, {200e9, 0, 8000}});
  shell.supports.push_back({"root", {"left", {}}, hold_all, {}});
  return shell;
}

// The mesh as a Gmsh file with its nodes in another order, its cells backwards and from other
// corners on; 7 and the number of nodes must have no common factor.
std::string renumbered(const structure::Mesh &mesh) {
  const auto number = [&](int node) {
    return (7 * static_cast<std::size_t>(node) + 3) % mesh.nodes.size() + 1;
  };
  std::ostringstream text;
  text.precision(17);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"left\"\n"
       << "$EndPhysicalNames\n$Nodes\n"
       << mesh.nodes.size() << "\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    text << number(static_cast<int>(node)) << " " << mesh.nodes[node].transpose() << "\n";
  const std::vector<int> &left = mesh.line_groups.at("left");
  text << "$EndNodes\n$Elements\n" << mesh.cells.size() + left.size() << "\n";
  int element = 0;
  for (const int line : left)
    text << ++element << " 1 2 1 1 " << number(mesh.lines[line][0]) << " "
         << number(mesh.lines[line][1]) << "\n";
  for (auto surface = mesh.cells.rbegin(); surface != mesh.cells.rend(); ++surface) {
    text << ++element << (surface->size == 3 ? " 2 2 0 1" : " 3 2 0 1");
    for (int i = surface->size; i > 0; --i)
      text << " " << number(surface->corners[(i + element) % surface->size]);
    text << "\n";
  }
  text << "$EndElements\n";
  return text.str();
}

} // namespace

void expect_same(const Vector &frequencies, const Vector &expected) {
  for (Index j = 0; j < expected.size(); ++j)
    EXPECT_NEAR(frequencies[j] / expected[j], 1, 1e-9) << j;
}

TEST(ShellFrequencies, SimplySupportedPlateConvergesWithOrderTwo) {
  for (const CellShape shape : both) {
    const Vector coarse = plate_errors(8, 4, shape);
    const Vector fine = plate_errors(16, 4, shape);
    for (const int j : {0, 3}) // in the others errors of both directions nearly cancel
      EXPECT_NEAR(std::log2(coarse[j] / fine[j]), 2, 0.2) << j;
    EXPECT_LT(plate_errors(24, 7, shape).cwiseAbs().maxCoeff(), 0.01);
  }
}

// A mode that does not exist, or one that is missing, would shift all that follow.
TEST(ShellFrequencies, NoModeIsSpuriousOrMissing) {
  for (const CellShape shape : both) {
    const Vector errors = plate_errors(32, 20, shape);
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 0.02);
  }
}

TEST(ShellFrequencies, FreePlateHasSixRigidModesAndThoseOfFV12) {
  for (const CellShape shape : both) {
    const modes::NormalModes modes = solve_shell(square_plate(16, shape), 12);
    const double scale = plate_frequency_scale(square_plate(1)) / (2 * M_PI);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(modes.eigenvalues[j], 0) << j;
      const double found = std::sqrt(modes.eigenvalues[6 + j]) / (2 * M_PI);
      EXPECT_NEAR(found / free_plate_reference[j], 1, 0.01) << j;
      EXPECT_NEAR(found / (scale * free_plate_series[j]), 1, 0.013) << j;
    }
  }
}

TEST(ShellFrequencies, ClampedThickRhombusOfFV22) {
  for (const CellShape shape : both) {
    const Vector found =
        frequencies(clamped_rhombus(shape == CellShape::triangle ? 48 : 40, shape), 5);
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(found[j] / rhombus_reference[j], 1, 0.01) << j;
  }
}

// Warped and very thin: drilling yields, which must not make modes of its own, and bending without
// stretching is free. Errors fall with the square of the size: half as large elements leave a
// quarter, and the difference is three quarters of the error, which for wave numbers up to that of
// the eighth mode is below 5 %.
TEST(ShellFrequencies, AThinTwistedStripHasNoModeTooManyOrTooHigh) {
  TwistedBeam beam{.along = 24, .across = 4, .thickness = 0.0032, .skewed = true};
  const Vector coarse = frequencies(twisted_beam(beam), 8);
  beam.along = 48;
  beam.across = 8;
  const Vector fine = frequencies(twisted_beam(beam), 8);
  for (Index j = 0; j < fine.size(); ++j) {
    EXPECT_GT(coarse[j] / fine[j], 0.995) << j;
    EXPECT_LT(coarse[j] / fine[j], 1.05) << j;
  }
}

// A strip is a beam: bending across its plane, and within it, where Timoshenko's shear and rotary
// inertia lower the frequency by (b/L)^2 (1.22 + 0.94 E / (k G) ...), some 1.5 %.
TEST(ShellFrequencies, AStripIsABeamInBothPlanes) {
  for (const CellShape shape : both) {
    const Vector found = frequencies(strip(40, 4, shape), 6);
    const double wave = 1.875104068711961;
    const double across = wave * wave * std::sqrt(200e9 * 1e-4 / 12 / 8000) / (2 * M_PI);
    const double within = 10 * across;
    EXPECT_NEAR(found[0] / across, 1, 0.003);
    const auto nearest = std::min_element(found.begin(), found.end(), [&](double a, double b) {
      return std::abs(a - 0.985 * within) < std::abs(b - 0.985 * within);
    });
    EXPECT_NEAR(*nearest / within, 0.985, 0.01);
  }
}

TEST(ShellFrequencies, ARotatedBodyHasTheSameFrequencies) {
  for (const CellShape shape : both) {
    ShellDefinition shell = strip(8, 3, shape);
    const Vector straight = frequencies(shell, 8);
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.7, Vector3(1, -2, 3).normalized()).toRotationMatrix();
    shell.plate->first_end = rotation * shell.plate->first_end;
    shell.plate->second_end = rotation * shell.plate->second_end;
    expect_same(frequencies(shell, 8), straight);
  }
}

// Other corners come first, other neighbours before, and the normals look to the other side.
TEST(ShellFrequencies, ARenumberedMeshHasTheSameFrequencies) {
  for (const CellShape shape : both) {
    ShellDefinition shell = strip(7, 4, shape);
    const Vector first = frequencies(shell, 8);
    shell.mesh_content = renumbered(structure::shell_mesh(shell));
    shell.plate.reset();
    expect_same(frequencies(shell, 8), first);
  }
}

// Axial waves of a strip held aside, f = c / 4 L.
TEST(ShellFrequencies, AxialWaves) {
  for (const CellShape shape : both) {
    ShellDefinition shell = strip(40, 1, shape);
    shell.supports.push_back({"axis", {"all", {}}, {false, true, true, true, true, true}, {}});
    EXPECT_NEAR(frequencies(shell, 1)[0] / (5000 / 4.0), 1, 1e-3);
  }
}

} // namespace shell_frequencies_tests
