#include "structure/gmsh_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

namespace vibroimpact::structure {

namespace {

constexpr int point_element = 15;
constexpr int line_element = 1;

[[noreturn]] void fail(const std::string &problem) {
  throw DefinitionError("Geometry", "", "Mesh", problem);
}

using Group = std::pair<int, int>; // dimension and tag
using Node = long;                 // number in the file

struct RawMesh {
  std::map<Group, std::string> names;
  std::map<Node, Vector3> nodes;
  std::vector<std::array<Node, 2>> lines;
  std::map<Group, std::set<Node>> members;
};

/// The words of a section; running out of them or meeting something else is an unreadable file.
class Words {
public:
  Words(std::string section, const std::string &text) : section_(std::move(section)), in_(text) {}

  long integer() { return read<long>(); }
  double real() {
    const auto word = read<std::string>();
    char *end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value))
      broken();
    return value;
  }
  std::string quoted() {
    std::string skipped;
    std::string text;
    if (!std::getline(in_, skipped, '"') || !std::getline(in_, text, '"'))
      broken();
    return text;
  }
  std::size_t count() {
    const long number = integer();
    if (number < 0)
      broken();
    return static_cast<std::size_t>(number);
  }
  Vector3 vector() {
    const double x = real();
    const double y = real();
    return {x, y, real()};
  }
  [[noreturn]] void broken() const {
    fail("must be a complete Gmsh file, but its section $" + section_ +
         " breaks off or is damaged");
  }

private:
  template <class T> T read() {
    T value{};
    if (!(in_ >> value))
      broken();
    return value;
  }

  std::string section_;
  std::istringstream in_;
};

using Sections = std::map<std::string, std::string>;

Sections split_sections(const std::string &content) {
  Sections sections;
  std::istringstream lines(content);
  std::string line;
  std::string name;
  while (std::getline(lines, line)) {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (line.rfind("$End", 0) == 0)
      name.clear();
    else if (name.empty() && line.rfind('$', 0) == 0)
      sections[name = line.substr(1)];
    else if (!name.empty())
      sections[name] += line + "\n";
  }
  if (!name.empty())
    fail("must be a complete Gmsh file, but its section $" + name + " does not end");
  return sections;
}

Words words(const Sections &sections, const std::string &name) {
  const auto found = sections.find(name);
  if (found == sections.end())
    fail("must be a Gmsh file, but has no section $" + name);
  return {name, found->second};
}

std::string read_version(const Sections &sections) {
  if (!sections.contains("MeshFormat"))
    fail("must be a Gmsh file (.msh), but has no section $MeshFormat");
  std::istringstream format(sections.at("MeshFormat"));
  std::string version;
  int binary = 0;
  format >> version >> binary;
  if (binary != 0)
    fail("must be an ASCII Gmsh file, but is a binary one (gmsh: Mesh.Binary = 0)");
  if (version != "2.2" && version != "4.1")
    fail("must be a Gmsh file of version 2.2 or 4.1, but is " + version);
  return version;
}

void read_names(const Sections &sections, RawMesh &raw) {
  if (!sections.contains("PhysicalNames"))
    return;
  Words in = words(sections, "PhysicalNames");
  for (std::size_t left = in.count(); left > 0; --left) {
    const int dimension = static_cast<int>(in.integer());
    const int tag = static_cast<int>(in.integer());
    raw.names[{dimension, tag}] = in.quoted();
  }
}

int nodes_of_element(long type) {
  if (type == point_element)
    return 1;
  if (type == line_element)
    return 2;
  if (type == 8 || (type >= 26 && type <= 28))
    fail("must have straight two-node lines, but has lines of higher order (gmsh: -order 1)");
  fail("must hold lines only, but has cells of Gmsh element type " + std::to_string(type));
}

void add_element(RawMesh &raw, Words &in, long type, const std::vector<int> &physical) {
  std::array<Node, 2> nodes{};
  const int size = nodes_of_element(type);
  for (int i = 0; i < size; ++i)
    nodes[i] = in.integer();
  if (size == 2)
    raw.lines.push_back(nodes);
  for (const int tag : physical)
    for (int i = 0; i < size; ++i)
      raw.members[{size - 1, tag}].insert(nodes[i]);
}

void read_2(const Sections &sections, RawMesh &raw) {
  Words nodes = words(sections, "Nodes");
  for (std::size_t left = nodes.count(); left > 0; --left) {
    const Node number = nodes.integer();
    raw.nodes[number] = nodes.vector();
  }
  Words elements = words(sections, "Elements");
  for (std::size_t left = elements.count(); left > 0; --left) {
    elements.integer();
    const long type = elements.integer();
    std::vector<int> physical;
    const std::size_t tags = elements.count();
    for (std::size_t i = 0; i < tags; ++i) {
      const int tag = static_cast<int>(elements.integer());
      if (i == 0 && tag != 0) // the first tag is the physical group, the others are not needed
        physical.push_back(tag);
    }
    add_element(raw, elements, type, physical);
  }
}

