#include "structure/input_deck.h"

#include "structure/deck_cells.h"
#include "structure/text_lines.h"

#include <algorithm>
#include <cctype>

namespace vibroimpact::structure {

namespace {

std::string capitals(std::string_view text) {
  std::string result;
  for (const char letter : text)
    if (letter != ' ' && letter != '\t')
      result += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return result;
}

/// "*ELEMENT, TYPE=S4, ELSET=ALL" in capitals.
struct Keyword {
  std::string name;
  std::map<std::string, std::string> options;
};

Keyword keyword_of(std::string_view line) {
  Keyword keyword;
  const std::string text = capitals(line);
  for (const std::string_view part : parts_of(text, ",")) {
    if (keyword.name.empty()) {
      keyword.name = part;
      continue;
    }
    const std::size_t equals = std::min(part.find('='), part.size());
    keyword.options[std::string(part.substr(0, equals))] =
        part.substr(std::min(equals + 1, part.size()));
  }
  return keyword;
}

class DeckReader {
public:
  DeckReader(double length, const std::string &file) : length_(length), file_(file) {}

  Mesh read(const std::string &content) {
    for (std::size_t position = 0; position < content.size();) {
      line_ = take_line(content, position);
      ++number_;
      if (line_.starts_with("**") || parts_of(line_).empty())
        continue;
      if (line_.front() == '*')
        begin();
      else
        data();
    }
    finish_element();
    finish();
    return std::move(mesh_);
  }

private:
  [[noreturn]] void fail(const std::string &wanted) const {
    throw DefinitionError("Geometry", "", "Mesh",
                          "must be an input deck " + wanted + ", but " +
                              quoted_line(number_, file_, line_));
  }

  void begin() {
    finish_element();
    keyword_ = keyword_of(line_);
    if (keyword_.name == "*INCLUDE" || keyword_.name == "*INSTANCE" || keyword_.name == "*PART")
      fail("that holds its nodes and elements itself, without *INCLUDE, *PART and *INSTANCE");
    if (keyword_.name == "*ELEMENT")
      shown_ = deck_element(keyword_.options["TYPE"]);
    if (keyword_.options.contains("NSET") && (keyword_.name == "*NSET" || keyword_.name == "*NODE"))
      mesh_.groups[keyword_.options["NSET"]];
  }

  void data() {
    if (keyword_.name == "*NODE")
      node();
    else if (keyword_.name == "*NSET")
      set();
    else if (keyword_.name == "*ELEMENT" && shown_)
      element();
  }

  int integer(std::string_view part) const {
    const std::optional<int> value = number_of<int>(part);
    if (!value || *value < 1)
      fail("with numbers of nodes and elements from 1 on");
    return *value;
  }

  void node() {
    const auto parts = parts_of(line_, ",");
    if (parts.size() < 2)
      fail("with lines NUMBER, X, Y, Z of nodes");
    Vector3 place = Vector3::Zero();
    for (std::size_t axis = 0; axis < 3 && axis + 1 < parts.size(); ++axis) {
      const std::optional<double> value = number_of<double>(parts[axis + 1]);
      if (!value || !std::isfinite(*value))
        fail("with lines NUMBER, X, Y, Z of nodes");
      place[static_cast<Index>(axis)] = *value * length_;
    }
    const int number = integer(parts[0]);
    const auto [known, is_new] =
        mesh_.numbers.emplace(number, static_cast<int>(mesh_.nodes.size()));
    if (is_new)
      mesh_.nodes.push_back(place);
    else
      mesh_.nodes[static_cast<std::size_t>(known->second)] = place;
    if (const auto set = keyword_.options.find("NSET"); set != keyword_.options.end())
      mesh_.groups[set->second].push_back(known->second);
  }

  int position(int number) const {
    const auto found = mesh_.numbers.find(number);
    if (found == mesh_.numbers.end())
      fail("that has the nodes it names under *NODE before");
    return found->second;
  }

  void set() {
    std::vector<int> &group = mesh_.groups[keyword_.options["NSET"]];
    const auto parts = parts_of(line_, ",");
    if (keyword_.options.contains("GENERATE")) {
      if (parts.size() < 2)
        fail("with lines FIRST, LAST, STEP behind *NSET, GENERATE");
      const int last = integer(parts[1]);
      const int step = parts.size() > 2 ? integer(parts[2]) : 1;
      for (long number = integer(parts[0]); number <= last; number += step)
        group.push_back(position(static_cast<int>(number)));
      return;
    }
    for (const std::string_view part : parts)
      if (const auto other = mesh_.groups.find(capitals(part)); other != mesh_.groups.end()) {
        const std::vector<int> nodes = other->second;
        group.insert(group.end(), nodes.begin(), nodes.end());
      } else
        group.push_back(position(integer(part)));
  }

  /// The nodes of an element may stand on several lines.
  void element() {
    for (const std::string_view part : parts_of(line_, ","))
      pending_.push_back(integer(part));
    if (pending_.size() > shown_->nodes)
      finish_element();
  }

  void finish_element() {
    if (pending_.empty())
      return;
    if (pending_.size() != shown_->nodes + 1)
      fail("with " + std::to_string(shown_->nodes) + " nodes for each element of type " +
           keyword_.options["TYPE"]);
    std::vector<int> nodes;
    for (std::size_t i = 1; i < pending_.size(); ++i)
      nodes.push_back(position(pending_[i]));
    cells_.add(*shown_, nodes);
    pending_.clear();
  }

  void finish() {
    if (mesh_.nodes.empty())
      throw DefinitionError("Geometry", "", "Mesh",
                            "must be an input deck with nodes (*NODE), but " + file_ + " has none");
    cells_.give(mesh_);
    for (auto &[name, nodes] : mesh_.groups) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
  }

  double length_;
  std::string file_;
  std::string_view line_;
  std::size_t number_ = 0;
  Keyword keyword_;
  std::optional<DeckElement> shown_;
  std::vector<int> pending_; ///< of an element: its number, then its nodes
  DeckCells cells_;
  Mesh mesh_;
};

} // namespace

Mesh read_input_deck(const std::string &content, double length, const std::string &file) {
  return DeckReader(length, file).read(content);
}

} // namespace vibroimpact::structure
