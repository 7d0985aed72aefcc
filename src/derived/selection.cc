// The part of a field at one place of an axis, or of several.
#include "derived/operation.h"
#include "derived/units_of_fields.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::derived {

namespace {

struct Place {
  std::string axis;
  std::string coordinate;
};

/// "direction = forward, frequency = 3 Hz"
std::vector<Place> places(const parameters::Values &section) {
  std::vector<Place> places;
  for (const std::string &part : parameters::split_list(section.text("Where"))) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      section.reject("Where", "must be AXIS = COORDINATE, several of them separated by commas; '" +
                                  part + "' has no '='.");
    places.push_back({parameters::normalised(part.substr(0, equals)),
                      parameters::normalised(part.substr(equals + 1))});
  }
  return places;
}

std::size_t labelled_position(const parameters::Values &section, const Axis &axis,
                              const std::string &label) {
  const auto found = std::find(axis.labels.begin(), axis.labels.end(), label);
  if (found == axis.labels.end())
    section.reject("Where", "must have for " + axis.name + " one of " +
                                parameters::join(axis.labels, ", ") + "; '" + label +
                                "' is none of them.");
  return static_cast<std::size_t>(found - axis.labels.begin());
}

std::size_t numbered_position(const parameters::Values &section, const Axis &axis,
                              const std::string &text) {
  const parameters::Number unit = one(axis.unit);
  const double wanted = section.part("Where", text, unit.dimension) / unit.value;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < axis.size(); ++i)
    if (std::abs(axis.values[i] - wanted) < std::abs(axis.values[nearest] - wanted))
      nearest = i;
  const double found = axis.values[nearest];
  if (!(std::abs(found - wanted) <= 1e-9 * std::max(std::abs(found), std::abs(wanted))))
    section.reject("Where", "must have a value of " + axis.name + "; the nearest to '" + text +
                                "' is " + parameters::number_text(found) + " " + axis.unit + ".");
  return nearest;
}

std::size_t position_on(const parameters::Values &section, const Axis &axis,
                        const std::string &coordinate) {
  return axis.labels.empty() ? numbered_position(section, axis, coordinate)
                             : labelled_position(section, axis, coordinate);
}

DerivedArray slice(const Request &request, const LabelledArray &array, const Place &place) {
  const Axis axis = request.axis("Where", place.axis, array);
  const std::size_t position = position_on(request.section(), axis, place.coordinate);
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(
      array.unit, array.name + " at " + axis.name + " = " + place.coordinate, dimensions, shape);
  result.name = array.name;
  result.axis = array.axis;
  for_each_line(frame, along, {frame.operand(array)},
                [&](std::size_t k, const auto &lines) { result.values[k] = lines[0][position]; });
  return result;
}

} // namespace

void check_places(const parameters::Values &section, const AxisNames &names) {
  for (const Place &place : places(section))
    if (const Axis *axis = names.find(place.axis))
      position_on(section, *axis, place.coordinate);
}

DerivedArray select(const Request &request) {
  const LabelledArray array = request.array("Field");
  const std::vector<Place> all = places(request.section());
  DerivedArray result = slice(request, array, all.at(0));
  for (std::size_t p = 1; p < all.size(); ++p)
    result = slice(request, result.view(), all[p]);
  result.description =
      request.result("", array.name + " at " + request.section().text("Where"), {}, {}).description;
  return result;
}

} // namespace vibroimpact::derived
