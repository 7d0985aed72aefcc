#include "analyses/run/single_point.h"

#include "common/error.h"

namespace vibroimpact::analyses {

void run_single_point(LineContext &context, const std::function<PointResult()> &compute) {
  if (context.find({})) {
    context.skip();
    return;
  }
  PointResult result;
  try {
    result = compute();
  } catch (const NumericalError &error) {
    result = {.index = {}, .status = Status::failed, .reason = error.what()};
  }
  context.store(std::move(result));
}

} // namespace vibroimpact::analyses
