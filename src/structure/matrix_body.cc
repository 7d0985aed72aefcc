#include "structure/matrix_body.h"

#include "structure/given_matrices.h"
#include "structure/input_deck.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

Mesh known_nodes(const MatrixDefinition &definition, const std::vector<TableRow> &table) {
  Mesh mesh;
  if (!definition.deck_content.empty())
    mesh = read_input_deck(definition.deck_content, definition.units.length, definition.deck_name);
  for (const TableRow &row : table) {
    if (!row.position)
      continue;
    const auto [at, is_new] = mesh.numbers.emplace(row.node, static_cast<int>(mesh.nodes.size()));
    if (is_new)
      mesh.nodes.emplace_back(definition.units.length * *row.position);
  }
  if (std::none_of(table.begin(), table.end(),
                   [&](const TableRow &row) { return mesh.numbers.contains(row.node); }))
    throw DefinitionError("Matrices", "", "Table",
                          definition.deck_content.empty()
                              ? "must have the coordinates of its nodes when Geometry / Mesh is "
                                "not given"
                              : "must have nodes of the input deck of Geometry / Mesh, but has "
                                "none of them");
  return mesh;
}

/// Internal nodes take up to six rows that belong together: those of one node in the table, or one
/// difference for each component.
class InternalNodes {
public:
  explicit InternalNodes(Mesh &mesh) : mesh_(mesh) {}

  /// A node of the mesh with this component free; `key`: rows of equal keys share nodes.
  int node_for(const std::array<int, 3> &key, const Vector3 &position) {
    const auto [at, is_new] = nodes_.emplace(key, static_cast<int>(mesh_.nodes.size()));
    if (is_new) {
      mesh_.nodes.push_back(position);
      ++mesh_.internal_nodes;
    }
    return at->second;
  }

private:
  Mesh &mesh_;
  std::map<std::array<int, 3>, int> nodes_;
};

struct Places {
  std::vector<std::array<int, 2>> of_row; ///< node and component
  std::vector<std::array<int, 2>> follow; ///< internal nodes held where the other node is
};

Places place_rows(const std::vector<TableRow> &table, const RowGroups &groups, Mesh &mesh) {
  Places places;
  InternalNodes internal(mesh);
  const Vector3 somewhere = mesh.nodes.front();
  std::vector<int> layer(table.size(), 0);
  for (std::size_t row = 0; row < table.size(); ++row)
    for (std::size_t k = 0; k < groups.others[row].size(); ++k)
      layer[groups.others[row][k]] = static_cast<int>(k) + 1;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto found = mesh.numbers.find(table[row].node);
    const bool known = found != mesh.numbers.end();
    const int real = known ? found->second : -1;
    int node = real;
    if (!known || layer[row] > 0) {
      node = internal.node_for({table[row].node, layer[row], known ? 1 : 0},
                               known ? mesh.nodes[real] : somewhere);
      if (known)
        places.follow.push_back({node, real});
    }
    places.of_row.push_back({node, table[row].component});
  }
  return places;
}

/// What the table does not have stands still, and a node that is held is held in all its layers.
void hold_rest(const Places &places, BodyModel &model) {
  for (const auto &[layer, node] : places.follow)
    model.fixed[layer] = model.fixed[node];
  std::vector<std::array<bool, 6>> there(model.mesh.nodes.size(), std::array<bool, 6>{});
  for (const auto &[node, component] : places.of_row)
    there[node][component] = true;
  for (std::size_t node = 0; node < there.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (!there[node][component])
        model.fixed[node][component] = true;
}

} // namespace

BodyModel build_matrix_body(const MatrixDefinition &definition, MPI_Comm communicator) {
  const std::vector<TableRow> table =
      read_dof_table(definition.table_content, definition.table_name);
  const RowGroups groups = group_rows(table);
  BodyModel model;
  model.mesh = known_nodes(definition, table);
  Places places = place_rows(table, groups, model.mesh);
  add_parts({.plane_normal = definition.plane_normal,
             .supports = definition.supports,
             .points = definition.points,
             .interfaces = definition.interfaces,
             .loads = definition.loads},
            model);
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      throw DefinitionError("Load", load.name, "Pressure", "needs the surfaces of a shell");
  hold_rest(places, model);
  GivenMatrices given = read_given_matrices(definition, table, groups, communicator);
  given.place = std::move(places.of_row);
  model.given = std::make_shared<const GivenMatrices>(std::move(given));
  return model;
}

} // namespace vibroimpact::structure
