#include "vibroimpact_side.h"

#include "analyses/recorders/extreme_values.h"
#include "motion/path/trajectory.h"

#include <memory>
#include <utility>

namespace vibroimpact::benchmarks {

namespace {

using namespace motion;
using reduction::ReducedBody;

constexpr double event_tolerance = 1e-12; // the program's default

// Counts the contacts, where there is friction the stops too, and keeps the extreme values of one
// displacement.
class Record : public Observer {
public:
  explicit Record(const Problem &problem)
      : problem_(problem), recorded_(PointForm{problem.recorded}),
        begun_(problem.contacts.size(), 0) {}
  void outputs(const Equations & /*equations*/, std::vector<Output> &list) override {
    list.push_back({&recorded_, &extent_});
  }
  bool sees_steps(const Equations & /*equations*/) const override { return false; }
  void event(const ContactEvent &event) override {
    const std::vector<contact::Mode> &modes = problem_.contacts.pairs()[event.contact].law->modes();
    const contact::Mode &from = modes[static_cast<std::size_t>(event.from)];
    const contact::Mode &to = modes[static_cast<std::size_t>(event.to)];
    begun_[event.contact] +=
        (!from.in_contact && to.in_contact) ||
        (from.friction == contact::Friction::slip && to.friction == contact::Friction::stick);
  }
  const std::vector<long> &begun() const { return begun_; }
  double excursion() const { return extent_.peak_to_peak(); }

private:
  const Problem &problem_;
  OutputForm recorded_;
  std::vector<long> begun_;
  ValueRange extent_;
};

// A problem with everything that must outlive its trajectory.
class VibroimpactMotion {
public:
  VibroimpactMotion(const std::string &method, const Problem &problem, const Vector &start,
                    const Tolerance &tolerance, bool records)
      : problem_(problem), start_{.time = 0, .physical = start}, records_(records) {
    Settings settings;
    settings.method = method;
    settings.relative_tolerance = tolerance.relative;
    settings.absolute_tolerance = tolerance.absolute;
    settings.event_tolerance = event_tolerance;
    trajectory_ = std::make_unique<Trajectory>(problem_.model, problem_.contacts, settings);
  }

  Outcome run() {
    trajectory_->start(start_);
    if (!records_) {
      trajectory_->advance(problem_.end);
      return {.steps = trajectory_->accuracy().steps};
    }
    Record record(problem_);
    trajectory_->advance(problem_.end, record);
    return {.excursion = record.excursion(),
            .contacts = record.begun(),
            .steps = trajectory_->accuracy().steps};
  }

private:
  Problem problem_;
  MotionState start_;
  bool records_;
  std::unique_ptr<Trajectory> trajectory_;
};

} // namespace

std::shared_ptr<const ReducedBody> body_along_x(const std::string &name, const Vector &mass,
                                                const Vector &stiffness, const Vector &damping,
                                                const Vector &row) {
  auto body = std::make_shared<ReducedBody>();
  body->name = name;
  body->type = "lumped";
  body->mass = mass;
  body->stiffness = stiffness;
  body->damping = damping.asDiagonal();
  // A single mass moves with its base as a whole.
  body->base_participation = Matrix::Zero(mass.size(), 3);
  if (mass.size() == 1)
    body->base_participation(0, 0) = mass[0];
  reduction::BodyPoint head{
      .name = "head", .position = Vector3::Zero(), .rows = Matrix::Zero(6, mass.size())};
  head.rows.row(0) = row.transpose();
  body->points.push_back(std::move(head));
  return body;
}

contact::ContactPair contact_of_heads(const model::Model &model, const std::string &body,
                                      const std::string &other, double sense, double clearance,
                                      std::shared_ptr<const contact::ContactLaw> law) {
  const auto row = [&](const std::string &name) {
    return model.displacement({.body = model.find_body(name), .point = 0}, Vector3::UnitX(), false)
        .row;
  };
  RowVector gap = -sense * row(body);
  if (!other.empty())
    gap += sense * row(other);
  return {.name = body + (sense > 0 ? " right" : " left"),
          .side_a = body + ".head",
          .side_b = other.empty() ? "stop" : other + ".head",
          .clearance = clearance,
          .gap = {.row = gap, .base_coefficients = std::vector<double>(model.sources().size(), 0)},
          .law = std::move(law),
          .origin = "benchmark"};
}

Vector settled(const Problem &problem, double period, long periods) {
  Settings settings;
  settings.relative_tolerance = 1e-11;
  settings.absolute_tolerance = 1e-14;
  Trajectory trajectory(problem.model, problem.contacts, settings);
  const Vector rest = Vector::Zero(problem.model.size());
  trajectory.start(0, rest, rest);
  trajectory.advance(static_cast<double>(periods) * period);
  return trajectory.motion_state().physical;
}

Side vibroimpact_side(const std::string &name, const std::string &method, const Problem &problem,
                      const Vector &start) {
  return {.name = name, .prepare = [=](const Tolerance &tolerance, bool records) {
            auto motion =
                std::make_shared<VibroimpactMotion>(method, problem, start, tolerance, records);
            return Motion([motion] { return motion->run(); });
          }};
}

} // namespace vibroimpact::benchmarks
