// Disjoint sets of nodes that grow together.
#pragma once

#include <numeric>
#include <vector>

namespace vibroimpact::structure {

class NodeSets {
public:
  /// Each node by itself.
  explicit NodeSets(std::size_t nodes) : parent_(nodes), count_(static_cast<int>(nodes)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void join(int first, int second) {
    first = root(first);
    second = root(second);
    count_ -= first != second;
    parent_[first] = second;
  }
  int count() const { return count_; }
  /// Those of two nodes and more, each ascending, in the order of their first nodes.
  std::vector<std::vector<int>> joined();

private:
  int root(int node) {
    while (parent_[node] != node)
      node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  std::vector<int> parent_;
  int count_;
};

} // namespace vibroimpact::structure
