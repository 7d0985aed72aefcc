#include "analyses/recorders/stresses.h"

#include "analyses/results/fields.h"
#include "common/error.h"
#include "common/zero.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vibroimpact::analyses {

using model::PointReference;
using model::Projection;
using reduction::squared_von_mises;

namespace {

constexpr const char *stresses_section = "Stresses";
// A step is short against the oscillations it follows: between so many instants a stress has one
// peak at most.
constexpr int angle_samples = 16;

double largest_size(const motion::Bernstein &curve) {
  return std::max(std::abs(curve.lower_bound()), std::abs(curve.upper_bound()));
}

class Curves {
public:
  Curves(const motion::StepView &view, const std::vector<Projection> &place) {
    for (const Projection &component : place)
      curves_.push_back(view.displacement(component));
  }

  double operator()(double tau) const {
    std::array<double, 6> stress{};
    for (std::size_t i = 0; i < curves_.size(); ++i)
      stress[i] = curves_[i](tau);
    return squared_von_mises(stress.data(), static_cast<Index>(curves_.size()));
  }
  /// Never less than the largest value: the products of direct stresses count as if each had the
  /// sign that makes the square larger.
  double bound() const {
    std::array<double, 6> size{};
    for (std::size_t i = 0; i < curves_.size(); ++i)
      size[i] = largest_size(curves_[i]);
    const auto &[a, b, c, d, e, f] = size;
    if (curves_.size() == 3)
      return a * a + a * b + b * b + 3 * c * c;
    return a * a + b * b + c * c + a * b + b * c + c * a + 3 * (d * d + e * e + f * f);
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
  std::vector<motion::Bernstein> curves_;
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
    const reduction::BodyPoint &here = system.model.bodies()[at.body]->points[at.point];
    if (here.stress.rows() == 0)
      continue;
    Point point{.label = Label("point/" + name + "/von_mises_stress/maximum", "Pa",
                               "largest von Mises stress in the recorded window, of all elements "
                               "that meet at the point"),
                .places = {}};
    for (Index row = 0; row < here.stress.rows(); ++row) {
      if (row % here.stress_components == 0)
        point.places.emplace_back();
      point.places.back().push_back(stress_component(system.model, at, row));
    }
    points_.push_back(std::move(point));
  }
}

void Stresses::declare(parameters::Section &analysis) {
  analysis.subsection(stresses_section, "The recorder of stresses.")
      .names("Points", "all",
             "Points of beams, shells and solids whose stress is observed: all, or their names as "
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
        section.reject("Points", "must be points of beams, shells or solids whose cross-section "
                                 "has a known shape, which " +
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
    for (const std::vector<Projection> &place : point.places)
      if (const Curves curves(view, place); curves.bound() > point.largest)
        point.largest = std::max(point.largest, curves.largest());
}

void Stresses::add_fields(const FieldWriter &result) const {
  for (const Point &point : points_)
    result.number(point.label, std::sqrt(point.largest));
}

} // namespace vibroimpact::analyses
