#include "derived/analysis_arrays.h"

#include "analyses/results/stacked_points.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace vibroimpact::derived {

namespace {

constexpr double missing_value = std::numeric_limits<double>::quiet_NaN();

std::size_t flat_index(const std::vector<std::size_t> &index, const Shape &shape) {
  std::size_t flat = 0;
  for (std::size_t axis = 0; axis < shape.size(); ++axis)
    flat = flat * shape[axis] + index[axis];
  return flat;
}

/// The one of the same name as the field at `place` in its point: most points hold the same fields
/// in one order.
AssembledField *find_assembled(std::vector<AssembledField> &fields, const Field &field,
                               std::size_t place) {
  if (place < fields.size() && fields[place].label == field.label)
    return &fields[place];
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const AssembledField &item) {
    return item.name() == field.name();
  });
  return found == fields.end() ? nullptr : &*found;
}

InnerDimension *find_dimension(std::vector<InnerDimension> &dimensions, const std::string &name) {
  const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                  [&](const InnerDimension &item) { return item.name == name; });
  return found == dimensions.end() ? nullptr : &*found;
}

void note_dimensions(const Field &field, std::vector<InnerDimension> &dimensions) {
  for (std::size_t d = 0; d < field.shape.size(); ++d) {
    const std::string &name = field.dimensions()[d];
    InnerDimension *dimension = find_dimension(dimensions, name);
    if (dimension == nullptr)
      dimension = &dimensions.emplace_back(InnerDimension{name, 0, ""});
    dimension->length = std::max(dimension->length, field.shape[d]);
  }
}

void note_field(const Field &field, std::size_t place, std::vector<AssembledField> &fields) {
  const AssembledField *known = find_assembled(fields, field, place);
  if (known == nullptr)
    fields.push_back({.label = field.label});
  else if (known->inner_dimensions() != field.dimensions())
    throw std::logic_error("field " + field.name() + " has other dimensions in another point");
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
  const std::string group = coordinate.name().substr(0, coordinate.name().rfind('/') + 1);
  return std::all_of(fields.begin(), fields.end(), [&](const AssembledField &field) {
    const auto &used = field.inner_dimensions();
    return std::find(used.begin(), used.end(), coordinate.inner_dimensions()[0]) == used.end() ||
           field.name().starts_with(group);
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
    const Field *here = analyses::find(point, field.name());
    same = here != nullptr && (!found || here->values == first);
    if (same && !found)
      first = here->values;
    found = true;
  });
  return found && same;
}

void choose_coordinates(AnalysisArrays &arrays, const PointSequence &points) {
  for (AssembledField &field : arrays.fields) {
    if (field.inner_dimensions().size() != 1 ||
        !named_like(field.name(), field.inner_dimensions().front()))
      continue;
    InnerDimension &dimension =
        *find_dimension(arrays.dimensions, field.inner_dimensions().front());
    if (!dimension.coordinate.empty() || !above_all_users(field, arrays.fields) ||
        !same_in_all_points(field, points))
      continue;
    dimension.coordinate = field.name();
    field.over_axes = false;
  }
}

void make_room(AnalysisArrays &arrays, const Shape &outer) {
  for (AssembledField &field : arrays.fields) {
    for (const std::string &name : field.inner_dimensions())
      field.inner_shape.push_back(find_dimension(arrays.dimensions, name)->length);
    if (field.over_axes)
      field.shape = outer;
    field.shape.insert(field.shape.end(), field.inner_shape.begin(), field.inner_shape.end());
    field.values.assign(number_of_values(field.shape), missing_value);
  }
}

void fill_point(const PointResult &point, std::size_t position,
                std::vector<AssembledField> &fields) {
  for (std::size_t place = 0; place < point.fields.size(); ++place) {
    const Field &here = point.fields[place];
    AssembledField &field = *find_assembled(fields, here, place);
    if (!field.over_axes && point.status != Status::finished)
      continue; // only finished points agree on a coordinate
    const std::size_t start = field.over_axes ? position * number_of_values(field.inner_shape) : 0;
    analyses::copy_block(here, field.inner_shape, field.values.data() + start);
  }
}

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
    if (field.shape.size() != field.dimensions().size() ||
        number_of_values(field.shape) != field.values.size())
      throw std::logic_error("the values of field " + field.name() + " do not fill its shape");
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
    fill_point(point, flat_index(point.index, outer), arrays.fields);
  });
  return arrays;
}

Source derivation_source(const AnalysisHeader &header, const AnalysisArrays &arrays) {
  Source source{header.axes, {}};
  for (const InnerDimension &dimension : arrays.dimensions)
    source.dimensions.push_back(inner_axis(dimension, arrays));
  for (const AssembledField &field : arrays.fields)
    source.arrays.push_back(labelled(header, field));
  return source;
}

} // namespace vibroimpact::derived
