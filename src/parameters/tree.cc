#include "parameters/tree.h"

#include "parameters/text.h"

#include <algorithm>
#include <map>
#include <utility>

namespace vibroimpact::parameters {

namespace {

using Path = std::vector<std::string>;

Path below(const Path &path, const std::string &name) {
  Path longer = path;
  longer.push_back(name);
  return longer;
}

bool is_instance_name(const std::string &name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

/// Compares scanned entries with the declarations.
class TreeBuilder {
public:
  void fill(Node &node, const ScannedEntry &section) {
    std::map<std::string, Origin> first;
    for (const ScannedEntry &entry : section.entries) {
      const auto [earlier, is_new] = first.emplace(entry.name, entry.origin);
      if (!is_new)
        refuse_duplicate(node, entry, earlier->second);
      fill_entry(node, entry);
    }
  }

private:
  static void fill_entry(Node &node, const ScannedEntry &entry) {
    const bool is_key = node.declared->find_key(entry.name) != nullptr;
    const bool is_section = node.declared->find_subsection(entry.name) != nullptr ||
                            kind_of(*node.declared, entry.name) != nullptr;
    const Path path = below(node.path, entry.name);
    if (entry.kind == ScannedEntry::Kind::array)
      refuse_place(entry.origin, path,
                   "arrays are not read; write a list as one string: \"1, 2, 3\"");
    if (entry.kind == ScannedEntry::Kind::key && !is_key && is_section)
      refuse_value(entry.origin, path, entry.value,
                   "'" + entry.name + "' is a subsection, not a key with a value");
    if (entry.kind == ScannedEntry::Kind::section && is_key && !is_section)
      refuse_place(entry.origin, path, "'" + entry.name + "' is a key, not a subsection");
    if (entry.kind == ScannedEntry::Kind::section || (!is_key && is_section))
      fill_section(node, entry);
    else
      fill_key(node, entry);
  }

  static void fill_key(Node &node, const ScannedEntry &entry) {
    Value *value = node.find_value(entry.name);
    if (value == nullptr)
      refuse_value(entry.origin, below(node.path, entry.name), entry.value,
                   unknown_key(*node.declared, entry.name));
    value->text = entry.value;
    value->origin = entry.origin;
    value->given = !(entry.marked_as_default && entry.value == value->key->default_value);
    node.given = node.given || value->given;
  }

  static void fill_section(Node &node, const ScannedEntry &entry) {
    Node &child = child_for(node, entry);
    child.origin = entry.origin;
    set_origins(child);
    child.given = !entry.marked_as_default;
    TreeBuilder().fill(child, entry);
    node.given = node.given || child.given;
  }

  /// Values and subsections that the file leaves out are found through the section around them.
  static void set_origins(Node &section) {
    for_each_node(section, [&](Node &node) {
      node.origin = section.origin;
      for (Value &value : node.values)
        value.origin = section.origin;
    });
  }

  static Node &child_for(Node &node, const ScannedEntry &entry) {
    if (Node *fixed = node.find_subsection(entry.name))
      return *fixed;
    const Section *kind = kind_of(*node.declared, entry.name);
    const Path path = below(node.path, entry.name);
    if (kind == nullptr)
      refuse_place(entry.origin, path, unknown_subsection(*node.declared, entry.name));
    if (kind->name() == entry.name)
      refuse_place(entry.origin, path,
                   "a name is missing; write 'subsection " + entry.name + " NAME'");
    const std::string name = entry.name.substr(kind->name().size() + 1);
    if (!is_instance_name(name))
      refuse_place(entry.origin, path,
                   "'" + name + "' cannot be a name: use letters, digits, '_' and '-'");
    return add_instance(node, *kind, name, path);
  }

  static Node &add_instance(Node &node, const Section &kind, const std::string &name,
                            const Path &path) {
    std::size_t position = 0;
    while (node.declared->named_subsections()[position].get() != &kind)
      ++position;
    Node instance = default_node(kind, path, node.origin);
    instance.instance = name;
    node.instances[position].emplace_back(std::move(instance));
    return node.instances[position].back().own();
  }

  [[noreturn]] static void refuse_duplicate(const Node &node, const ScannedEntry &entry,
                                            const Origin &earlier) {
    const Path path = below(node.path, entry.name);
    const bool is_key = entry.kind == ScannedEntry::Kind::key;
    std::string problem = is_key ? "this key is set twice" : "this subsection stands here twice";
    if (earlier.line > 0)
      problem += "; first at " + place(earlier, {});
    if (is_key)
      refuse_value(entry.origin, path, entry.value, problem);
    refuse_place(entry.origin, path, problem);
  }
};

// The sections right below, fixed ones first; the visit says when it is enough.
template <class Tree, class Visit> bool any_below(Tree &node, const Visit &visit) {
  for (auto &subsection : node.subsections)
    if (visit(subsection))
      return true;
  for (auto &kind : node.instances)
    for (auto &instance : kind)
      if (visit(instance))
        return true;
  return false;
}

using Wanted = std::function<bool(const Value &)>;

bool has_value(const Node &node, const Wanted &wanted) {
  return std::any_of(node.values.begin(), node.values.end(), wanted);
}

bool contains_value(const Node &node, const Wanted &wanted) {
  return has_value(node, wanted) ||
         any_below(node, [&](const Node &below) { return contains_value(below, wanted); });
}

// The child that is asked for, to be changed.
template <class Children, class Find> Node *own_child(Children &children, const Find &is_wanted) {
  for (Shared<Node> &child : children)
    if (is_wanted(child.get()))
      return &child.own();
  return nullptr;
}

} // namespace

const Value *Node::find_value(const std::string &key) const {
  for (const Value &value : values)
    if (value.key->name == key)
      return &value;
  return nullptr;
}

const Node *Node::find_subsection(const std::string &name) const {
  for (const Node &subsection : subsections)
    if (subsection.declared->name() == name)
      return &subsection;
  return nullptr;
}

const Node *Node::find_instance(const std::string &kind, const std::string &name) const {
  for (const std::vector<Shared<Node>> &of_kind : instances)
    for (const Node &node : of_kind)
      if (node.declared->name() == kind && node.instance == name)
        return &node;
  return nullptr;
}

Value *Node::find_value(const std::string &key) {
  return const_cast<Value *>(std::as_const(*this).find_value(key));
}
Node *Node::find_subsection(const std::string &name) {
  return own_child(subsections, [&](const Node &node) { return node.declared->name() == name; });
}
Node *Node::find_instance(const std::string &kind, const std::string &name) {
  for (std::vector<Shared<Node>> &of_kind : instances)
    if (Node *node = own_child(of_kind, [&](const Node &candidate) {
          return candidate.declared->name() == kind && candidate.instance == name;
        }))
      return node;
  return nullptr;
}

Node default_node(const Section &declared, const Path &path, const Origin &origin) {
  Node node{.declared = &declared, .path = path, .origin = origin};
  for (const Key &key : declared.keys())
    node.values.push_back({.key = &key, .text = normalised(key.default_value), .origin = origin});
  for (const auto &subsection : declared.subsections())
    node.subsections.emplace_back(
        default_node(*subsection, below(path, subsection->name()), origin));
  node.instances.resize(declared.named_subsections().size());
  return node;
}

Node build_tree(const Section &declarations, const ScannedEntry &file) {
  Node root = default_node(declarations, {}, file.origin);
  root.given = true;
  TreeBuilder().fill(root, file);
  return root;
}

std::vector<std::string> subsection_names(const Section &section) {
  Path names;
  for (const auto &subsection : section.subsections())
    names.push_back(subsection->name());
  for (const auto &kind : section.named_subsections())
    names.push_back(kind->name() + " NAME");
  return names;
}

std::string unknown_key(const Section &section, const std::string &name) {
  Path known;
  for (const Key &key : section.keys())
    known.push_back(key.name);
  if (name == "Like")
    return "Like must only be set in the file, in a section with a name of its own: subsection "
           "KIND "
           "NAME";
  const std::string problem = "there is no key '" + name + "' here";
  if (const std::string near = suggestion(name, known); !near.empty())
    return problem + near;
  for (const auto &subsection : section.subsections())
    if (subsection->find_key(name) != nullptr)
      return problem + "; it belongs into the subsection '" + subsection->name() + "'";
  return problem + "; " + (known.empty() ? "it has none" : "possible are: " + join(known, ", "));
}

std::string unknown_subsection(const Section &section, const std::string &name) {
  const std::string problem = "there is no subsection '" + name + "' here";
  const std::string first_words = name.substr(0, name.rfind(' '));
  Path kinds;
  for (const auto &kind : section.named_subsections())
    kinds.push_back(kind->name());
  Path fixed;
  for (const auto &subsection : section.subsections())
    fixed.push_back(subsection->name());
  if (const std::string near = nearest(name, fixed); !near.empty())
    return problem + "; did you mean '" + near + "'?";
  if (const std::string near = nearest(first_words, kinds); !near.empty())
    return problem + "; did you mean '" + near + " " +
           (first_words == name ? "NAME" : name.substr(first_words.size() + 1)) + "'?";
  const Path all = subsection_names(section);
  return problem + "; " + (all.empty() ? "it has none" : "possible are: " + join(all, ", "));
}

const Section *kind_of(const Section &section, const std::string &name) {
  const Section *best = nullptr;
  for (const auto &kind : section.named_subsections()) {
    const bool matches = name == kind->name() || name.starts_with(kind->name() + " ");
    if (matches && (best == nullptr || kind->name().size() > best->name().size()))
      best = kind.get();
  }
  return best;
}

void for_each_node(Node &node, const std::function<void(Node &)> &visit) {
  visit(node);
  any_below(node, [&](Shared<Node> &below) {
    for_each_node(below.own(), visit);
    return false;
  });
}

void for_each_node(const Node &node, const std::function<void(const Node &)> &visit) {
  visit(node);
  any_below(node, [&](const Node &below) {
    for_each_node(below, visit);
    return false;
  });
}

void for_each_node_with(Node &node, const Wanted &wanted,
                        const std::function<void(Node &)> &visit) {
  if (has_value(node, wanted))
    visit(node);
  any_below(node, [&](Shared<Node> &below) {
    if (contains_value(below, wanted))
      for_each_node_with(below.own(), wanted, visit);
    return false;
  });
}

} // namespace vibroimpact::parameters
