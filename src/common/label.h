// What a number of a result is called. The points of a sweep share their names, units and
// descriptions by the million: each is kept once for as long as the program runs, and a label is no
// more than the place where it is kept. A recorder makes its labels when it is made, not for every
// point.
#pragma once

#include <string>
#include <vector>

namespace vibroimpact {

class Label {
public:
  Label() : Label("", "", "") {}
  /// `dimensions`: names of the inner dimensions; none for a scalar.
  Label(std::string name, std::string unit, std::string description,
        std::vector<std::string> dimensions = {});

  const std::string &name() const { return text_->name; }
  const std::string &unit() const { return text_->unit; }
  const std::string &description() const { return text_->description; }
  const std::vector<std::string> &dimensions() const { return text_->dimensions; }

  /// Equal texts are kept in the same place.
  friend bool operator==(const Label &, const Label &) = default;

private:
  struct Text {
    std::string name, unit, description;
    std::vector<std::string> dimensions;
    friend bool operator==(const Text &, const Text &) = default;
  };
  struct Hash {
    std::size_t operator()(const Text &text) const { return std::hash<std::string>()(text.name); }
  };
  static const Text &kept(Text text);

  const Text *text_;
};

} // namespace vibroimpact
