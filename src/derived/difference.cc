#include "derived/difference.h"

#include "derived/units_of_fields.h"

namespace vibroimpact::derived {

namespace {

LabelledArray other_field(const Request &request, const LabelledArray &field, double &level) {
  if (request.section().has("Level")) {
    level = request.number("Level", field.unit);
    return {"the level", field.unit, "", {}, {}, &level};
  }
  LabelledArray other = request.array("Other");
  if (!(one(other.unit).dimension == one(field.unit).dimension))
    request.section().reject("Other", "must be a field in " + field.unit + ", the unit of " +
                                          field.name + "; this one is in " + other.unit + ".");
  return other;
}

} // namespace

void check_comparison(const parameters::Values &section, const AxisNames &names) {
  if (section.has("Other") && section.has("Level"))
    section.reject("Other", "must not be set when Level is set");
  if (!section.has("Other") && !section.has("Level"))
    section.reject("Other", "must be set when Level is not set");
  check_numbered_axes(section, names);
}

double zero_between(double x_before, double before, double x_after, double after) {
  return x_before + (x_after - x_before) * (before / (before - after));
}

Compared::Compared(const Request &request)
    : field_(request.array("Field")), other_(other_field(request, field_, level_)),
      axis_(request.along_one(field_, true)), frame_({field_, other_}) {}

std::string Compared::other_name() const { return other_.name; }

DerivedArray Compared::result(const Request &request, const std::string &description) const {
  const auto [dimensions, shape] = frame_.without(frame_.position(axis_.name));
  DerivedArray result = request.result(axis_.unit, description, dimensions, shape);
  result.axis = axis_.name;
  return result;
}

void Compared::for_each(const std::function<void(std::size_t, const Difference &)> &visit) const {
  for_each_line(
      frame_, frame_.position(axis_.name), {frame_.operand(field_), frame_.operand(other_)},
      [&](std::size_t k, const auto &lines) { visit(k, Difference(lines[0], lines[1])); });
}

} // namespace vibroimpact::derived
