#include "motion/variation/model_tangent.h"

namespace vibroimpact::motion {

namespace {

using Neighbours = std::vector<WeightedModel>;

// The weighted sum of what `part` of a neighbour is more than `present`.
template <typename Value, typename Part>
Value derivative(const Value &present, const Neighbours &neighbours, const Part &part) {
  Value sum = 0.0 * present;
  for (const WeightedModel &near : neighbours)
    sum += near.weight * (part(near) - present);
  return sum;
}

template <typename Part>
model::Projection derivative_of_projection(const model::Projection &present,
                                           const Neighbours &neighbours, const Part &part) {
  model::Projection change{
      .row = derivative<RowVector>(present.row, neighbours,
                                   [&](const WeightedModel &near) { return part(near).row; }),
      .base_coefficients = {}};
  for (std::size_t k = 0; k < present.base_coefficients.size(); ++k)
    change.base_coefficients.push_back(derivative<double>(
        present.base_coefficients[k], neighbours,
        [&](const WeightedModel &near) { return part(near).base_coefficients[k]; }));
  return change;
}

template <typename Part>
Matrix derivative_of_form(const model::Model &model, const Neighbours &neighbours,
                          const Part &form_of) {
  const Matrix change =
      derivative<Matrix>(form_of(model).dense(), neighbours,
                         [&](const WeightedModel &near) { return form_of(*near.model).dense(); });
  return change.isZero(0) ? Matrix() : change;
}

double moved_by(const std::vector<double> &base_coefficients,
                const std::vector<SourceValues> &sources) {
  double sum = 0;
  for (std::size_t k = 0; k < base_coefficients.size(); ++k)
    if (base_coefficients[k] != 0)
      sum += base_coefficients[k] * sources[k][0];
  return sum;
}

} // namespace

ModelTangent::ModelTangent(const model::Model &model, const contact::ContactSet &contacts,
                           const Neighbours &neighbours)
    : model_(model),
      mass_(derivative<Vector>(model.mass(), neighbours,
                               [](const WeightedModel &near) { return near.model->mass(); })),
      stiffness_(derivative_of_form(
          model, neighbours,
          [](const model::Model &of) -> const model::LinearForm & { return of.stiffness(); })),
      damping_(derivative_of_form(
          model, neighbours,
          [](const model::Model &of) -> const model::LinearForm & { return of.damping(); })) {
  take_loads(neighbours);
  take_springs(neighbours);
  take_directions(contacts, neighbours);
  take_circles(contacts, neighbours);
}

void ModelTangent::take_circles(const contact::ContactSet &contacts, const Neighbours &neighbours) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    CircleTangent &tangent = circles_.emplace_back();
    const contact::CircularGap *const present = contacts.pairs()[c].circle.get();
    if (!present)
      continue;
    for (const WeightedModel &near : neighbours) {
      const contact::CircularGap &other = *near.contacts->pairs()[c].circle;
      tangent.clearance += near.weight * (other.clearance() - present->clearance());
      tangent.surface_speed += near.weight * (other.surface_speed() - present->surface_speed());
    }
  }
}

void ModelTangent::take_loads(const Neighbours &neighbours) {
  for (std::size_t k = 0; k < model_.sources().size(); ++k) {
    const auto of = [&](Vector model::Source::*load) {
      return derivative<Vector>(
          model_.sources()[k].*load, neighbours,
          [&](const WeightedModel &near) { return near.model->sources()[k].*load; });
    };
    loads_.push_back({.load = of(&model::Source::load),
                      .rate_load = of(&model::Source::rate_load),
                      .inertial_load = of(&model::Source::inertial_load)});
  }
}

void ModelTangent::take_springs(const Neighbours &neighbours) {
  for (std::size_t k = 0; k < model_.connections().size(); ++k) {
    const model::Connection &present = model_.connections()[k];
    const auto of = [&](const WeightedModel &near) -> const model::Connection & {
      return near.model->connections()[k];
    };
    const double stiffness =
        derivative<double>(present.cubic_stiffness, neighbours,
                           [&](const WeightedModel &near) { return of(near).cubic_stiffness; });
    if (present.cubic_stiffness == 0 && stiffness == 0)
      continue;
    springs_.push_back({.connection = k,
                        .stiffness = stiffness,
                        .elongation = derivative_of_projection(
                            present.elongation, neighbours,
                            [&](const WeightedModel &near) { return of(near).elongation; })});
  }
}

void ModelTangent::take_directions(const contact::ContactSet &contacts,
                                   const Neighbours &neighbours) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    std::vector<DirectionTangent> &directions = directions_.emplace_back();
    for (int d = 0; d < contacts.pairs()[c].n_directions(); ++d) {
      const contact::Direction present = contacts.pairs()[c].along(d);
      const auto of = [&](const WeightedModel &near) { return near.contacts->pairs()[c].along(d); };
      directions.push_back(
          {.offset = derivative<double>(present.offset, neighbours,
                                        [&](const WeightedModel &near) { return of(near).offset; }),
           .speed = derivative<double>(present.speed, neighbours,
                                       [&](const WeightedModel &near) { return of(near).speed; }),
           .projection = derivative_of_projection(
               *present.projection, neighbours,
               [&](const WeightedModel &near) { return *of(near).projection; })});
    }
  }
}

// d(k3 e^3 row^T) = (dk3 e^3 + 3 k3 e^2 de) row^T + k3 e^3 drow^T, e the elongation
Vector ModelTangent::cubic_forces(ConstVectorView q,
                                  const std::vector<SourceValues> &sources) const {
  Vector sum = Vector::Zero(q.size());
  for (const CubicSpring &spring : springs_) {
    const model::Connection &present = model_.connections()[spring.connection];
    const double e =
        present.elongation.row.dot(q) + moved_by(present.elongation.base_coefficients, sources);
    const double change =
        spring.elongation.row.dot(q) + moved_by(spring.elongation.base_coefficients, sources);
    sum += (spring.stiffness * e * e * e + 3 * present.cubic_stiffness * e * e * change) *
               present.elongation.row.transpose() +
           present.cubic_stiffness * e * e * e * spring.elongation.row.transpose();
  }
  return sum;
}

Vector ModelTangent::force(ConstVectorView q, ConstVectorView velocity,
                           ConstVectorView acceleration, const std::vector<SourceValues> &sources,
                           const Vector &contact_forces) const {
  Vector force = -mass_.cwiseProduct(acceleration);
  if (stiffness_.size() > 0)
    force -= stiffness_ * q;
  if (damping_.size() > 0)
    force -= damping_ * velocity;
  for (std::size_t k = 0; k < sources.size(); ++k)
    force += sources[k][0] * loads_[k].load + sources[k][1] * loads_[k].rate_load +
             sources[k][2] * loads_[k].inertial_load;
  force -= cubic_forces(q, sources);
  for (std::size_t c = 0; c < directions_.size(); ++c)
    if (contact_forces[static_cast<Index>(c)] != 0)
      force += contact_forces[static_cast<Index>(c)] * along(c, 0).projection.row.transpose();
  return force;
}

} // namespace vibroimpact::motion
