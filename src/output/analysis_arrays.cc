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

/// The same for the field at `place` in its point: most points hold the same fields in one order.
AssembledField *find_assembled(std::vector<AssembledField> &fields, const std::string &name,
                               std::size_t place) {
  return place < fields.size() && fields[place].name == name ? &fields[place]
                                                             : find_named(fields, name);
}

void note_dimensions(const Field &field, std::vector<InnerDimension> &dimensions) {
  for (std::size_t d = 0; d < field.dimensions.size(); ++d) {
    InnerDimension *dimension = find_named(dimensions, field.dimensions[d]);
    if (dimension == nullptr)
      dimension = &dimensions.emplace_back(InnerDimension{field.dimensions[d], 0, ""});
    dimension->length = std::max(dimension->length, field.shape[d]);
  }
}

void note_field(const Field &field, std::size_t place, std::vector<AssembledField> &fields) {
  const AssembledField *known = find_assembled(fields, field.name, place);
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

/// True when every finished point has the field, always with the same values.
bool same_in_all_points(const AssembledField &field, const PointSequence &points) {
  std::vector<double> first;
  bool found = false;
  bool same = true;
  points([&](const PointResult &point) {
    if (point.status != Status::finished || !same)
      return;
    const Field *here = find_field(point, field.name);
    same = here != nullptr && (!found || here->values == first);
    if (same && !found)
      first = here->values;
    found = true;
  });
  return found && same;
}

void choose_coordinates(AnalysisArrays &arrays, const PointSequence &points) {
  for (AssembledField &field : arrays.fields) {
    if (field.inner_dimensions.size() != 1 ||
        !named_like(field.name, field.inner_dimensions.front()))
      continue;
    InnerDimension &dimension = *find_named(arrays.dimensions, field.inner_dimensions.front());
    if (!dimension.coordinate.empty() || !above_all_users(field, arrays.fields) ||
        !same_in_all_points(field, points))
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

Shape inner_shape(const AssembledField &field, std::vector<InnerDimension> &dimensions) {
  Shape shape;
  for (const std::string &name : field.inner_dimensions)
    shape.push_back(find_named(dimensions, name)->length);
  return shape;
}

void make_room(AnalysisArrays &arrays, const Shape &outer) {
  for (AssembledField &field : arrays.fields) {
    const Shape inner = inner_shape(field, arrays.dimensions);
    if (field.over_axes)
      field.shape = outer;
    field.shape.insert(field.shape.end(), inner.begin(), inner.end());
    field.values.assign(number_of_values(field.shape), missing_value);
  }
}

void fill_point(const PointResult &point, std::size_t position, std::size_t outer_dimensions,
                std::vector<AssembledField> &fields) {
  for (std::size_t place = 0; place < point.fields.size(); ++place) {
    const Field &here = point.fields[place];
    AssembledField &field = *find_assembled(fields, here.name, place);
    if (!field.over_axes && point.status != Status::finished)
      continue; // only finished points agree on a coordinate
    const auto inner_begin = field.shape.begin() + (field.over_axes ? outer_dimensions : 0);
    const Shape inner(inner_begin, field.shape.end());
    const std::size_t start = field.over_axes ? position * number_of_values(inner) : 0;
    copy_block(here, inner, field.values.data() + start);
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

AnalysisArrays assemble(const AnalysisHeader &header, const PointSequence &points) {
  const Shape outer = outer_shape(header);
  AnalysisArrays arrays;
  arrays.status.assign(number_of_values(outer), static_cast<std::int64_t>(Status::missing));
  arrays.reason.assign(number_of_values(outer), "");
  points([&](const PointResult &point) {
    const std::size_t position = flat_index(point.index, outer);
    arrays.status[position] = static_cast<std::int64_t>(point.status);
    arrays.reason[position] = point.reason;
    for (std::size_t place = 0; place < point.fields.size(); ++place) {
      note_dimensions(point.fields[place], arrays.dimensions);
      note_field(point.fields[place], place, arrays.fields);
    }
  });
  choose_coordinates(arrays, points);
  make_room(arrays, outer);
  points([&](const PointResult &point) {
    fill_point(point, flat_index(point.index, outer), outer.size(), arrays.fields);
  });
  return arrays;
}

} // namespace vibroimpact
