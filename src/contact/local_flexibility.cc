#include "contact/local_flexibility.h"

#include <stdexcept>

namespace vibroimpact::contact {

using model::Model;
using model::PointReference;
using reduction::ReducedBody;

namespace {

// sum over coordinates of row^2 / stiffness; those without stiffness move as a whole.
double flexibility_of_coordinates(const ReducedBody &body, const RowVector &row) {
  double sum = 0;
  for (Index j = 0; j < body.size(); ++j)
    if (body.stiffness[j] > 0)
      sum += row[j] * row[j] / body.stiffness[j];
  return sum;
}

bool known(const PointReference &reference, const Model &model) {
  const ReducedBody &body = *model.bodies().at(reference.body);
  return !body.modal() || body.points.at(reference.point).flexibility.size() > 0;
}

LocalFlexibility of_point(const PointReference &reference, const Vector3 &normal,
                          const Model &model) {
  const ReducedBody &body = *model.bodies().at(reference.body);
  const reduction::BodyPoint &point = body.points.at(reference.point);
  const RowVector row = normal.transpose() * point.rows.topRows(3);
  const double kept = flexibility_of_coordinates(body, row);
  return {.whole = body.modal() ? normal.dot(point.flexibility * normal) : kept, .kept = kept};
}

} // namespace

std::optional<LocalFlexibility> local_flexibility(const PointReference &a,
                                                  const std::optional<PointReference> &b,
                                                  const Vector3 &normal, const Model &model) {
  if (!known(a, model) || (b && !known(*b, model)))
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
