#include "random_models/random_orbit.h"

#include "common/error.h"
#include "motion/variation/linearised_motion.h"
#include "random_models/keyed_model.h"
#include "random_models/random_bodies.h"
#include "random_models/random_contacts.h"
#include "random_models/random_text.h"
#include "random_models/run_model.h"
#include "random_models/windowed_motion.h"
#include "support/motion_derivative.h"

#include <algorithm>
#include <numbers>

namespace vibroimpact::testing {

namespace {

constexpr double hopeless = 1e-6;
constexpr double tolerance = 1e-12;

Vector values_of(const ModelRun &run, const std::string &name) {
  for (const Field &field : run.fields)
    if (field.name() == name)
      return Eigen::Map<const Vector>(field.values.data(), static_cast<Index>(field.values.size()));
  return Vector::Zero(1);
}

class OrbitJudge {
public:
  OrbitJudge(const std::string &text, const std::string &folder, const ModelRun &run)
      : model_(text, folder), run_(run) {
    model_.set_tolerance(tolerance);
    system_.emplace(model_.build({}));
    const double frequency = model_.set({})->number_at("Excitation/e0/Frequency")->value;
    verdict_.multiple = std::lround(values_of(run, "period_multiple")[0]);
    verdict_.stable = values_of(run, "stable")[0] != 0;
    verdict_.symmetric = values_of(run, "symmetric")[0] != 0;
    const double period = 2 * std::numbers::pi / frequency * static_cast<double>(verdict_.multiple);
    window_ = {.start = {.time = 0, .physical = values_of(run, "state")},
               .end = period,
               .at_once = 1e-10 * period};
    scale_ = scale_of(*system_);
  }

  OrbitVerdict judge() {
    if (!note_events())
      return verdict_;
    linearise();
    if (!take_differences()) {
      verdict_.word = "unresolved";
      return verdict_;
    }
    leave_memory_out();
    Eigen::VectorXcd own(scale_.size());
    own.real() = values_of(run_, "multiplier_real");
    own.imag() = values_of(run_, "multiplier_imaginary");
    verdict_.spectra = compare_spectra(own, matrix_, differences_);
    verdict_.word = verdict_.spectra.word;
    return verdict_;
  }

private:
  bool note_events() {
    EventSequence sequence(system_->contacts.pairs());
    try {
      motion::Trajectory trajectory(system_->model, system_->contacts, tight(*system_));
      trajectory.start(window_.start);
      trajectory.advance(window_.end, sequence);
    } catch (const NumericalError &error) { // stiff
      verdict_.word = "unresolved";
      verdict_.detail = error.what();
      return false;
    }
    window_.events = sequence.list;
    verdict_.events = static_cast<int>(sequence.list.size());
    verdict_.laws = sequence.laws;
    return true;
  }

  void linearise() {
    motion::Trajectory trajectory(system_->model, system_->contacts, tight(*system_));
    trajectory.start(window_.start);
    projection_ = motion::Variation(trajectory, scale_, tolerance).projection().by_state;
    motion::Lineariser linearised(trajectory, {.scale = scale_, .tolerance = tolerance});
    const motion::LinearisedMotion motion = linearised(window_.start, window_.end);
    matrix_ = scale_.asDiagonal() * motion.by_state * scale_.cwiseInverse().asDiagonal();
  }

  bool take_differences() {
    const Index size = scale_.size();
    differences_ = Matrix::Zero(size, size);
    const double size_of_state = window_.start.physical.cwiseProduct(scale_).cwiseAbs().maxCoeff();
    for (Index j = 0; j < size; ++j) {
      const Vector direction = projection_.col(j);
      const double length = direction.cwiseProduct(scale_).cwiseAbs().maxCoeff();
      if (length == 0)
        continue;
      const NumericalDerivative column = numerical_derivative(
          [&](double e) {
            motion::MotionState start = window_.start;
            start.physical += e * direction;
            std::optional<Vector> end = end_of_motion(*system_, window_, start, 0);
            if (end)
              *end = end->cwiseProduct(scale_);
            return end;
          },
          1e-3 * size_of_state / length);
      // Of what the column adds to the matrix, which may be far less than others do.
      const double open = column.error * (column.value.size() > 0 ? column.value.norm() : 1) /
                          std::max(matrix_.col(j).norm() * scale_[j], 1e-6 * length);
      if (!(open <= hopeless))
        return false;
      verdict_.open = std::max(verdict_.open, open);
      differences_.col(j) = column.value / scale_[j];
    }
    return true;
  }

  // What a contact remembers of an impact that never comes again acts on nothing and is kept for
  // ever: a multiplier 1 that no motion shows, which periodic motions are given without (0).
  void leave_memory_out() {
    for (Index j = 2 * system_->model.size(); j < scale_.size(); ++j) {
      const Vector unit = Vector::Unit(scale_.size(), j);
      if (!differences_.col(j).isApprox(unit, 1e-9) ||
          !differences_.row(j).transpose().isApprox(unit, 1e-9))
        continue;
      differences_(j, j) = 0;
      matrix_(j, j) = 0;
    }
  }

  KeyedModel model_;
  const ModelRun &run_;
  std::optional<analyses::System> system_;
  MotionWindow window_;
  Vector scale_;
  Matrix projection_;
  Matrix matrix_, differences_; ///< of scaled states by scaled states
  OrbitVerdict verdict_;
};

} // namespace

std::string random_orbit_model(std::uint64_t seed) {
  Draw draw(seed + 500000);
  const RandomBodies bodies = random_bodies(draw, 1);
  std::string text = bodies.text + random_contacts(draw, bodies).text;
  const bool force = draw.chance(0.5);
  std::string content = set("Type", force ? "force" : "base acceleration") +
                        set("Direction", bodies.direction) +
                        set("Amplitude", draw.power(-0.5, 1.3), force ? "N" : "m/s^2") +
                        set("Frequency", draw.uniform(2, 25), "rad/s");
  if (force)
    content += set("At", draw.of(bodies.points));
  text += subsection("Excitation e0", content);
  if (draw.chance(0.35))
    text += subsection("Excitation g", set("Type", "gravity") +
                                           set("Direction", draw.of({"", "-"}) + bodies.direction) +
                                           set("Amplitude", "9.81 m/s^2"));
  text += subsection("Integration", set("Relative tolerance", "1e-11"));
  return text +
         subsection("Analysis a", set("Type", "periodic orbit") +
                                      subsection("Periodic orbit", set("Settling cycles", "60")));
}

OrbitVerdict judge_orbit(std::uint64_t seed, const std::string &folder) {
  const std::string text = random_orbit_model(seed);
  try {
    const ModelRun run = run_model(text, folder, {});
    if (run.status != ModelRun::Status::finished)
      return {.word = run.status == ModelRun::Status::refused ? "refused" : "no orbit",
              .detail = run.reason};
    if (values_of(run, "events_without_derivative")[0] > 0)
      return {.word = "no orbit", .detail = "it has events without derivative"};
    return OrbitJudge(text, folder, run).judge();
  } catch (const InputError &error) {
    return {.word = "refused", .detail = error.what()};
  } catch (const NumericalError &error) {
    return {.word = "failed", .detail = error.what()};
  }
}

} // namespace vibroimpact::testing
