// Natural frequencies and static solutions of solids against closed forms, a public case, and the
// same mesh in CalculiX 2.20.
#include "common/decompositions.h"
#include "modes/solve_beam.h"
#include "modes/static_solution.h"
#include "structure/solid_examples.h"

#include <gtest/gtest.h>

namespace solid_frequencies_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

using Sizes = std::array<int, 3>;

constexpr std::array<bool, 6> clamped = {true, true, true, true, true, true};

/// [Hz]
Vector solid_frequencies(const SolidDefinition &solid, int number) {
  const structure::AssembledBody body =
      structure::assemble(structure::build_solid(solid), MPI_COMM_WORLD);
  return modes::normal_modes(eigen_problem(body), {number, {}}).eigenvalues.array().sqrt() /
         (2 * M_PI);
}

/// 1 m along x, 80 mm along y, 50 mm along z, of steel.
SolidDefinition cantilever(const Sizes &elements, double poisson_ratio) {
  SolidDefinition solid = solid_block({1, 0.08, 0.05}, elements, {2.1e11, poisson_ratio, 7850});
  hold(solid, "left", clamped);
  return solid;
}

/// 10 m square, 1 m thick, of NAFEMS FV52.
SolidDefinition thick_plate(const Sizes &elements) {
  return solid_block({10, 10, 1}, elements, {200e9, 0.3, 8000});
}

/// Of the equations of elasticity across a thick plate of unit thickness whose sides hold w and the
/// displacement along them: u, v, w, t_xz / G, t_yz / G, s_z / G vary as cos ax sin by, sin ax cos
/// by, sin ax sin by and so on, and as the exponential of this matrix times z. `l`: Lame's constant
/// over G; `square`: omega^2 rho / G.
Eigen::Matrix<double, 6, 6> across_plate(double a, double b, double l, double square) {
  const double c = l + 2;
  Eigen::Matrix<double, 6, 6> rate = Eigen::Matrix<double, 6, 6>::Zero();
  rate.row(0) << 0, 0, -a, 1, 0, 0;
  rate.row(1) << 0, 0, -b, 0, 1, 0;
  rate.row(2) << l * a / c, l * b / c, 0, 0, 0, 1 / c;
  rate.row(3) << c * a * a + b * b - square, (l + 1) * a * b, 0, 0, 0, 0;
  rate.row(4) << (l + 1) * a * b, c * b * b + a * a - square, 0, 0, 0, 0;
  rate.row(5) << 0, 0, -square, a, b, 0;
  rate.row(3) -= l * a * rate.row(2);
  rate.row(4) -= l * b * rate.row(2);
  return rate;
}

/// The lowest frequency of m and n half waves [Hz]: no traction on both faces.
double exact_plate(int m, int n) {
  const double speed = std::sqrt(200e9 / 2.6 / 8000);
  const auto traction = [&](double hertz) {
    const Eigen::Matrix<double, 6, 6> over = exponential(across_plate(
        m * M_PI / 10, n * M_PI / 10, 0.6 / 0.4, std::pow(2 * M_PI * hertz / speed, 2)));
    return over.bottomLeftCorner<3, 3>().determinant();
  };
  return zeros(traction, 1, 1)[0];
}

} // namespace

// Without Poisson effect: waves along the bar, sqrt(E / rho) / (4 L), too high by (k h)^2 / 24;
// bending, Euler and Bernoulli less shear and rotary inertia to the first order; twist, with
// Saint-Venant's constant J = 0.20375 h b^3 for b = 5/8 h. Four elements across resist warping too
// much, by 3 % of the frequency of twist, two by 9 %, eight by 1 %; the clamped end holds it too.
TEST(SolidFrequencies, CantileverAgainstClosedForms) {
  const Vector found = solid_frequencies(cantilever({40, 4, 4}, 0), 8);
  const double speed = std::sqrt(2.1e11 / 7850);
  const auto bending = [&](double root, double depth) {
    const double slope = std::pow(root, 2) * depth * depth / 12; // (beta r)^2
    return root * root * speed * depth / std::sqrt(12) / (2 * M_PI) *
           (1 - slope / 2 * (1 + 2 * 6.0 / 5));
  };
  EXPECT_NEAR(found[0] / bending(1.8751041, 0.05), 1, 2e-3);
  EXPECT_NEAR(found[1] / bending(1.8751041, 0.08), 1, 3e-3);
  EXPECT_NEAR(found[2] / bending(4.6940911, 0.05), 1, 4e-3);
  const double polar = 0.08 * 0.05 * (0.08 * 0.08 + 0.05 * 0.05) / 12;
  const double twist = 0.20375 * 0.08 * std::pow(0.05, 3);
  EXPECT_NEAR(found[5] / (speed * std::sqrt(twist / (2 * polar)) / 4), 1.03, 3e-3);
  EXPECT_NEAR(found[7] / (speed / 4), 1 + std::pow(M_PI / 80, 2) / 24, 1e-6);
}

