#include "structure/gmsh_reader.h"

#include "structure/gmsh_data.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace vibroimpact::structure {

namespace {

using Group = std::pair<int, int>; // dimension and tag
using Node = long;                 // number in the file

/// A cell or, without a type, a point, with the tags of its physical groups.
struct RawCell {
  std::vector<Node> nodes;
  std::vector<int> physical;
  const CellType *type;
  int dimension() const { return type ? type->dimension : 0; }
};

struct RawMesh {
  std::map<Group, std::string> names;
  std::map<Node, Vector3> nodes;
  std::vector<RawCell> cells;

  std::string name(int dimension, int tag) const {
    const auto named = names.find({dimension, tag});
    return named == names.end() ? std::to_string(tag) : named->second;
  }
};

void read_names(const GmshFile &file, RawMesh &raw) {
  if (!file.has("PhysicalNames"))
    return;
  GmshData in = file.section("PhysicalNames");
  for (std::size_t left = in.text_count(); left > 0; --left) {
    const int dimension = static_cast<int>(in.text_integer());
    const int tag = static_cast<int>(in.text_integer());
    raw.names[{dimension, tag}] = in.quoted();
  }
}

/// Of the elements that bodies are made of.
const CellType &type_of(int gmsh) {
  const auto &types = cell_types();
  const auto found = std::find_if(types.begin(), types.end(),
                                  [&](const CellType &type) { return type.gmsh == gmsh; });
  static const std::set<int> volumes = {4, 5, 6, 7, 11, 12, 13, 14, 17, 18, 19, 29, 30, 31};
  if (found != types.end() && (found->dimension == 1 || found->make))
    return *found;
  if (volumes.contains(gmsh))
    fail_mesh(
        "must hold points, lines, triangles, quadrilaterals and hexahedra only, but has other "
        "volumes (Gmsh element type " +
        std::to_string(gmsh) + ")");
  fail_mesh("must have straight lines and flat cells with corner nodes only, but has cells of "
            "higher order (Gmsh element type " +
            std::to_string(gmsh) + "; gmsh: -order 1)");
}

RawCell cell_of_type(int gmsh) {
  constexpr int point = 15;
  if (gmsh == point)
    return {std::vector<Node>(1), {}, nullptr};
  const CellType &type = type_of(gmsh);
  return {std::vector<Node>(type.nodes), {}, &type};
}

void read_nodes_2(const GmshFile &file, RawMesh &raw) {
  GmshData in = file.section("Nodes");
  std::size_t left = in.text_count();
  in.end_line();
  for (; left > 0; --left) {
    const Node number = in.integer();
    raw.nodes[number] = in.vector();
  }
}

/// `tags` come before the nodes; the first one is the physical group, the others are not needed.
RawCell read_cell_2(GmshData &in, int type, int tags) {
  RawCell cell = cell_of_type(type);
  for (int i = 0; i < tags; ++i) {
    const int tag = in.integer();
    if (i == 0 && tag != 0)
      cell.physical.push_back(tag);
  }
  for (Node &node : cell.nodes)
    node = in.integer();
  return cell;
}

// Binary files give type and number of tags once for a block of elements.
void read_elements_2(const GmshFile &file, RawMesh &raw) {
  GmshData in = file.section("Elements");
  std::size_t left = in.text_count();
  in.end_line();
  while (left > 0 && file.binary()) {
    const int type = in.integer();
    const int block = in.integer();
    const int tags = in.integer();
    if (block < 1 || static_cast<std::size_t>(block) > left || tags < 0)
      in.broken();
    for (int i = 0; i < block; ++i, --left) {
      in.integer(); // element number
      raw.cells.push_back(read_cell_2(in, type, tags));
    }
  }
  for (; left > 0; --left) {
    in.integer(); // element number
    const int type = in.integer();
    const int tags = in.integer();
    raw.cells.push_back(read_cell_2(in, type, tags));
  }
}

using Entity = std::pair<int, int>; // dimension and tag

/// Physical tags of the points, curves and surfaces.
std::map<Entity, std::vector<int>> read_entities(const GmshFile &file) {
  std::map<Entity, std::vector<int>> physical;
  if (!file.has("Entities"))
    return physical;
  GmshData in = file.section("Entities");
  std::array<std::size_t, 4> counts{};
  for (std::size_t &count : counts)
    count = in.count();
  for (int dimension = 0; dimension < 3; ++dimension)
    for (std::size_t left = counts[dimension]; left > 0; --left) {
      const int tag = in.integer();
      for (int skip = 0; skip < (dimension == 0 ? 3 : 6); ++skip)
        in.real();
      std::vector<int> &tags = physical[{dimension, tag}];
      for (std::size_t n = in.count(); n > 0; --n)
        tags.push_back(std::abs(in.integer())); // negative: reversed
      for (std::size_t n = dimension == 0 ? 0 : in.count(); n > 0; --n)
        in.integer(); // what bounds it
    }
  return physical;
}

void read_nodes_4(const GmshFile &file, RawMesh &raw) {
  GmshData in = file.section("Nodes");
  std::size_t blocks = in.count();
  for (int skip = 0; skip < 3; ++skip)
    in.count();
  for (; blocks > 0; --blocks) {
    const int dimension = in.integer();
    in.integer(); // entity
    const bool parametric = in.integer() != 0;
    std::vector<Node> numbers;
    for (std::size_t left = in.count(); left > 0; --left)
      numbers.push_back(static_cast<Node>(in.count()));
    for (const Node number : numbers) {
      raw.nodes[number] = in.vector();
      for (int skip = 0; parametric && skip < dimension; ++skip)
        in.real();
    }
  }
}

void read_elements_4(const GmshFile &file, RawMesh &raw) {
  const auto entities = read_entities(file);
  GmshData in = file.section("Elements");
  std::size_t blocks = in.count();
  for (int skip = 0; skip < 3; ++skip)
    in.count();
  for (; blocks > 0; --blocks) {
    const int dimension = in.integer();
    const int tag = in.integer();
    const int type = in.integer();
    const auto found = entities.find({dimension, tag});
    const std::vector<int> physical = found == entities.end() ? std::vector<int>{} : found->second;
    for (std::size_t left = in.count(); left > 0; --left) {
      in.count(); // element number
      RawCell cell = cell_of_type(type);
      cell.physical = physical;
      for (Node &node : cell.nodes)
        node = static_cast<Node>(in.count());
      raw.cells.push_back(std::move(cell));
    }
  }
}

/// Numbers of the nodes in the mesh, in the order of the file's numbers.
std::map<Node, int> number_used_nodes(const RawMesh &raw, Mesh &mesh) {
  std::map<Node, int> index;
  for (const RawCell &cell : raw.cells)
    if (cell.dimension() > 0)
      for (const Node node : cell.nodes)
        index[node] = 0;
  for (auto &[node, position] : index) {
    const auto found = raw.nodes.find(node);
    if (found == raw.nodes.end())
      fail_mesh("must define every node it uses, but node " + std::to_string(node) + " is missing");
    position = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(found->second);
  }
  mesh.unused_nodes = static_cast<int>(raw.nodes.size() - mesh.nodes.size());
  return index;
}

class Builder {
public:
  explicit Builder(const RawMesh &raw) : raw_(raw), index_(number_used_nodes(raw, mesh_)) {}

