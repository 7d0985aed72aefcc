#include "analyses/recorders/force_quantities.h"

#include "common/decompositions.h"

#include <cmath>
#include <functional>

namespace vibroimpact::analyses {

using model::Connection;
using model::Model;
using model::PointReference;
using model::Projection;
using motion::Bernstein;
using motion::StepView;
using reduction::ReducedBody;

namespace {

// The cube of a curve, from its value and derivatives at both ends.
Bernstein cube(const Bernstein &curve) {
  const Bernstein slope = curve.derivative();
  const Bernstein bend = slope.derivative();
  const auto at = [](double p, double p1, double p2) {
    return std::array<double, 3>{p * p * p, 3 * p * p * p1, 6 * p * p1 * p1 + 3 * p * p * p2};
  };
  return Bernstein::quintic(1, at(curve.start(), slope.start(), bend.start()),
                            at(curve.end(), slope.end(), bend.end()));
}

Bernstein tension(const Connection &connection, const StepView &view) {
  const Bernstein elongation = view.displacement(connection.elongation);
  Bernstein sum = elongation;
  sum *= connection.stiffness;
  Bernstein rate = elongation.derivative();
  rate *= connection.damping / view.length();
  sum += rate;
  if (connection.cubic_stiffness != 0) {
    Bernstein cubic = cube(elongation);
    cubic *= connection.cubic_stiffness;
    sum += cubic;
  }
  return sum;
}

// Of a bearing along one of its directions: what pulls the ends together.
Bernstein pull(const model::Bearing &bearing, Index direction, const StepView &view) {
  const auto part = [&](Index seen) {
    const Bernstein elongation =
        view.displacement(bearing.elongation[static_cast<std::size_t>(seen)]);
    Bernstein sum = elongation;
    sum *= bearing.stiffness(direction, seen);
    Bernstein rate = elongation.derivative();
    rate *= bearing.damping(direction, seen) / view.length();
    sum += rate;
    return sum;
  };
  Bernstein sum = part(0);
  sum += part(1);
  return sum;
}

// Does a connection or bearing lead from a point of the body to the base or the ground?
template <class Link>
bool supports(const Link &link, const Model &model, std::size_t body, PointReference &point) {
  return (link.side_b == "base" || link.side_b == "ground") &&
         model.find_point(link.side_a, point) && point.body == body;
}

// The direction of a support, from how the elongation sees the point's displacement; what cannot
// move counts as zero.
Vector3 direction_of(const Projection &elongation, const Model &model,
                     const PointReference &point) {
  const ReducedBody &body = *model.bodies()[point.body];
  const Matrix rows = body.points[point.point].rows.topRows(3).transpose();
  const Vector seen = -elongation.row.segment(model.offset(point.body), body.size()).transpose();
  return least_norm_solution(rows, seen);
}

using PulledBy = std::function<Bernstein(const StepView &)>;

struct BaseForce {
  Projection by_displacement, by_velocity, by_base;  ///< the last one for accelerations
  std::vector<std::pair<double, PulledBy>> supports; ///< factors and tensions

  Bernstein along(const StepView &view) const {
    Bernstein sum = view.displacement(by_displacement);
    Bernstein rate = view.displacement(by_velocity).derivative();
    rate *= 1 / view.length();
    sum += rate;
    sum += view.acceleration(by_base);
    for (const auto &[factor, tension_of] : supports) {
      Bernstein part = tension_of(view);
      part *= factor;
      sum += part;
    }
    return sum;
  }
};

Projection nothing(const Model &model) {
  return {.row = RowVector::Zero(model.size()),
          .base_coefficients = std::vector<double>(model.sources().size(), 0)};
}

// The share of its force that acts on the base of a body.
void add_to(Projection &by_velocity, const model::ModalDashpot &dashpot, double share) {
  by_velocity.row += share * dashpot.damping * dashpot.coordinate.row;
  for (std::size_t k = 0; k < by_velocity.base_coefficients.size(); ++k)
    by_velocity.base_coefficients[k] +=
        share * dashpot.damping * dashpot.coordinate.base_coefficients[k];
}

BaseForce base_force(const Model &model, std::size_t b, int axis) {
  const ReducedBody &body = *model.bodies()[b];
  const Vector weight = body.base_participation.col(axis).cwiseQuotient(body.mass);
  BaseForce force{nothing(model), nothing(model), nothing(model), {}};
  force.by_displacement.row.segment(model.offset(b), body.size()) =
      weight.cwiseProduct(body.stiffness).transpose();
  force.by_velocity.row.segment(model.offset(b), body.size()) = weight.transpose() * body.damping;
  for (const model::ModalDashpot &dashpot : model.modal_dashpots())
    add_to(force.by_velocity, dashpot,
           dashpot.coordinate.row.segment(model.offset(b), body.size()).dot(weight));
  const double left = body.total_mass[axis] - weight.dot(body.base_participation.col(axis));
  const Projection moved = model.displacement({.body = b, .point = 0}, Vector3::Unit(axis), true);
  for (std::size_t k = 0; k < model.sources().size(); ++k)
    force.by_base.base_coefficients[k] = -left * moved.base_coefficients[k];
  for (const Connection &connection : model.connections())
    if (PointReference point; supports(connection, model, b, point))
      if (const double n = direction_of(connection.elongation, model, point)[axis]; n != 0)
        force.supports.emplace_back(
            -n, [connection](const StepView &view) { return tension(connection, view); });
  for (const model::Bearing &bearing : model.bearings())
    for (Index d = 0; d < 2; ++d)
      if (PointReference point; supports(bearing, model, b, point))
        if (const double n =
                direction_of(bearing.elongation[static_cast<std::size_t>(d)], model, point)[axis];
            n != 0)
          force.supports.emplace_back(
              -n, [bearing, d](const StepView &view) { return pull(bearing, d, view); });
  return force;
}

} // namespace

std::vector<Observable> connection_forces(const Model &model) {
  std::vector<Observable> list;
  for (const Connection &connection : model.connections())
    list.push_back({"connection/" + connection.name + "/force", "force",
                    connection.rotation ? "N m" : "N", "tension, > 0 pulls the ends together",
                    [connection](const StepView &view) { return tension(connection, view); }});
  for (const model::Bearing &bearing : model.bearings())
    for (Index d = 0; d < 2; ++d) {
      const std::string which = d == 0 ? "first" : "second";
      list.push_back({"bearing/" + bearing.name + "/" + which + "_force", "force", "N",
                      "force along the " + which + " direction, > 0 pulls the ends together",
                      [bearing, d](const StepView &view) { return pull(bearing, d, view); }});
    }
  return list;
}

std::vector<Observable> base_forces(const Model &model) {
  std::vector<Observable> list;
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    for (int axis = 0; axis < 3; ++axis) {
      const ReducedBody &body = *model.bodies()[b];
      if (body.points.empty() || !body.base_participation.allFinite() ||
          std::isnan(body.total_mass[axis]) ||
          body.base_participation.col(axis).cwiseAbs().maxCoeff() <=
              1e-12 * body.base_participation.cwiseAbs().maxCoeff())
        continue;
      const std::string name(1, static_cast<char>('x' + axis));
      list.push_back({"body/" + body.name + "/base_force_" + name, "force", "N",
                      "force on the base along " + name,
                      [force = base_force(model, b, axis)](const StepView &view) {
                        return force.along(view);
                      }});
    }
  return list;
}

} // namespace vibroimpact::analyses
