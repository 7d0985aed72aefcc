// The parameters of one file as a tree: every declared key with its value, default or given.
#pragma once

#include "parameters/expression.h"
#include "parameters/scanned_file.h"
#include "parameters/section.h"
#include "parameters/shared.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

struct Value {
  const Key *key = nullptr;
  std::string text; ///< as written, normalised
  Origin origin{};  ///< of the section if not given
  bool given = false;
  std::vector<Number> numbers{}; ///< of quantities and integers, once checked
};

/// One section. Copies share the sections below until one of them changes.
struct Node {
  const Section *declared = nullptr;
  std::string instance{};        ///< name of a named subsection
  std::vector<std::string> path; ///< {"Body left", "Geometry"}
  Origin origin{};               ///< of the nearest section around it if it is not in the file
  bool given = false;
  std::vector<Value> values{};             ///< like declared->keys()
  std::vector<Shared<Node>> subsections{}; ///< like declared->subsections()
  /// Like declared->named_subsections(), in file order.
  std::vector<std::vector<Shared<Node>>> instances{};

  const Value *find_value(const std::string &key) const;
  const Node *find_subsection(const std::string &name) const;
  const Node *find_instance(const std::string &kind, const std::string &name) const;
  Value *find_value(const std::string &key);
  Node *find_subsection(const std::string &name);
  Node *find_instance(const std::string &kind, const std::string &name);
};

/// The section with its defaults and no named subsection.
Node default_node(const Section &declared, const std::vector<std::string> &path,
                  const Origin &origin);

/// The declarations filled with a file. Throws InputError on the first unknown, misplaced or
/// duplicate entry; values are not looked at.
Node build_tree(const Section &declarations, const ScannedEntry &file);

/// Names a section can hold as subsections, kinds as "Body NAME".
std::vector<std::string> subsection_names(const Section &section);

/// The kind that "Body left" is of, the longest if several match; null if none.
const Section *kind_of(const Section &section, const std::string &name);

/// "there is no subsection 'X' here; did you mean 'Y'?" The first words of "Contct heads" are
/// compared with the kinds.
std::string unknown_subsection(const Section &section, const std::string &name);

/// "there is no key 'X' here; did you mean 'Y'?"
std::string unknown_key(const Section &section, const std::string &name);

/// Calls `visit` for the node and all below it, in declared order.
void for_each_node(Node &node, const std::function<void(Node &)> &visit);
/// The same, only for nodes with a value that is `wanted`: the others stay shared.
void for_each_node_with(Node &node, const std::function<bool(const Value &)> &wanted,
                        const std::function<void(Node &)> &visit);
void for_each_node(const Node &node, const std::function<void(const Node &)> &visit);

} // namespace vibroimpact::parameters
