#include "contact/local_flexibility.h"

#include "reduction/known_flexibility.h"

#include <cmath>
#include <stdexcept>

namespace vibroimpact::contact {

using model::Model;
using model::PointReference;
using reduction::ReducedBody;

namespace {

bool known(const PointReference &reference, const Vector3 &normal, const Model &model) {
  const ReducedBody &body = *model.bodies().at(reference.body);
  return !reduction::has_modes(body) ||
         !std::isnan(reduction::flexibility_along(body.points.at(reference.point), normal));
}

LocalFlexibility of_point(const PointReference &reference, const Vector3 &normal,
                          const Model &model) {
  const ReducedBody &body = *model.bodies().at(reference.body);
  const reduction::BodyPoint &point = body.points.at(reference.point);
  const double kept = reduction::kept_flexibility(body, normal.transpose() * point.rows.topRows(3));
  return {.whole = reduction::has_modes(body) ? reduction::flexibility_along(point, normal) : kept,
          .kept = kept};
}

} // namespace

std::optional<LocalFlexibility> local_flexibility(const PointReference &a,
                                                  const std::optional<PointReference> &b,
                                                  const Vector3 &normal, const Model &model) {
  if (!known(a, normal, model) || (b && !known(*b, normal, model)))
    return std::nullopt;
  LocalFlexibility sum = of_point(a, normal, model);
  if (b) {
    const LocalFlexibility other = of_point(*b, normal, model);
    sum.whole += other.whole;
    sum.kept += other.kept;
  }
  return sum.whole > 0 ? std::optional(sum) : std::nullopt;
}

std::optional<LocalFlexibility> local_flexibility(const ContactPair &pair, const Model &model) {
  PointReference a;
  PointReference b;
  if (!model.find_point(pair.side_a, a))
    throw std::logic_error("contact " + pair.name + " has no point " + pair.side_a);
  const bool two_points = model.find_point(pair.side_b, b);
  return local_flexibility(a, two_points ? std::optional(b) : std::nullopt, pair.normal, model);
}

} // namespace vibroimpact::contact
