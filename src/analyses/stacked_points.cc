#include "analyses/stacked_points.h"

#include <algorithm>
#include <limits>
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

// Puts a row-major array into a longer one.
void place(const Field &field, const std::vector<std::size_t> &shape, double *into) {
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    std::size_t rest = i, at = 0, stride = 1;
    for (std::size_t k = shape.size(); k-- > 0;) {
      at += rest % field.shape[k] * stride;
      rest /= field.shape[k];
      stride *= shape[k];
    }
    into[at] = field.values[i];
  }
}

Field joined(const FieldColumn &column, const std::string &dimension, const std::string &prefix) {
  std::vector<std::string> dimensions = {dimension};
  dimensions.insert(dimensions.end(), column.label.dimensions().begin(),
                    column.label.dimensions().end());
  Field field{.label = Label(prefix + column.label.name(), column.label.unit(),
                             column.label.description(), dimensions)};
  field.shape = {column.fields.size()};
  field.shape.insert(field.shape.end(), column.shape.begin(), column.shape.end());
  field.values.assign(product(field.shape), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t p = 0; p < column.fields.size(); ++p)
    if (column.fields[p] != nullptr)
      place(*column.fields[p], column.shape, field.values.data() + p * product(column.shape));
  return field;
}

} // namespace

std::vector<Field> stacked(const std::vector<PointResult> &points, const std::string &dimension,
                           const std::string &prefix) {
  std::vector<Field> fields;
  for (const FieldColumn &column : columns_of(points))
    fields.push_back(joined(column, dimension, prefix));
  return fields;
}

} // namespace vibroimpact::analyses
