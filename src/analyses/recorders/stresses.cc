#include "analyses/recorders/stresses.h"

#include "analyses/results/fields.h"
#include "common/error.h"
#include "common/zero.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using model::PointReference;
using model::Projection;

namespace {

constexpr const char *stresses_section = "Stresses";
// A step is short against the oscillations it follows: between so many instants a stress has one
// peak at most.
constexpr int angle_samples = 16;

double square_of_von_mises(double first, double second, double shear) {
  return first * first - first * second + second * second + 3 * shear * shear;
}

double largest_size(const motion::Bernstein &curve) {
  return std::max(std::abs(curve.lower_bound()), std::abs(curve.upper_bound()));
}

class Curves {
public:
  Curves(const motion::StepView &view, const std::array<Projection, 3> &place)
      : first_(view.displacement(place[0])), second_(view.displacement(place[1])),
        shear_(view.displacement(place[2])) {}

  double operator()(double tau) const {
    return square_of_von_mises(first_(tau), second_(tau), shear_(tau));
  }
  /// Never less than the largest value.
  double bound() const {
    return square_of_von_mises(largest_size(first_), -largest_size(second_), largest_size(shear_));
  }
  double largest() const {
    int best = 0;
    for (int i = 1; i <= angle_samples; ++i)
      if ((*this)(i / double{angle_samples}) > (*this)(best / double{angle_samples}))
        best = i;
    const double left = std::max(0, best - 1) / double{angle_samples};
    const double right = std::min(angle_samples, best + 1) / double{angle_samples};
    const Minimum found =
        minimum_between([this](double tau) { return -(*this)(tau); }, left, right);
    return std::max(-found.value, (*this)(best / double{angle_samples}));
  }

private:
  motion::Bernstein first_, second_, shear_;
};

Projection stress_component(const model::Model &model, const PointReference &at, Index row) {
  const reduction::ReducedBody &body = *model.bodies()[at.body];
  Projection projection{.row = RowVector::Zero(model.size()),
                        .base_coefficients = std::vector<double>(model.sources().size(), 0)};
  projection.row.segment(model.offset(at.body), body.size()) =
      body.points[at.point].stress.row(row);
  return projection;
}

bool has_stress_at(const model::Model &model, const std::string &name) {
  PointReference at;
  model.find_point(name, at);
  return model.bodies()[at.body]->points[at.point].stress.rows() > 0;
}

} // namespace

Stresses::Stresses(const std::vector<std::string> &points, const System &system) {
  for (const std::string &name : points.empty() ? system.model.point_names() : points) {
    PointReference at;
    if (!system.model.find_point(name, at))
      throw std::logic_error("no point " + name);
    const Index rows = system.model.bodies()[at.body]->points[at.point].stress.rows();
    if (rows == 0)
      continue;
    Point point{.label = Label("point/" + name + "/von_mises_stress/maximum", "Pa",
                               "largest von Mises stress in the recorded window, of all elements "
                               "that meet at the point"),
                .places = {}};
    for (Index row = 0; row < rows; row += 3)
      point.places.push_back({stress_component(system.model, at, row),
                              stress_component(system.model, at, row + 1),
                              stress_component(system.model, at, row + 2)});
    points_.push_back(std::move(point));
  }
}

void Stresses::declare(parameters::Section &analysis) {
  analysis.subsection(stresses_section, "The recorder of stresses.")
      .names("Points", "all",
             "Points of beams and shells whose stress is observed: all, or their names as "
             "BODY.POINT.");
}

RecorderFactory Stresses::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(stresses_section);
  std::vector<std::string> points = section.names("Points");
  if (points == std::vector<std::string>{"all"})
    points.clear();
  return [section, points](const System &system) {
    for (const std::string &point : points) {
      section.require_known("Points", point, system.model.point_names());
      if (!has_stress_at(system.model, point))
        section.reject(
            "Points",
            "must be points of beams or shells whose cross-section has a known shape, which " +
                point + " has not");
    }
    return std::make_unique<Stresses>(points, system);
  };
}

void Stresses::begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) {
  for (Point &point : points_)
    point.largest = 0;
}

void Stresses::step(const motion::StepView &view) {
  for (Point &point : points_)
    for (const std::array<Projection, 3> &place : point.places)
      if (const Curves curves(view, place); curves.bound() > point.largest)
        point.largest = std::max(point.largest, curves.largest());
}

void Stresses::add_fields(const FieldWriter &result) const {
  for (const Point &point : points_)
    result.number(point.label, std::sqrt(point.largest));
}

} // namespace vibroimpact::analyses