// C3D8I of CalculiX keeps the internal displacements of an element as unknowns with inertia, where
// they are static here: the stiffness is the same to rounding, and frequencies differ by the order
// of (omega / omega_internal)^2, which falls with the square of the element size. (ccx 2.20,
// *FREQUENCY, node for node the same mesh.)
TEST(SolidFrequencies, AreThoseOfTheSameElementsInCalculix) {
  const Vector coarse =
      (Vector(8) << 42.04315, 67.02041, 261.6084, 410.2382, 724.1305, 724.8417, 1109.17, 1297.405)
          .finished();
  const Vector fine =
      (Vector(8) << 41.92854, 66.82245, 260.0442, 407.4849, 685.3172, 716.6849, 1096.047, 1296.325)
          .finished();
  const Vector difference =
      solid_frequencies(cantilever({20, 2, 2}, 0.3), 8).array() / coarse.array() - 1;
  const Vector finer = solid_frequencies(cantilever({40, 4, 4}, 0.3), 8).array() / fine.array() - 1;
  EXPECT_GT(difference.minCoeff(), 0); // static displacements are a constraint
  EXPECT_LT(difference.maxCoeff(), 1e-3);
  EXPECT_LT(finer.maxCoeff(), 3e-4);
  EXPECT_NEAR(std::log2(difference[7] / finer[7]), 2, 0.1);
  EXPECT_LT(difference.head(2).maxCoeff(), 1e-5);
}

// The three-dimensional closed form of the thick plate whose sides hold w and the displacement
// along them. Two modes of shear within the plane stand between the bending modes.
TEST(SolidFrequencies, ThickPlateHeldAtItsSidesAgainstElasticity) {
  const std::array<std::array<int, 2>, 4> waves = {{{1, 1}, {1, 2}, {2, 1}, {2, 2}}};
  const std::array<int, 4> modes = {0, 1, 2, 5};
  const auto largest_error = [&](const Sizes &elements) {
    SolidDefinition solid = thick_plate(elements);
    for (const char *side : {"left", "right"})
      hold(solid, side, {false, true, true, false, false, false});
    for (const char *side : {"bottom", "top"})
      hold(solid, side, {true, false, true, false, false, false});
    const Vector found = solid_frequencies(solid, 6);
    double largest = 0;
    for (std::size_t i = 0; i < waves.size(); ++i)
      largest =
          std::max(largest, std::abs(found[modes[i]] / exact_plate(waves[i][0], waves[i][1]) - 1));
    return largest;
  };
  EXPECT_NEAR(exact_plate(1, 1), 45.97121156, 1e-7);
  EXPECT_LT(largest_error({8, 8, 2}), 1.0e-2);
  EXPECT_LT(largest_error({16, 16, 4}), 4e-3);
}

// The references are those of a plate held at its middle surface. Held at its lower edges it is
// softer, and a line that is held gives way without limit as elements become smaller: modes 4 to 7
// are 1.6 to 4.8 % below on this mesh of the benchmark and 4 to 7 % on 24 x 24 x 4.
TEST(SolidFrequencies, ThickPlateOfFV52) {
  SolidDefinition solid = thick_plate({8, 8, 3});
  for (const char *edge : {"left back", "right back", "bottom back", "top back"})
    hold(solid, edge, {false, false, true, false, false, false});
  const Vector found = solid_frequencies(solid, 10);
  EXPECT_LT(found.head(3).maxCoeff(), 1e-2) << "three rigid motions within the plane";
  const Vector reference =
      (Vector(7) << 45.897, 109.44, 109.44, 167.89, 193.59, 206.19, 206.19).finished();
  const Vector error = found.tail(7).array() / reference.array() - 1;
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 0.048);
  EXPECT_LT(error.tail(3).cwiseAbs().maxCoeff(), 0.012);
}

// A bar that a force stretches and a moment on a rigid end bends: F L / E A, M L^2 / 2 E I. The
// nodes of the rigid face turn together, those of the bar have no rotations.
TEST(SolidFrequencies, ARigidFaceTakesMoments) {
  SolidDefinition solid = cantilever({20, 2, 2}, 0);
  solid.links.push_back({.name = "head", .groups = {"right"}});
  solid.points.push_back({.name = "tip", .at = {"", Vector3(1, 0.04, 0.025)}});
  solid.loads.push_back({.name = "pull",
                         .at = {"", Vector3(1, 0.04, 0.025)},
                         .force = {1000, 0, 0},
                         .moment = {0, 0, 500}});
  const structure::AssembledBody body =
      structure::assemble(structure::build_solid(solid), MPI_COMM_WORLD);
  EXPECT_EQ(body.free.size, 3 * 19 * 9 + 6);
  const Matrix moved = modes::static_solution(eigen_problem(body), body.load);
  const auto at_tip = [&](int component) {
    double sum = 0;
    for (const auto &[dof, factor] : body.free.terms(body.model.points[0].node, component))
      sum += factor * moved(dof, 0);
    return sum;
  };
  EXPECT_NEAR(at_tip(0), 1000 / (2.1e11 * 0.004), 1e-18);
  const double curvature = 500 / (2.1e11 * 0.05 * std::pow(0.08, 3) / 12);
  EXPECT_NEAR(at_tip(5), curvature, 1e-12 * curvature);
  EXPECT_NEAR(at_tip(1), curvature / 2, 1e-12 * curvature);
}

} // namespace solid_frequencies_tests
