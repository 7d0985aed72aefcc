// A random model as a system, at the values of its keys in the file and at others.
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "analyses/run/system.h"
#include "reduction/reduced_body.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::testing {

using Overrides = std::vector<parameters::Override>;

class KeyedModel {
public:
  /// `text`: a parameter file with an analysis "a". `folder` has the record.
  KeyedModel(std::string text, std::string folder)
      : text_(std::move(text)), folder_(std::move(folder)) {}

  void set_tolerance(double relative) { tolerance_ = relative; }

  /// InputError when it is not a model.
  std::shared_ptr<const parameters::ParameterSet> set(Overrides overrides) const;
  analyses::System build(const Overrides &overrides) const;
  /// Keys that most models have, as far as this one has them.
  std::vector<analyses::SweptParameter> keys() const;

private:
  std::vector<std::shared_ptr<const reduction::ReducedBody>>
  reduce(const parameters::Values &root) const;

  std::string text_, folder_;
  double tolerance_ = 1e-10;
  mutable std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies_;
};

} // namespace vibroimpact::testing
