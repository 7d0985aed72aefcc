#include "structure/node_sets.h"

#include <algorithm>

namespace vibroimpact::structure {

std::vector<std::vector<int>> NodeSets::joined() {
  std::vector<std::vector<int>> sets;
  std::vector<int> set_of_root(parent_.size(), -1);
  for (int node = 0; node < static_cast<int>(parent_.size()); ++node) {
    int &set = set_of_root[root(node)];
    if (set < 0) {
      set = static_cast<int>(sets.size());
      sets.emplace_back();
    }
    sets[set].push_back(node);
  }
  std::erase_if(sets, [](const std::vector<int> &set) { return set.size() == 1; });
  return sets;
}

} // namespace vibroimpact::structure
