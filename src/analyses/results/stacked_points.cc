#include "analyses/results/stacked_points.h"

#include "common/scalar.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

struct FieldColumn {
  Label label;
  std::vector<std::size_t> shape; ///< the longest of all points
  std::vector<const Field *> fields;
};

std::size_t product(const std::vector<std::size_t> &shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<FieldColumn> columns_of(const std::vector<PointResult> &points) {
  std::vector<FieldColumn> columns;
  std::map<std::string, std::size_t> places;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const Field &field : points[p].fields) {
      const auto [place, added] = places.try_emplace(field.name(), columns.size());
      if (added)
        columns.push_back({.label = field.label,
                           .shape = field.shape,
                           .fields = std::vector<const Field *>(points.size(), nullptr)});
      FieldColumn &column = columns[place->second];
      for (std::size_t k = 0; k < field.shape.size(); ++k)
        column.shape[k] = std::max(column.shape[k], field.shape[k]);
      column.fields[p] = &field;
    }
  return columns;
}

void add_column(const FieldWriter &result, const FieldColumn &column,
                const std::string &dimension) {
  const Label &label = column.label;
  std::vector<std::string> dimensions = {dimension};
  dimensions.insert(dimensions.end(), label.dimensions().begin(), label.dimensions().end());
  std::vector<std::size_t> shape = {column.fields.size()};
  shape.insert(shape.end(), column.shape.begin(), column.shape.end());
  std::vector<double> values(product(shape), nan);
  for (std::size_t p = 0; p < column.fields.size(); ++p)
    if (column.fields[p] != nullptr)
      copy_block(*column.fields[p], column.shape, values.data() + p * product(column.shape));
  result.array({label.name(), label.unit(), label.description(), dimensions}, std::move(shape),
               std::move(values));
}

} // namespace

void add_stacked(const FieldWriter &result, const std::vector<PointResult> &points,
                 const std::string &dimension) {
  for (const FieldColumn &column : columns_of(points))
    add_column(result, column, dimension);
}

void summarise(const FieldWriter &result, const std::string &kind,
               const std::vector<PointResult> &points, const std::vector<std::string> &names) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Field &field : points[i].fields)
      if (std::find(names.begin(), names.end(), field.name()) != names.end())
        result.line(kind + "[" + std::to_string(i + 1) + "]." + field.name(), field.values[0],
                    field.unit());
}

void copy_block(const Field &field, const std::vector<std::size_t> &full, double *target) {
  if (field.shape == full) {
    std::copy(field.values.begin(), field.values.end(), target);
    return;
  }
  for (std::size_t flat = 0; flat < field.values.size(); ++flat) {
    std::size_t rest = flat, position = 0, stride = 1;
    for (std::size_t d = full.size(); d-- > 0;) {
      position += stride * (rest % field.shape[d]);
      rest /= field.shape[d];
      stride *= full[d];
    }
    target[position] = field.values[flat];
  }
}

} // namespace vibroimpact::analyses
