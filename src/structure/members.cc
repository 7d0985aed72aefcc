#include "structure/members.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

// As for the positions of points: coordinates are typed by hand.
constexpr double position_tolerance = 1e-6;

double length_of(const Line &line) { return (line.end - line.start).norm(); }

/// Distance from the start of a position on the line.
std::optional<double> place_on(const Line &line, const Location &at) {
  if (!at.position || at.nearest)
    return std::nullopt;
  const double length = length_of(line);
  const Vector3 direction = (line.end - line.start) / length;
  const double along = direction.dot(*at.position - line.start);
  const double beside = (*at.position - line.start - along * direction).norm();
  const double tolerance = position_tolerance * length;
  if (beside > tolerance || along < -tolerance || along > length + tolerance)
    return std::nullopt;
  return along;
}

std::vector<int> lines_between(const Mesh &mesh, const Line &line, const Member &member) {
  const double length = length_of(line);
  const double tolerance = position_tolerance * length;
  const auto [from, to] = *member.between;
  if (!(from >= -tolerance && to <= length + tolerance && to - from > tolerance))
    throw DefinitionError("Member", member.name, "Between",
                          "must be two ascending distances from 0 m to the length of the Line, " +
                              std::to_string(length) + " m");
  std::vector<int> lines;
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
    const Vector3 middle = (mesh.nodes[mesh.lines[i][0]] + mesh.nodes[mesh.lines[i][1]]) / 2;
    const double along = (middle - line.start).norm();
    if (along > from && along < to)
      lines.push_back(static_cast<int>(i));
  }
  return lines;
}

std::vector<int> lines_of(const Mesh &mesh, const BeamDefinition &definition,
                          const Member &member) {
  if (member.between)
    return lines_between(mesh, definition.line, member);
  return find_cells(mesh.line_groups, member.on, mesh.lines.size(), "Member", member.name);
}

[[noreturn]] void fail_chain(const Mesh &mesh, int node, const std::string &kind,
                             const std::string &name, const std::string &problem) {
  throw DefinitionError(
      kind, name, "",
      "changes along its length, so that its lines must be chains that run in one direction, "
      "but " +
          problem + " at " + coordinates(mesh.nodes[node]));
}

} // namespace

std::vector<double> needed_places(const BeamDefinition &definition) {
  std::vector<double> places;
  const auto add = [&](const Location &at) {
    if (const auto place = place_on(definition.line, at))
      places.push_back(*place);
  };
  for (const Member &member : definition.members)
    if (member.between)
      places.insert(places.end(), member.between->begin(), member.between->end());
  for (const Support &support : definition.supports)
    add(support.at);
  for (const Point &point : definition.points)
    add(point.at);
  for (const Hinge &hinge : definition.hinges)
    add(hinge.at);
  for (const Load &load : definition.loads)
    add(load.at);
  const double length = length_of(definition.line);
  std::erase_if(places, [&](double place) { return !(place > 0 && place < length); });
  std::sort(places.begin(), places.end());
  return places;
}

std::vector<int> members_of_lines(const Mesh &mesh, const BeamDefinition &definition) {
  std::vector<int> members(mesh.lines.size(), -1);
  for (std::size_t m = 0; m < definition.members.size(); ++m) {
    const Member &member = definition.members[m];
    for (const int line : lines_of(mesh, definition, member)) {
      if (members[line] >= 0)
        throw DefinitionError("Member", member.name, member.between ? "Between" : "On",
                              "must not share lines with Member " +
                                  definition.members[members[line]].name);
      members[line] = static_cast<int>(m);
    }
  }
  return members;
}

std::vector<std::array<double, 2>> places_on_chains(const Mesh &mesh, const std::vector<int> &lines,
                                                    const std::string &kind,
                                                    const std::string &name) {
  std::map<int, std::size_t> leaving; // node -> the line that begins there
  std::map<int, std::size_t> arriving;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [first, second] = mesh.lines[lines[i]];
    if (!leaving.emplace(first, i).second)
      fail_chain(mesh, first, kind, name, "two of them begin");
    if (!arriving.emplace(second, i).second)
      fail_chain(mesh, second, kind, name, "two of them end");
  }
  std::vector<std::array<double, 2>> places(lines.size(), {-1, -1});
  for (const auto &[start, unused] : leaving) {
    if (arriving.contains(start))
      continue;
    std::vector<std::size_t> chain;
    double length = 0;
    for (auto at = leaving.find(start); at != leaving.end();
         at = leaving.find(mesh.lines[lines[at->second]][1])) {
      chain.push_back(at->second);
      places[at->second][0] = length;
      length += mesh.line_length(lines[at->second]);
      places[at->second][1] = length;
    }
    for (const std::size_t i : chain)
      places[i] = {places[i][0] / length, places[i][1] / length};
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (places[i][1] < 0)
      fail_chain(mesh, mesh.lines[lines[i]][0], kind, name, "they close");
  return places;
}

} // namespace vibroimpact::structure
