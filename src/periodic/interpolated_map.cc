#include "periodic/interpolated_map.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace vibroimpact::periodic {

namespace {

// Cubic Lagrange polynomials of the nodes 0, 1, 2, 3 at s.
std::array<double, 4> cubic_weights(double s) {
  const double a = s, b = s - 1, c = s - 2, d = s - 3;
  return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

} // namespace

InterpolatedMap::InterpolatedMap(const StateMap &map, const std::array<NodeAxis, 2> &axes)
    : axes_(axes) {
  for (const NodeAxis &axis : axes_)
    if (axis.count < 4 || !(axis.last > axis.first))
      throw std::logic_error("an interpolated map needs four nodes along each axis");
  images_.resize(2, axes_[0].count * axes_[1].count);
  for (Index i = 0; i < axes_[0].count; ++i)
    for (Index j = 0; j < axes_[1].count; ++j) {
      const Eigen::Vector2d state(axes_[0].first + static_cast<double>(i) * axes_[0].step(),
                                  axes_[1].first + static_cast<double>(j) * axes_[1].step());
      try {
        images_.col(node(i, j)) = map(state);
      } catch (const NumericalError &) {
        images_.col(node(i, j)).setConstant(std::numeric_limits<double>::quiet_NaN());
      }
    }
}

// The 4 x 4 nodes about the state, one-sided at the rim. False outside of the nodes.
bool InterpolatedMap::place(const Vector &state, Stencil &stencil) const {
  for (std::size_t d = 0; d < 2; ++d) {
    const double place = (state[static_cast<Index>(d)] - axes_[d].first) / axes_[d].step();
    if (!(place >= 0 && place <= static_cast<double>(axes_[d].count - 1)))
      return false;
    stencil.first[d] =
        std::clamp<Index>(static_cast<Index>(std::floor(place)) - 1, 0, axes_[d].count - 4);
    stencil.weights[d] = cubic_weights(place - static_cast<double>(stencil.first[d]));
  }
  return true;
}

std::optional<Eigen::Vector2d> InterpolatedMap::operator()(const Vector &state) const {
  Stencil stencil;
  if (!place(state, stencil))
    return {};
  const Eigen::Map<const Eigen::Vector4d> along(stencil.weights[1].data());
  Eigen::Vector2d image = Eigen::Vector2d::Zero();
  for (Index i = 0; i < 4; ++i)
    image += stencil.weights[0][static_cast<std::size_t>(i)] *
             (images_.middleCols<4>(node(stencil.first[0] + i, stencil.first[1])) * along);
  if (!image.allFinite()) // 0 times NaN is NaN
    return {};
  return image;
}

} // namespace vibroimpact::periodic
