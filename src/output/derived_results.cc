#include "output/derived_results.h"

#include "output/summary.h"

#include <algorithm>
#include <numeric>

namespace vibroimpact::output {

namespace {

using derived::DerivedArray;
using derived::LabelledArray;

constexpr std::size_t longest_summary = 100;

/// Its coordinate field, or an index from 1.
Axis inner_axis(const InnerDimension &dimension, const AnalysisArrays &arrays) {
  const auto field = std::find_if(
      arrays.fields.begin(), arrays.fields.end(), [&](const AssembledField &candidate) {
        return !candidate.over_axes && candidate.name() == dimension.coordinate;
      });
  if (field != arrays.fields.end())
    return {dimension.name, field->values, {}, field->label.unit(), field->label.description()};
  Axis axis{dimension.name, std::vector<double>(dimension.length), {}, "1", "index from 1"};
  std::iota(axis.values.begin(), axis.values.end(), 1);
  return axis;
}

LabelledArray labelled(const AnalysisHeader &header, const AssembledField &field) {
  LabelledArray array{field.name(), field.label.unit(), field.label.description(),
                      {},           field.shape,        field.values.data()};
  if (field.over_axes)
    for (const Axis &axis : header.axes)
      array.dimensions.push_back(axis.name);
  array.dimensions.insert(array.dimensions.end(), field.inner_dimensions().begin(),
                          field.inner_dimensions().end());
  return array;
}

std::string index_text(std::size_t flat, const Shape &shape) {
  std::string text;
  for (std::size_t d = shape.size(); d-- > 0;) {
    text = std::to_string(flat % shape[d] + 1) + (text.empty() ? "" : "," + text);
    flat /= shape[d];
  }
  return text.empty() ? text : "[" + text + "]";
}

} // namespace

derived::Source derivation_source(const AnalysisHeader &header, const AnalysisArrays &arrays) {
  derived::Source source{header.axes, {}};
  for (const InnerDimension &dimension : arrays.dimensions)
    source.dimensions.push_back(inner_axis(dimension, arrays));
  for (const AssembledField &field : arrays.fields)
    source.arrays.push_back(labelled(header, field));
  return source;
}

std::string derived_summary(const AnalysisHeader &header,
                            const std::vector<DerivedArray> &quantities) {
  std::string text;
  for (const DerivedArray &quantity : quantities) {
    if (quantity.values.size() > longest_summary || !quantity.own_dimensions.empty())
      continue;
    const std::string name = "analysis." + header.name + ".derived." + quantity.name;
    for (std::size_t i = 0; i < quantity.values.size(); ++i)
      text += summary_line(name + index_text(i, quantity.shape), quantity.values[i], quantity.unit);
  }
  return text;
}

} // namespace vibroimpact::output