using Entity = std::pair<int, int>; // dimension and tag

std::map<Entity, std::vector<int>> read_entities(const Sections &sections) {
  std::map<Entity, std::vector<int>> physical;
  if (!sections.contains("Entities"))
    return physical;
  Words in = words(sections, "Entities");
  std::array<std::size_t, 4> counts{};
  for (std::size_t &count : counts)
    count = in.count();
  for (int dimension = 0; dimension < 2; ++dimension)
    for (std::size_t left = counts[dimension]; left > 0; --left) {
      const int tag = static_cast<int>(in.integer());
      for (int skip = 0; skip < (dimension == 0 ? 3 : 6); ++skip)
        in.real();
      std::vector<int> &tags = physical[{dimension, tag}];
      for (std::size_t n = in.count(); n > 0; --n)
        tags.push_back(std::abs(static_cast<int>(in.integer()))); // negative: reversed
      for (std::size_t n = dimension == 0 ? 0 : in.count(); n > 0; --n)
        in.integer(); // bounding points
    }
  return physical;
}

void read_nodes_4(const Sections &sections, RawMesh &raw) {
  Words in = words(sections, "Nodes");
  std::size_t blocks = in.count();
  for (int skip = 0; skip < 3; ++skip)
    in.integer();
  for (; blocks > 0; --blocks) {
    const long dimension = in.integer();
    in.integer(); // entity
    const bool parametric = in.integer() != 0;
    std::vector<Node> numbers(in.count());
    for (Node &number : numbers)
      number = in.integer();
    for (const Node number : numbers) {
      raw.nodes[number] = in.vector();
      for (long skip = 0; parametric && skip < dimension; ++skip)
        in.real();
    }
  }
}

void read_4(const Sections &sections, RawMesh &raw) {
  const auto entities = read_entities(sections);
  read_nodes_4(sections, raw);
  Words in = words(sections, "Elements");
  std::size_t blocks = in.count();
  for (int skip = 0; skip < 3; ++skip)
    in.integer();
  for (; blocks > 0; --blocks) {
    const int dimension = static_cast<int>(in.integer());
    const int tag = static_cast<int>(in.integer());
    const long type = in.integer();
    const auto found = entities.find({dimension, tag});
    const std::vector<int> physical = found == entities.end() ? std::vector<int>{} : found->second;
    for (std::size_t left = in.count(); left > 0; --left) {
      in.integer(); // element number
      add_element(raw, in, type, physical);
    }
  }
}

std::map<Node, int> number_used_nodes(const RawMesh &raw, LineMesh &mesh) {
  std::map<Node, int> index;
  for (const auto &line : raw.lines)
    for (const Node node : line)
      index[node] = 0;
  for (auto &[node, position] : index) {
    const auto found = raw.nodes.find(node);
    if (found == raw.nodes.end())
      fail("must define every node it uses, but node " + std::to_string(node) + " is missing");
    position = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(found->second);
  }
  return index;
}

LineMesh build(const RawMesh &raw) {
  LineMesh mesh;
  const std::map<Node, int> index = number_used_nodes(raw, mesh);
  std::set<std::array<int, 2>> known;
  for (const auto &line : raw.lines) {
    const std::array<int, 2> cell = {index.at(line[0]), index.at(line[1])};
    if (known.insert({std::min(cell[0], cell[1]), std::max(cell[0], cell[1])}).second)
      mesh.cells.push_back(cell);
  }
  std::map<std::string, std::set<int>> groups;
  for (const auto &[group, members] : raw.members) {
    const auto named = raw.names.find(group);
    const std::string name =
        named == raw.names.end() ? std::to_string(group.second) : named->second;
    for (const Node node : members)
      if (index.contains(node))
        groups[name].insert(index.at(node));
  }
  for (const auto &[name, members] : groups)
    mesh.groups[name].assign(members.begin(), members.end());
  return mesh;
}

} // namespace

LineMesh parse_gmsh(const std::string &content) {
  const Sections sections = split_sections(content);
  const std::string version = read_version(sections);
  RawMesh raw;
  read_names(sections, raw);
  if (version == "2.2")
    read_2(sections, raw);
  else
    read_4(sections, raw);
  return build(raw);
}

} // namespace vibroimpact::structure
