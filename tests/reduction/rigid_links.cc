// Rigid links against closed forms: arms with masses, rigid ends of beams, rigid frames on skew
// hinges, rigid plates.
#include "common/decompositions.h"
#include "modes/solve_beam.h"
#include "reduction/beam_bodies.h"
#include "structure/shell_examples.h"

#include <gtest/gtest.h>

namespace rigid_links_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

using structure::Member;
using structure::RigidLink;

struct TextLine {
  int first, second; ///< from 1
  int group;
};

/// A mesh file of lines in two groups, 1 "beam" and 2 "arm".
std::string mesh_text(const std::vector<Vector3> &nodes, const std::vector<TextLine> &lines) {
  std::ostringstream text;
  text.precision(17);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"beam\"\n1 2 \"arm\"\n"
          "$EndPhysicalNames\n$Nodes\n"
       << nodes.size() << "\n";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text << i + 1 << " " << nodes[i].transpose() << "\n";
  text << "$EndNodes\n$Elements\n" << lines.size() << "\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    text << i + 1 << " 1 2 " << lines[i].group << " " << lines[i].group << " " << lines[i].first
         << " " << lines[i].second << "\n";
  text << "$EndElements\n";
  return text.str();
}

constexpr structure::Material steel{2e11, 0.3, 8000};

Member massless_arm() {
  Member arm{.name = "arm", .on = "arm"};
  arm.section.width = arm.section.thickness = 0.1;
  arm.material = {2e11, 0.3, 0};
  return arm;
}

/// A beam of 2 m, clamped, whose end carries two arms like a T.
BeamDefinition t_frame(int elements) {
  std::vector<Vector3> nodes;
  std::vector<TextLine> lines;
  for (int i = 0; i <= elements; ++i) {
    nodes.emplace_back(2.0 * i / elements, 0, 0);
    if (i > 0)
      lines.push_back({i, i + 1, 1});
  }
  nodes.emplace_back(2.3, 0.4, -0.2);
  nodes.emplace_back(1.9, -0.5, 0.1);
  lines.push_back({elements + 1, elements + 2, 2});
  lines.push_back({elements + 1, elements + 3, 2});
  BeamDefinition beam;
  beam.mesh_content = mesh_text(nodes, lines);
  beam.section = {.width = 0.06, .thickness = 0.1};
  beam.material = steel;
  beam.members = {massless_arm()};
  beam.supports = {{"root", {"", Vector3::Zero()}, hold_all, {}}};
  beam.links = {{.name = "arms", .members = {"arm"}}};
  return beam;
}

std::vector<double> frequencies(const BeamDefinition &beam, int count) {
  const modes::NormalModes modes = solve_beam(beam, {count, {}});
  std::vector<double> found;
  for (int j = 0; j < count; ++j)
    found.push_back(std::sqrt(modes.eigenvalues[j]) / (2 * M_PI));
  return found;
}

} // namespace

// The same inertia at the same node, by a link in one case and by an offset in the other.
TEST(RigidLinks, AMassAtAnArmIsAMassWithAnOffset) {
  BeamDefinition linked = t_frame(8);
  const Vector3 end(2, 0, 0), first(2.3, 0.4, -0.2), second(1.9, -0.5, 0.1);
  const Vector3 inertia(3, 4, 5);
  linked.points = {{"a", {"", first}, 200, inertia, Vector3(0.2, 0, 0)}, {"b", {"", second}, 90}};
  BeamDefinition plain;
  plain.line = {Vector3::Zero(), end, 8};
  plain.section = linked.section;
  plain.material = steel;
  plain.supports = {{"root", {"start", {}}, hold_all, {}}};
  plain.points = {{"a", {"end", {}}, 200, inertia, Vector3(0.2, 0, 0), first - end},
                  {.name = "b", .at = {"end", {}}, .mass = 90, .offset = second - end}};
  const std::vector<double> by_link = frequencies(linked, 12);
  const std::vector<double> by_offset = frequencies(plain, 12);
  for (std::size_t j = 0; j < by_link.size(); ++j)
    EXPECT_NEAR(by_link[j] / by_offset[j], 1, 1e-10) << j;
}