  Mesh build() {
    for (const RawCell &cell : raw_.cells) {
      const int position = cell.dimension() > 0 ? place(cell) : 0;
      for (const int tag : cell.physical)
        add_to_group(raw_.name(cell.dimension(), tag), cell, position);
    }
    for (const auto &[name, nodes] : node_groups_)
      mesh_.groups[name].assign(nodes.begin(), nodes.end());
    return std::move(mesh_);
  }

private:
  /// Position of the cell in the mesh; a cell that is known already keeps its place.
  int place(const RawCell &cell) {
    std::vector<int> nodes;
    for (const Node node : cell.nodes)
      nodes.push_back(index_.at(node));
    std::vector<int> sorted = nodes;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t next = cell.dimension() == 1 ? mesh_.lines.size() : mesh_.cells.size();
    const auto [known, is_new] = places_.insert({sorted, static_cast<int>(next)});
    if (is_new && cell.dimension() == 1)
      mesh_.lines.push_back({nodes[0], nodes[1]});
    else if (is_new)
      mesh_.cells.push_back(structure::cell_of(cell.type->shape, nodes));
    return known->second;
  }

  void add_to_group(const std::string &name, const RawCell &cell, int position) {
    for (const Node node : cell.nodes)
      if (const auto found = index_.find(node); found != index_.end())
        node_groups_[name].insert(found->second);
    if (cell.dimension() == 0)
      return;
    if (!members_.insert({cell.dimension(), name, position}).second)
      fail_mesh("must hold each cell once, but group " + name + " has the one at " +
                coordinates(raw_.nodes.at(cell.nodes[0])) + " twice");
    (cell.dimension() == 1 ? mesh_.line_groups : mesh_.cell_groups)[name].push_back(position);
  }

  const RawMesh &raw_;
  Mesh mesh_;
  std::map<Node, int> index_;
  std::map<std::vector<int>, int> places_;
  std::map<std::string, std::set<int>> node_groups_;
  std::set<std::tuple<int, std::string, int>> members_;
};

} // namespace

Mesh parse_gmsh(const std::string &content) {
  const GmshFile file(content);
  RawMesh raw;
  read_names(file, raw);
  if (file.version() == "2.2") {
    read_nodes_2(file, raw);
    read_elements_2(file, raw);
  } else {
    read_nodes_4(file, raw);
    read_elements_4(file, raw);
  }
  return Builder(raw).build();
}

} // namespace vibroimpact::structure
