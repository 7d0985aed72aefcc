#include "output/analysis_arrays.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace vibroimpact {

namespace {

constexpr double missing_value = std::numeric_limits<double>::quiet_NaN();

std::size_t flat_index(const std::vector<std::size_t> &index, const Shape &shape) {
  std::size_t flat = 0;
  for (std::size_t axis = 0; axis < shape.size(); ++axis)
    flat = flat * shape[axis] + index[axis];
  return flat;
}

const Field *find_field(const PointResult &point, const std::string &name) {
  const auto found = std::find_if(point.fields.begin(), point.fields.end(),
                                  [&](const Field &field) { return field.name == name; });
  return found == point.fields.end() ? nullptr : &*found;
}

template <class Named> Named *find_named(std::vector<Named> &list, const std::string &name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Named &item) { return item.name == name; });
  return found == list.end() ? nullptr : &*found;
}

void note_dimensions(const Field &field, std::vector<InnerDimension> &dimensions) {
  for (std::size_t d = 0; d < field.dimensions.size(); ++d) {
    InnerDimension *dimension = find_named(dimensions, field.dimensions[d]);
    if (dimension == nullptr)
      dimension = &dimensions.emplace_back(InnerDimension{field.dimensions[d], 0, ""});
    dimension->length = std::max(dimension->length, field.shape[d]);
  }
}

void note_field(const Field &field, std::vector<AssembledField> &fields) {
  const AssembledField *known = find_named(fields, field.name);
  if (known != nullptr && known->inner_dimensions != field.dimensions)
    throw std::logic_error("field " + field.name + " has other dimensions in another point");
  if (known == nullptr)
    fields.push_back({field.name, field.unit, field.description, field.dimensions, true, {}, {}});
}

/// "time" of the dimension "time", and so is "identification/impulse_axis" of "impulse_axis".
bool named_like(const std::string &field, const std::string &dimension) {
  const std::string ending = "/" + dimension;
  return field == dimension ||
         (field.size() > ending.size() &&
          field.compare(field.size() - ending.size(), ending.size(), ending) == 0);
}

/// A reader finds a dimension in the group of a dataset or above; so must its coordinate be.
bool above_all_users(const AssembledField &coordinate, const std::vector<AssembledField> &fields) {
  const std::string group = coordinate.name.substr(0, coordinate.name.rfind('/') + 1);
  return std::all_of(fields.begin(), fields.end(), [&](const AssembledField &field) {
    const auto &used = field.inner_dimensions;
    return std::find(used.begin(), used.end(), coordinate.inner_dimensions[0]) == used.end() ||
           field.name.rfind(group, 0) == 0;
  });
}

bool same_in_all_points(const AssembledField &field, const PointMap &points) {
  const Field *first = nullptr;
  for (const auto &[index, point] : points) {
    if (point.status != Status::finished)
      continue;
    const Field *here = find_field(point, field.name);
    if (here == nullptr || (first != nullptr && here->values != first->values))
      return false;
    first = here;
  }
  return first != nullptr;
}

void choose_coordinates(AnalysisArrays &arrays, const PointMap &points) {
  for (AssembledField &field : arrays.fields) {
    if (field.inner_dimensions.size() != 1 ||
        !named_like(field.name, field.inner_dimensions.front()) ||
        !above_all_users(field, arrays.fields) || !same_in_all_points(field, points))
      continue;
    InnerDimension &dimension = *find_named(arrays.dimensions, field.inner_dimensions.front());
    if (!dimension.coordinate.empty())
      continue;
    dimension.coordinate = field.name;
    field.over_axes = false;
  }
}

/// Copies a row-major block into the corner of a larger one of shape `full`.
void copy_block(const Field &field, const Shape &full, double *target) {
  for (std::size_t flat = 0; flat < field.values.size(); ++flat) {
    std::size_t rest = flat;
    std::size_t position = 0;
    std::size_t stride = 1;
    for (std::size_t d = full.size(); d-- > 0;) {
      position += stride * (rest % field.shape[d]);
      rest /= field.shape[d];
      stride *= full[d];
    }
    target[position] = field.values[flat];
  }
}

void fill(AssembledField &field, const std::vector<InnerDimension> &dimensions, const Shape &outer,
          const PointMap &points) {
  Shape inner;
  for (const std::string &name : field.inner_dimensions)
    inner.push_back(
        std::find_if(dimensions.begin(), dimensions.end(), [&](const InnerDimension &dimension) {
          return dimension.name == name;
        })->length);
  if (field.over_axes)
    field.shape = outer;
  field.shape.insert(field.shape.end(), inner.begin(), inner.end());
  field.values.assign(number_of_values(field.shape), missing_value);
  for (const auto &[index, point] : points) {
    if (!field.over_axes && point.status != Status::finished)
      continue; // only finished points agree on a coordinate
    const std::size_t start =
        field.over_axes ? flat_index(index, outer) * number_of_values(inner) : 0;
    if (const Field *here = find_field(point, field.name))
      copy_block(*here, inner, field.values.data() + start);
  }
}

} // namespace

Shape outer_shape(const AnalysisHeader &header) {
  Shape shape;
  for (const Axis &axis : header.axes)
    shape.push_back(axis.size());
  return shape;
}

void check_point(const AnalysisHeader &header, const PointResult &result) {
  const Shape outer = outer_shape(header);
  bool inside = result.index.size() == outer.size();
  for (std::size_t axis = 0; inside && axis < outer.size(); ++axis)
    inside = result.index[axis] < outer[axis];
  if (!inside)
    throw std::logic_error("a point of analysis " + header.name + " lies outside its axes");
  for (const Field &field : result.fields)
    if (field.shape.size() != field.dimensions.size() ||
        number_of_values(field.shape) != field.values.size())
      throw std::logic_error("the values of field " + field.name + " do not fill its shape");
}

AnalysisArrays assemble(const AnalysisHeader &header, const PointMap &points) {
  const Shape outer = outer_shape(header);
  AnalysisArrays arrays;
  arrays.status.assign(number_of_values(outer), static_cast<std::int64_t>(Status::missing));
  arrays.reason.assign(number_of_values(outer), "");
  for (const auto &[index, point] : points) {
    arrays.status[flat_index(index, outer)] = static_cast<std::int64_t>(point.status);
    arrays.reason[flat_index(index, outer)] = point.reason;
    for (const Field &field : point.fields) {
      note_dimensions(field, arrays.dimensions);
      note_field(field, arrays.fields);
    }
  }
  choose_coordinates(arrays, points);
  for (AssembledField &field : arrays.fields)
    fill(field, arrays.dimensions, outer, points);
  return arrays;
}

} // namespace vibroimpact
