// The evaluations of an objective.
#pragma once

#include "analyses/design/objective.h"
#include "analyses/design/stored_evaluations.h"

namespace vibroimpact::analyses {

using Evaluation = EvaluationOf<DesignValue>;

class Evaluations : public StoredEvaluations<DesignValue> {
public:
  /// Keeps references.
  Evaluations(const std::vector<DesignKey> &keys, const Objective &objective, std::size_t line,
              std::size_t most, LineContext &context)
      : StoredEvaluations(keys, line, most, context), search_keys_(keys), objective_(objective) {}

private:
  DesignValue compute(const std::vector<parameters::Override> &overrides) const override;
  PointResult point(const std::vector<std::size_t> &index,
                    const Evaluation &evaluation) const override;
  DesignValue read(const PointResult &point) const override;

  const std::vector<DesignKey> &search_keys_;
  const Objective &objective_;
};

/// Name of the field of an objective.
std::string goal_field(const Objective &objective, std::size_t goal);
/// Of a point that an earlier run has stored.
DesignValue stored_design_value(const PointResult &point, const Objective &objective);
/// The fields of an evaluation with this index, to which more may be added.
PointResult evaluation_point(const std::vector<std::size_t> &index, const Evaluation &evaluation,
                             const std::vector<DesignKey> &keys, const Objective &objective);

} // namespace vibroimpact::analyses
