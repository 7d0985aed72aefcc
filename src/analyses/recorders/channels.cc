#include "analyses/recorders/channels.h"

namespace vibroimpact::analyses {

std::vector<Channel> observed_channels(const model::Model &model) {
  std::vector<Channel> channels;
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    for (std::size_t p = 0; p < model.bodies()[b]->points.size(); ++p) {
      if (!model.bodies()[b]->points[p].interface.empty())
        continue;
      const model::PointReference point{.body = b, .point = p};
      const Matrix rows = model.bodies()[b]->points[p].rows.topRows(3);
      const double largest = rows.size() > 0 ? rows.cwiseAbs().maxCoeff() : 0;
      for (int axis = 0; axis < 3; ++axis)
        if (largest > 0 && rows.row(axis).cwiseAbs().maxCoeff() > 1e-12 * largest)
          channels.push_back({.point = model.point_name(point),
                              .axis = static_cast<char>('x' + axis),
                              .relative = model.displacement(point, Vector3::Unit(axis), false),
                              .absolute = model.displacement(point, Vector3::Unit(axis), true)});
    }
  return channels;
}

} // namespace vibroimpact::analyses
