#include "vibroimpact_side.h"

#include "integration/trajectory.h"

#include <memory>
#include <utility>

namespace vibroimpact::benchmarks {

namespace {

// Counts the impacts and looks at nothing else.
class ImpactCounter : public Observer {
public:
  explicit ImpactCounter(const ContactSet &contacts) : contacts_(contacts) {}
  void step(const StepView & /*view*/) override {}
  void event(const ContactEvent &event) override {
    const std::vector<Mode> &modes = contacts_.pairs()[event.contact].law->modes();
    impacts_ += !modes[static_cast<std::size_t>(event.from)].in_contact &&
                modes[static_cast<std::size_t>(event.to)].in_contact;
  }
  long impacts() const { return impacts_; }

private:
  const ContactSet &contacts_;
  long impacts_ = 0;
};

// A force of zero, asked for once in every evaluation of the equations.
class EvaluationCounter : public TimeFunction {
public:
  double value(double /*time*/) const override {
    ++count_;
    return 0;
  }
  double rate(double /*time*/) const override { return 0; }
  double acceleration(double /*time*/) const override { return 0; }
  double period() const override { return 0; }
  double highest_frequency() const override { return 0; }
  std::shared_ptr<const TimeFunction> with_frequency(double) const override { return nullptr; }
  long take() const { return std::exchange(count_, 0); }

private:
  mutable long count_ = 0;
};

// A problem with everything that must outlive its trajectory.
class VibroimpactMotion {
public:
  VibroimpactMotion(const Problem &problem, const Tolerance &tolerance, bool counts_evaluations)
      : problem_(problem) {
    if (counts_evaluations) {
      counter_ = std::make_shared<EvaluationCounter>();
      problem_.model.add_force("counter", counter_, {}, Vector3::UnitX());
    }
    IntegrationSettings settings;
    settings.relative_tolerance = tolerance.relative;
    settings.absolute_tolerance = tolerance.absolute;
    settings.event_tolerance = problem.event_tolerance;
    trajectory_ = std::make_unique<Trajectory>(problem_.model, problem_.contacts, settings);
  }

  Outcome run() {
    ImpactCounter observer(problem_.contacts);
    trajectory_->start(0, problem_.displacement, problem_.velocity);
    trajectory_->advance(problem_.end, observer);
    const Accuracy accuracy = trajectory_->accuracy();
    return {.state = trajectory_->state().head(2 * trajectory_->layout().n),
            .steps = accuracy.steps,
            .rejected = accuracy.rejected_steps,
            .impacts = observer.impacts(),
            .evaluations = counter_ ? counter_->take() : 0};
  }

private:
  Problem problem_;
  std::shared_ptr<const EvaluationCounter> counter_;
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
  body->base_participation = Matrix::Zero(mass.size(), 3);
  BodyPoint head{.name = "head", .position = Vector3::Zero(), .rows = Matrix::Zero(6, mass.size())};
  head.rows.row(0) = row.transpose();
  body->points.push_back(std::move(head));
  return body;
}

ContactPair contact_of_heads(const Model &model, const std::string &body, const std::string &other,
                             double clearance, std::shared_ptr<const ContactLaw> law) {
  const auto row = [&](const std::string &name) {
    return model.displacement({.body = model.find_body(name), .point = 0}, Vector3::UnitX(), false)
        .row;
  };
  RowVector gap = -row(body);
  if (!other.empty())
    gap += row(other);
  return {.name = "heads",
          .side_a = body + ".head",
          .side_b = other.empty() ? "stop" : other + ".head",
          .clearance = clearance,
          .gap = {.row = gap, .carrier = std::vector<double>(model.sources().size(), 0)},
          .law = std::move(law),
          .origin = "benchmark"};
}

Side vibroimpact_side(const Problem &problem) {
  return {.name = "vibroimpact",
          .prepare = [problem](const Tolerance &tolerance, bool counts_evaluations) {
            auto motion =
                std::make_shared<VibroimpactMotion>(problem, tolerance, counts_evaluations);
            return Motion([motion] { return motion->run(); });
          }};
}

} // namespace vibroimpact::benchmarks
