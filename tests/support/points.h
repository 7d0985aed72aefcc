// A line context for tests: keeps what an analysis stores.
#pragma once

#include "analyses/analysis.h"

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibroimpact::testing {

class Points : public analyses::LineContext {
public:
  Points() = default;
  /// Builds systems at other values of keys by `source`.
  explicit Points(analyses::SystemSource source) : source_(std::move(source)) {}

  const PointResult *find(const std::vector<std::size_t> &index) const override {
    const auto known = earlier_.find(index);
    return known == earlier_.end() ? nullptr : &known->second;
  }
  void store(PointResult result) override { stored_[result.index] = std::move(result); }
  void skip() override {}
  analyses::System build(const std::vector<parameters::Override> &overrides) const override {
    return source_(overrides);
  }

  /// From now on the point counts as that of an earlier run.
  void know(PointResult result) { earlier_[result.index] = std::move(result); }
  const std::map<std::vector<std::size_t>, PointResult> &all() const { return stored_; }

  const std::vector<double> &values(const std::vector<std::size_t> &index,
                                    const std::string &name) const {
    for (const Field &field : stored_.at(index).fields)
      if (field.name() == name)
        return field.values;
    throw std::logic_error("no field " + name);
  }
  double value(const std::vector<std::size_t> &index, const std::string &name) const {
    return values(index, name).at(0);
  }

private:
  analyses::SystemSource source_;
  std::map<std::vector<std::size_t>, PointResult> earlier_;
  std::map<std::vector<std::size_t>, PointResult> stored_;
};

} // namespace vibroimpact::testing
