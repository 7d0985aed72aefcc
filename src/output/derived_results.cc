#include "output/derived_results.h"

namespace vibroimpact::output {

namespace {

using derived::DerivedArray;

constexpr std::size_t longest_summary = 100;

std::string index_text(std::size_t flat, const Shape &shape) {
  std::string text;
  for (std::size_t d = shape.size(); d-- > 0;) {
    text = std::to_string(flat % shape[d] + 1) + (text.empty() ? "" : "," + text);
    flat /= shape[d];
  }
  return text.empty() ? text : "[" + text + "]";
}

} // namespace

SummaryList derived_summary(const AnalysisHeader &header,
                            const std::vector<DerivedArray> &quantities) {
  SummaryList list;
  for (const DerivedArray &quantity : quantities) {
    if (quantity.values.size() > longest_summary || !quantity.own_dimensions.empty())
      continue;
    const std::string name = "analysis." + header.name + ".derived." + quantity.name;
    for (std::size_t i = 0; i < quantity.values.size(); ++i)
      list.add(name + index_text(i, quantity.shape), quantity.values[i], quantity.unit);
  }
  return list;
}

} // namespace vibroimpact::output
