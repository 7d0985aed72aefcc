// Largest and smallest values along axes, where they are, and what another field is there.
#include "derived/operation.h"

#include <cmath>

namespace vibroimpact::derived {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

enum class Extreme { maximum, minimum };

const char *word(Extreme extreme) { return extreme == Extreme::maximum ? "largest" : "smallest"; }

/// The first of equal ones; NaN are passed over. With `inside`, nowhere when it is at an end.
std::size_t position_of(Extreme extreme, const Line &line, std::size_t size, bool inside) {
  const double sign = extreme == Extreme::maximum ? 1 : -1;
  std::size_t best = nowhere;
  for (std::size_t i = 0; i < size; ++i)
    if (!std::isnan(line[i]) && (best == nowhere || sign * line[i] > sign * line[best]))
      best = i;
  return inside && (best == 0 || best + 1 == size) ? nowhere : best;
}

struct Vertex {
  double position;
  double value;
};

/// Vertex of the parabola through the extreme value and its two neighbours; the extreme value
/// itself at an end of the axis, beside a NaN, and between equal neighbours.
Vertex parabola_vertex(const std::vector<double> &x, const Line &y, std::size_t best) {
  const Vertex point{x[best], y[best]};
  if (best == 0 || best + 1 == x.size())
    return point;
  const double before = x[best - 1] - x[best];
  const double after = x[best + 1] - x[best];
  const double slope_before = (y[best - 1] - y[best]) / before;
  const double slope_after = (y[best + 1] - y[best]) / after;
  const double curvature = (slope_after - slope_before) / (after - before);
  const double slope = slope_before - curvature * before;
  const double step = -slope / (2 * curvature);
  return std::isfinite(step) ? Vertex{point.position + step, point.value + 0.5 * slope * step}
                             : point;
}

bool only_inside(const Request &request) { return request.section().boolean("Inside"); }

bool refines(const Request &request) { return request.section().choice("Refine") == "parabola"; }

/// Extreme values along one axis, written over the array's other axes.
DerivedArray along_axis(const Request &request, Extreme extreme, const LabelledArray &array,
                        const Axis &axis) {
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result =
      request.result(array.unit, std::string(word(extreme)) + " " + array.name, dimensions, shape);
  const bool refine = refines(request);
  const bool inside = only_inside(request);
  result.axis = array.axis;
  for_each_line(frame, along, {frame.operand(array)}, [&](std::size_t k, const auto &lines) {
    const std::size_t best = position_of(extreme, lines[0], axis.size(), inside);
    if (best != nowhere)
      result.values[k] =
          refine ? parabola_vertex(axis.values, lines[0], best).value : lines[0][best];
  });
  return result;
}

DerivedArray extreme_value(const Request &request, Extreme extreme) {
  const LabelledArray array = request.array("Field");
  std::vector<Axis> axes = request.along(array);
  if (refines(request))
    request.along_one(array, true);
  DerivedArray result = along_axis(request, extreme, array, axes.front());
  for (std::size_t a = 1; a < axes.size(); ++a)
    result = along_axis(request, extreme, result.view(), axes[a]);
  result.description =
      request.result("", std::string(word(extreme)) + " " + array.name, {}, {}).description;
  return result;
}

DerivedArray position(const Request &request, Extreme extreme) {
  const LabelledArray array = request.array("Field");
  const Axis axis = request.along_one(array, true);
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(
      axis.unit, axis.name + " of the " + word(extreme) + " " + array.name, dimensions, shape);
  result.axis = axis.name;
  const bool refine = refines(request);
  const bool inside = only_inside(request);
  for_each_line(frame, along, {frame.operand(array)}, [&](std::size_t k, const auto &lines) {
    const std::size_t best = position_of(extreme, lines[0], axis.size(), inside);
    if (best != nowhere)
      result.values[k] =
          refine ? parabola_vertex(axis.values, lines[0], best).position : axis.values[best];
  });
  return result;
}

DerivedArray value_at(const Request &request, Extreme extreme) {
  const LabelledArray array = request.array("Field");
  const LabelledArray other = request.array("At");
  const Axis axis = request.along_one(array, false);
  const Frame frame({array, other});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(
      other.unit, other.name + " at the " + word(extreme) + " " + array.name, dimensions, shape);
  result.axis = other.axis;
  const bool inside = only_inside(request);
  for_each_line(frame, along, {frame.operand(array), frame.operand(other)},
                [&](std::size_t k, const auto &lines) {
                  const std::size_t best = position_of(extreme, lines[0], axis.size(), inside);
                  result.values[k] = best == nowhere ? no_value : lines[1][best];
                });
  return result;
}

} // namespace

void check_extreme(const parameters::Values &section, const AxisNames &names) {
  if (section.choice("Refine") == "none")
    return;
  if (section.names("Along").size() > 1)
    section.reject("Refine", "must be none when there is more than one axis");
  check_numbered_axes(section, names);
}

void check_position(const parameters::Values &section, const AxisNames &names) {
  check_numbered_axes(section, names);
}

DerivedArray maximum(const Request &request) { return extreme_value(request, Extreme::maximum); }
DerivedArray minimum(const Request &request) { return extreme_value(request, Extreme::minimum); }
DerivedArray position_of_maximum(const Request &request) {
  return position(request, Extreme::maximum);
}
DerivedArray position_of_minimum(const Request &request) {
  return position(request, Extreme::minimum);
}
DerivedArray value_at_maximum(const Request &request) {
  return value_at(request, Extreme::maximum);
}
DerivedArray value_at_minimum(const Request &request) {
  return value_at(request, Extreme::minimum);
}

} // namespace vibroimpact::derived
