// Which nodes of a mesh an interface has, in which order.
#include "structure/interface_nodes.h"

#include "structure/shell_mesh.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace interface_nodes_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

Mesh plate() {
  return generate_plate(
      {.corner = {0, 0, 0}, .first_end = {4, 0, 0}, .second_end = {0, 2, 0}, .elements = {8, 4}});
}

std::vector<Vector3> places(const Mesh &mesh, const Interface &interface) {
  std::vector<Vector3> result;
  for (const int node : interface_nodes(mesh, interface))
    result.push_back(mesh.nodes[node]);
  return result;
}

/// The same mesh with its nodes numbered the other way round.
Mesh renumbered(const Mesh &mesh) {
  Mesh other = mesh;
  const int last = static_cast<int>(mesh.nodes.size()) - 1;
  std::reverse(other.nodes.begin(), other.nodes.end());
  for (auto &[name, nodes] : other.groups) {
    for (int &node : nodes)
      node = last - node;
    std::sort(nodes.begin(), nodes.end());
  }
  return other;
}

std::string problem_of(const Interface &interface) {
  try {
    interface_nodes(plate(), interface);
  } catch (const DefinitionError &error) {
    return error.kind() + " " + error.name() + " " + error.key() + " " + error.problem();
  }
  return "";
}

} // namespace

TEST(InterfaceNodes, AGroupInTheOrderOfItsCoordinates) {
  const std::vector<Vector3> right = places(plate(), {.name = "i", .group = "right", .near = {}});
  ASSERT_EQ(right.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(right[i], Vector3(4, 0.5 * static_cast<double>(i), 0));
}

TEST(InterfaceNodes, TheNumberingOfTheMeshDoesNotCount) {
  for (const Interface &interface :
       {Interface{.name = "i", .group = "edges", .near = {}},
        Interface{.name = "i", .group = "all", .near = {}},
        Interface{.name = "i", .group = "all", .near = {{1, 1.2, 0}, {3.1, 0.4, 0.3}}}})
    EXPECT_EQ(places(plate(), interface), places(renumbered(plate()), interface));
}

TEST(InterfaceNodes, NearestNodesInTheOrderGiven) {
  const std::vector<Vector3> found =
      places(plate(), {.name = "i", .group = "top", .near = {{3.1, 0, 0}, {0.4, 9, 0}}});
  EXPECT_EQ(found, (std::vector<Vector3>{{3, 2, 0}, {0.5, 2, 0}}));
}

TEST(InterfaceNodes, UnknownGroup) {
  EXPECT_NE(
      problem_of({.name = "i", .group = "roof", .near = {}}).find("Interface i At must be one of"),
      std::string::npos);
}

TEST(InterfaceNodes, EmptyGroup) {
  Mesh mesh = plate();
  mesh.groups["none"] = {};
  EXPECT_THROW(interface_nodes(mesh, {.name = "i", .group = "none", .near = {}}), DefinitionError);
}

TEST(InterfaceNodes, TwoPositionsMustNotMeanOneNode) {
  const std::string problem =
      problem_of({.name = "i", .near = {{0, 0, 0}, {2, 1, 0}, {0.1, 0, 0}}});
  EXPECT_NE(problem.find("positions 1 and 3"), std::string::npos) << problem;
}

} // namespace interface_nodes_tests
