#include "structure/hinges.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

int member_of(const BeamDefinition &definition, const Hinge &hinge) {
  std::string known;
  for (std::size_t m = 0; m < definition.members.size(); ++m) {
    if (definition.members[m].name == hinge.member)
      return static_cast<int>(m);
    known += (known.empty() ? "" : ", ") + definition.members[m].name;
  }
  throw DefinitionError("Hinge", hinge.name, "Member",
                        known.empty() ? "must be the name of a subsection Member, but there is none"
                                      : "must be one of: " + known);
}

using NodeMatrix = Eigen::Matrix<double, 6, 6>;

bool is_linked(const BodyModel &model, int node) {
  return std::any_of(model.rigid.begin(), model.rigid.end(), [&](const std::vector<int> &nodes) {
    return std::binary_search(nodes.begin(), nodes.end(), node);
  });
}

/// Which motions of a node something follows: the sum of projections on those that each line passes
/// on, and on those that supports or a rigid link hold.
NodeMatrix passed_on(const BodyModel &model, const std::vector<ElementFrame> &frames,
                     const std::vector<Releases> &releases, int node) {
  NodeMatrix sum = NodeMatrix::Zero();
  if (is_linked(model, node))
    sum.setIdentity();
  for (std::size_t line = 0; line < frames.size(); ++line)
    for (int end = 0; end < 2; ++end)
      if (model.mesh.lines[line][end] == node)
        for (int component = 0; component < 6; ++component)
          if (!releases[line][6 * end + component]) {
            const int part = component / 3 * 3;
            const Vector3 axis = frames[line].axes.row(component - part);
            sum.block<3, 3>(part, part) += axis * axis.transpose();
          }
  for (int component = 0; component < 6; ++component)
    if (model.fixed[node][component] || model.spring[node][component] > 0)
      sum(component, component) += 1;
  return sum;
}

} // namespace

std::vector<Releases> releases_of_lines(const Mesh &mesh, const BeamDefinition &definition,
                                        const std::vector<int> &members) {
  std::vector<Releases> releases(mesh.lines.size());
  for (const Hinge &hinge : definition.hinges) {
    const int member = member_of(definition, hinge);
    const std::vector<int> nodes = find_nodes(mesh, hinge.at, "Hinge", hinge.name);
    bool found = false;
    for (std::size_t line = 0; line < mesh.lines.size(); ++line)
      for (int end = 0; end < 2; ++end) {
        if (members[line] != member ||
            !std::binary_search(nodes.begin(), nodes.end(), mesh.lines[line][end]))
          continue;
        found = true;
        for (int component = 0; component < 6; ++component)
          if (hinge.free[component])
            releases[line][6 * end + component] = true;
      }
    if (!found)
      throw DefinitionError("Hinge", hinge.name, hinge.at.position ? "Position" : "At",
                            "must be where a line of Member " + hinge.member + " ends");
  }
  return releases;
}

void check_hinges(const BodyModel &model, const BeamDefinition &definition,
                  const std::vector<ElementFrame> &frames, const std::vector<Releases> &releases) {
  constexpr double least = 1e-6; // square of the sine between axes that count as parallel
  for (const Hinge &hinge : definition.hinges)
    for (const int node : find_nodes(model.mesh, hinge.at, "Hinge", hinge.name)) {
      const NodeMatrix sum = passed_on(model, frames, releases, node);
      if (Eigen::SelfAdjointEigenSolver<NodeMatrix>(sum).eigenvalues()[0] < least)
        throw DefinitionError("Hinge", hinge.name, "Free",
                              "must leave something that holds the node at " +
                                  coordinates(model.mesh.nodes[node]) +
                                  ": one of the lines that meet there must be fixed to it, or a "
                                  "support hold it");
    }
}

} // namespace vibroimpact::structure
