#include "analyses/recorders/channels.h"

#include <array>

namespace vibroimpact::analyses {

namespace {

using model::Model;
using model::MotionAxis;
using model::PointReference;

Channel channel(const Model &model, const PointReference &point, const MotionAxis &axis,
                char name) {
  return {.point = model.point_name(point),
          .axis = name,
          .relative = model.displacement(point, axis, false),
          .absolute = model.displacement(point, axis, true),
          .rotation = axis.rotation};
}

/// Do points of the body before this one turn about the axis in the same way?
bool turns_before(const reduction::ReducedBody &body, std::size_t point, Index row) {
  const auto same = [&](const reduction::BodyPoint &other) {
    return other.rows.row(row) == body.points[point].rows.row(row);
  };
  const auto end = body.points.begin() + static_cast<std::ptrdiff_t>(point);
  return std::any_of(body.points.begin(), end, same);
}

// Displacements, then rotations: those of masses, not again those of the points that they carry.
std::array<bool, 6> observed_axes(const reduction::ReducedBody &body, std::size_t point) {
  std::array<bool, 6> observed{};
  const Matrix &rows = body.points[point].rows;
  const double largest = body.size() > 0 ? rows.topRows(3).cwiseAbs().maxCoeff() : 0;
  for (Index axis = 0; axis < 3; ++axis) {
    observed[axis] = largest > 0 && rows.row(axis).cwiseAbs().maxCoeff() > 1e-12 * largest;
    observed[3 + axis] = body.type == "lumped" && !rows.row(3 + axis).isZero(0) &&
                         !turns_before(body, point, 3 + axis);
  }
  return observed;
}

} // namespace

std::vector<Channel> observed_channels(const Model &model) {
  std::vector<Channel> channels;
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    for (std::size_t p = 0; p < model.bodies()[b]->points.size(); ++p) {
      if (!model.bodies()[b]->points[p].interface.empty())
        continue;
      const std::array<bool, 6> observed = observed_axes(*model.bodies()[b], p);
      for (int axis = 0; axis < 6; ++axis)
        if (observed[axis])
          channels.push_back(channel(model, {.body = b, .point = p},
                                     {Vector3::Unit(axis % 3), axis >= 3},
                                     static_cast<char>('x' + axis % 3)));
    }
  return channels;
}

} // namespace vibroimpact::analyses
