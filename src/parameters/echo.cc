#include "parameters/echo.h"

#include <algorithm>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

const std::size_t line_length = 96;

std::string indent(int depth) { return std::string(2 * static_cast<std::size_t>(depth), ' '); }

std::string keys_text(const Node &node, int depth) {
  std::string text;
  const std::size_t width = name_width(*node.declared);
  for (const Value &value : node.values)
    text += assignment(depth, value.key->name, width, value.text, value.given ? "" : "default");
  return text;
}

void write_section(const Node &node, int depth, std::string &text);

void write_content(const Node &node, int depth, std::string &text) {
  text += keys_text(node, depth);
  for (const Node &subsection : node.subsections)
    write_section(subsection, depth, text);
  for (const std::vector<Shared<Node>> &kind : node.instances)
    for (const Node &instance : kind)
      write_section(instance, depth, text);
}

void write_section(const Node &node, int depth, std::string &text) {
  if (depth == 0)
    text += "\n";
  text += indent(depth) + "subsection " + node.path.back() + (node.given ? "\n" : "  # default\n");
  write_content(node, depth + 1, text);
  text += indent(depth) + "end\n";
}

} // namespace

std::size_t name_width(const Section &section) {
  std::size_t width = 0;
  for (const Key &key : section.keys())
    width = std::max(width, key.name.size());
  return width;
}

std::string assignment(int depth, const std::string &key, std::size_t width,
                       const std::string &value, const std::string &comment) {
  std::string line = indent(depth) + "set " + key + std::string(width - key.size(), ' ') + " =";
  const std::string next_line = std::string(line.size() + 1, ' ');
  std::string text;
  std::istringstream words(value);
  for (std::string word; words >> word;) {
    if (line.size() + word.size() > line_length && line.size() > next_line.size()) {
      text += line + " \\\n";
      line = next_line + word;
    } else {
      line += " " + word;
    }
  }
  return text + line + (comment.empty() ? "" : "  # " + comment) + "\n";
}

std::string echo_text(const Node &root) {
  std::string text;
  write_content(root, 0, text);
  return text;
}

} // namespace vibroimpact::parameters
