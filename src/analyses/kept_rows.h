// Rows of a table as steps of its computation (step_record.h). Labels are kept where they are
// others than those of the row before.
#pragma once

#include "common/result_sink.h"
#include "common/step_record.h"

#include <functional>

namespace vibroimpact::analyses {

class KeptRows {
public:
  /// Keeps a reference; null: nothing is kept.
  explicit KeptRows(StepRecord *steps) : steps_(steps) {}

  /// Fields and reason of what `compute` gives, or gave in the run that has kept it.
  PointResult operator()(const std::function<PointResult()> &compute);

private:
  StepRecord *steps_;
  std::vector<Label> labels_; ///< of the row before
};

} // namespace vibroimpact::analyses
