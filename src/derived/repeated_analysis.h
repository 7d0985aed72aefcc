// The outcomes of analyses at other values of keys: all lines of one run on this rank into memory,
// their points are assembled to arrays as those of a result file, and quantities derived from
// these.
#pragma once

#include "analyses/run/runner.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::derived {

/// One case of the repeated analysis, which may be a parameter grid.
struct Repetition {
  parameters::Values root; ///< of the file with its overrides
  std::string analysis;
  std::vector<analyses::GridKey> keys; ///< none without a grid
  std::vector<Axis> outer_axes;        ///< of the grid
  analyses::CaseFactory factory;
};
/// Local; InputError.
using RepetitionSource = std::function<Repetition(const std::string &analysis,
                                                  const std::vector<parameters::Override> &)>;

class RepeatedAnalysis : public analyses::Outcomes {
public:
  explicit RepeatedAnalysis(RepetitionSource source) : source_(std::move(source)) {}

  void check(const std::string &analysis,
             const std::vector<parameters::Override> &overrides) const override;
  analyses::Evaluated evaluate(const std::string &analysis,
                               const std::vector<parameters::Override> &overrides,
                               const std::vector<std::string> &names,
                               const std::function<void(double share)> &progress) const override;
  std::optional<analyses::Evaluated>
  try_first_point(const std::string &analysis, const std::vector<parameters::Override> &overrides,
                  const std::vector<std::string> &names, double seconds) const override;

private:
  RepetitionSource source_;
};

} // namespace vibroimpact::derived
