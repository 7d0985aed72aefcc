#include "common/label.h"

#include <unordered_set>
#include <utility>

namespace vibroimpact {

Label::Label(std::string name, std::string unit, std::string description,
             std::vector<std::string> dimensions)
    : text_(&kept({.name = std::move(name),
                   .unit = std::move(unit),
                   .description = std::move(description),
                   .dimensions = std::move(dimensions)})) {}

const Label::Text &Label::kept(Text text) {
  static std::unordered_set<Text, Hash> texts; // what it holds stays where it is
  return *texts.insert(std::move(text)).first;
}

} // namespace vibroimpact
