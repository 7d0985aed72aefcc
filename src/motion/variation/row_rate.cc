#include "motion/variation/row_rate.h"

#include "motion/steps/source_step.h"

namespace vibroimpact::motion {

double rate_of_row(const Equations &equations, const RowVector &row, double time,
                   const Vector &rates) {
  const Index size = equations.layout().physical_size();
  double rate = row.head(size).dot(rates.head(size));
  std::vector<SourceValues> values;
  equations.source_values(time, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto form_then = equations.model().sources()[k].function->exponential_form(time);
    const auto of = row.segment(size + 3 * static_cast<Index>(k), 3);
    rate += of[0] * values[k][1] + of[1] * values[k][2] +
            (form_then ? of[2] * third_derivative(*form_then, time) : 0);
  }
  return rate;
}

} // namespace vibroimpact::motion