// x' = theta x arm: what the tips of the arms do follows from the end of the beam.
TEST(RigidLinks, ShapesAndBaseMotionOfLinkedNodes) {
  BeamDefinition beam = t_frame(8);
  beam.points = {{"end", {"", Vector3(2, 0, 0)}, 0}, {"a", {"", Vector3(2.3, 0.4, -0.2)}, 200}};
  const reduction::ReducedBody body = reduced(beam, 48);
  const Matrix &end = body.point("end").rows;
  const Matrix &tip = body.point("a").rows;
  const Vector3 arm(0.3, 0.4, -0.2);
  for (Index j = 0; j < body.size(); ++j) {
    const Vector3 turned = Vector3(end.block<3, 1>(3, j)).cross(arm);
    EXPECT_LT((tip.block<3, 1>(0, j) - end.block<3, 1>(0, j) - turned).norm(),
              1e-12 * tip.col(j).norm());
    EXPECT_LT((tip.block<3, 1>(3, j) - end.block<3, 1>(3, j)).norm(), 1e-12 * tip.col(j).norm());
  }
  // With every mode the effective masses add up to what a motion of the base moves: all but the
  // share of the clamped node, half an element's mass and a little of the neighbour's.
  const Vector3 sum = body.effective_mass().colwise().sum();
  const double element = 8000 * 0.006 * 0.25;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(sum[axis], body.total_mass[axis]);
    EXPECT_GT(sum[axis], body.total_mass[axis] - element);
  }
}

namespace {

// As in beam_theories.cc, without shear: (v, v', M / EI, Q / EI) along a flexible length a.
Eigen::Matrix4d flexible(double square, double length) {
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate(0, 1) = rate(1, 2) = 1;
  rate(2, 3) = -1;
  rate(3, 0) = -square;
  return exponential(rate * length);
}

/// Along a rigid length with the same mass: the inertia of v + v' s in Q and M.
Eigen::Matrix4d rigid(double square, double b) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(0, 1) = b;
  matrix(3, 0) = -square * b;
  matrix(3, 1) = -square * b * b / 2;
  matrix(2, 3) = -b;
  matrix(2, 0) = square * b * b / 2;
  matrix(2, 1) = square * b * b * b / 6;
  return matrix;
}

} // namespace

TEST(RigidLinks, ABeamWithARigidEndConvergesToTheClosedForm) {
  constexpr double a = 0.7, b = 0.3;
  const double scale = std::sqrt(2e11 * 0.01 * 0.01 / 12 / 8000); // sqrt(EI / rho A)
  const auto determinant = [&](double omega) {
    const double square = omega * omega / (scale * scale);
    return Eigen::Matrix4d(rigid(square, b) * flexible(square, a)).block<2, 2>(2, 2).determinant();
  };
  const std::vector<double> exact = zeros(determinant, 0.2 * scale, 3);
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(1, 0, 0), 10};
  beam.section = {.width = 0.03, .thickness = 0.01};
  beam.material = steel;
  beam.plane_normal = 1;
  beam.supports = {{"root", {"start", {}}, hold_all, {}},
                   {"no stretch", {"all", {}}, {true, false, false, false, false, false}, {}}};
  beam.members = {{.name = "tip", .between = {{a, 1}}}};
  beam.members[0].section = beam.section;
  beam.members[0].material = steel;
  beam.links = {{.name = "tip", .members = {"tip"}}};
  std::vector<double> errors;
  for (const int elements : {10, 20}) {
    beam.line.elements = elements;
    const std::vector<double> found = frequencies(beam, 3);
    for (int j = 0; j < 3; ++j)
      errors.push_back(found[j] * 2 * M_PI / exact[j] - 1);
  }
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(std::log2(errors[j] / errors[3 + j]), 4, 0.3) << errors[j];
    EXPECT_LT(std::abs(errors[3 + j]), 1e-5 * std::pow(j + 1, 4));
  }
}

