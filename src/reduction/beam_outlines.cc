#include "reduction/beam_outlines.h"

#include "reduction/body_parameters.h"
#include "reduction/reduce.h"

#include <map>

namespace vibroimpact::reduction {

namespace {

/// Outlines by the nodes of the beams, the smaller one first.
std::map<std::array<int, 2>, Matrix> outlines_by_nodes(const structure::BodyModel &model) {
  std::map<std::array<int, 2>, Matrix> outlines;
  for (const auto &element : model.elements)
    if (const auto nodes = element->nodes(); nodes.size() == 2)
      outlines.try_emplace({std::min(nodes[0], nodes[1]), std::max(nodes[0], nodes[1])},
                           element->outline());
  return outlines;
}

bool has_beams(const BodyDefinition &definition) {
  return definition.type == BodyDefinition::Type::beam ||
         (definition.type == BodyDefinition::Type::shell && !definition.shell.stiffeners.empty());
}

} // namespace

std::vector<Matrix> beam_outlines(const parameters::Values &body, const std::string &name,
                                  const std::string &folder, MPI_Comm communicator) {
  const BodyDefinition definition = read_body(body, name, folder, communicator);
  if (!has_beams(definition))
    return {};
  const structure::BodyModel model = build_model(definition, communicator);
  const auto known = outlines_by_nodes(model);
  std::vector<Matrix> outlines;
  for (const auto &[a, b] : model.mesh.lines) {
    const auto at = known.find({std::min(a, b), std::max(a, b)});
    outlines.push_back(at == known.end() ? Matrix() : at->second);
  }
  return outlines;
}

} // namespace vibroimpact::reduction