// A rigid triangle turns about the skew line between two pinned nodes: m d^2 theta'' + k e^2 theta
// = 0 for a mass at the distance d from it and a spring at the distance e, both of every direction.
TEST(RigidLinks, ARigidFrameOnSkewHinges) {
  const std::vector<Vector3> nodes = {{0, 0, 0}, {1, 2, 0.5}, {0.3, 0.1, 1.2}, {-0.8, 0.9, 0.4}};
  BeamDefinition beam;
  beam.mesh_content = mesh_text(nodes, {{1, 2, 2}, {2, 3, 2}, {3, 1, 2}, {3, 4, 2}});
  beam.members = {massless_arm()};
  const std::array<bool, 6> pinned{true, true, true, false, false, false};
  beam.supports = {{"first", {"", nodes[0]}, pinned, {}}, {"second", {"", nodes[1]}, pinned, {}}};
  beam.supports.push_back({"spring", {"", nodes[3]}, {}, {5e3, 5e3, 5e3, 0, 0, 0}});
  beam.points = {{"mass", {"", nodes[2]}, 7}, {"spring", {"", nodes[3]}, 0}};
  beam.links = {{.name = "frame", .members = {"arm"}}};
  const Vector3 axis = nodes[1].normalized();
  const Vector3 motion = axis.cross(nodes[2]); // of the mass, by a unit turn
  const double stiff = axis.cross(nodes[3]).squaredNorm();
  const reduction::ReducedBody body = reduced(beam, 1);
  EXPECT_NEAR(body.omega()[0], std::sqrt(5e3 * stiff / (7 * motion.squaredNorm())), 1e-9);
  EXPECT_NEAR(body.point("mass").rows.col(0).head<3>().norm(), std::sqrt(1 / 7.0), 1e-12);
  for (int along = 0; along < 3; ++along)
    EXPECT_NEAR(body.effective_mass()(0, along), 7 * std::pow(motion.normalized()[along], 2),
                1e-10);
  // Static: the turn under a force at the mass, against the spring.
  const Matrix expected = motion * motion.transpose() / (5e3 * stiff);
  EXPECT_LT((body.point("mass").flexibility - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LT(
      (body.point("mass").inverse_mass - motion * motion.transpose() / (7 * motion.squaredNorm()))
          .norm(),
      1e-10);
}

// Heave m, tilt m (a^2 + t^2) / 12: the faceted mass of the elements comes close to the latter.
TEST(RigidLinks, ARigidPlateOnCornerSprings) {
  structure::ShellDefinition shell = square_plate(4);
  hold_in_plane(shell);
  const structure::Support corner{"", {}, {}, {0, 0, 1e6, 0, 0, 0}};
  for (const Vector3 &at :
       {Vector3(0, 0, 0), Vector3(10, 0, 0), Vector3(0, 10, 0), Vector3(10, 10, 0)}) {
    shell.supports.push_back(corner);
    shell.supports.back().at = {"", at};
  }
  shell.links = {{.name = "all", .groups = {"all"}}};
  const structure::AssembledBody body =
      structure::assemble(structure::build_shell(shell), MPI_COMM_WORLD);
  EXPECT_EQ(body.free.size, 3);
  const modes::NormalModes modes = modes::normal_modes(eigen_problem(body), {3, {}});
  const double mass = 8000 * 0.05 * 100;
  const double inertia = mass * (100 + 0.05 * 0.05) / 12;
  std::vector<double> expected = {4e6 / mass, 4e6 * 25 / inertia, 4e6 * 25 / inertia};
  for (int j = 0; j < 3; ++j)
    EXPECT_NEAR(modes.eigenvalues[j] / expected[j], 1, 1e-4) << j;
}

} // namespace rigid_links_tests
