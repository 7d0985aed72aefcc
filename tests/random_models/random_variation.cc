#include "random_models/random_variation.h"

#include "analyses/key_neighbours.h"
#include "analyses/steadiness.h"
#include "analyses/swept_system.h"
#include "common/error.h"
#include "motion/variation/linearised_motion.h"
#include "random_models/random_model.h"
#include "random_models/random_text.h"
#include "random_models/windowed_motion.h"
#include "reduction/reduce_body.h"
#include "simulation.h"
#include "support/motion_derivative.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <sstream>

namespace vibroimpact::testing {

namespace {

using analyses::System;
using motion::MotionState;
using Overrides = std::vector<parameters::Override>;
constexpr double agreement = 1e-7;
constexpr double resolved = 1e-8;
constexpr double hopeless = 1e-4;
constexpr int most_motions = 2000; // for one model
// In a window, where differences do not agree: they see the error of the motion's own steps.
constexpr std::array<double, 3> short_steps = {2e3, 2e4, 2e5};

// Builds the system of one random model at other values of its keys.
class Builder {
public:
  Builder(std::uint64_t seed, std::string folder)
      : text_(random_model({.seed = seed})), folder_(std::move(folder)) {}

  void set_tolerance(double tolerance) { tolerance_ = tolerance; }

  std::shared_ptr<const parameters::ParameterSet> set(Overrides overrides) const {
    overrides.push_back({.path = "File folder", .value = folder_, .origin = "test"});
    return parameters::ParameterSet::parse(declare_parameters(), text_, "model.prm", false,
                                           overrides);
  }

  System build(const Overrides &overrides) const {
    const auto parsed = set(overrides);
    const parameters::Values root = parsed->root();
    const bool bodies_change =
        std::any_of(overrides.begin(), overrides.end(), [](const parameters::Override &change) {
          return change.path.starts_with("Body");
        });
    if (bodies_change || bodies_.empty()) {
      std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
      for (const std::string &name : root.instances("Body")) {
        auto body = std::make_shared<reduction::ReducedBody>(
            reduction::reduce_body(root.instance("Body", name), name, folder_, MPI_COMM_SELF));
        body->name = name;
        bodies.push_back(std::move(body));
      }
      if (bodies_change)
        return with_tolerance(analyses::build_system(root, root.instance("Analysis", "a"), bodies));
      bodies_ = bodies;
    }
    return with_tolerance(analyses::build_system(root, root.instance("Analysis", "a"), bodies_));
  }

private:
  System with_tolerance(System system) const {
    system.integration.relative_tolerance = tolerance_;
    return system;
  }

  std::string text_, folder_;
  double tolerance_ = 1e-10;
  mutable std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies_;
};

// Keys that most models have, as far as this one has them.
std::vector<analyses::SweptParameter> keys_of(const Builder &builder) {
  std::vector<analyses::SweptParameter> keys;
  for (const char *path : {"Contact/k0/Clearance",
                           "Contact/k0/Linear penalty/Stiffness",
                           "Contact/k0/Kelvin-Voigt/Stiffness",
                           "Contact/k0/Kelvin-Voigt/Damping constant",
                           "Contact/k0/Relaxing stop/Stiffness",
                           "Contact/k0/Relaxing stop/Damping constant",
                           "Contact/k0/Piecewise stop/Damping constant",
                           "Contact/k0/Hertz/Stiffness",
                           "Contact/k0/Hunt-Crossley/Restitution coefficient",
                           "Contact/k0/Hunt-Crossley/Stiffness",
                           "Contact/k0/Tsuji/Damping coefficient",
                           "Contact/k0/Kuwabara-Kono/Dissipation time",
                           "Contact/k0/Newton restitution/Restitution coefficient",
                           "Excitation/e0/Amplitude",
                           "Excitation/e0/Frequency",
                           "Excitation/e0/Ramp/Rate",
                           "Excitation/e0/Impulse/Duration",
                           "Connection/c0/Stiffness",
                           "Connection/c0/Cubic stiffness",
                           "Body/b/Mass m0/Mass"})
    try {
      const auto number = builder.set({})->number_at(path);
      if (number && number->value != 0)
        keys.push_back({.path = path, .unit = number->unit, .values = {number->value}});
    } catch (const InputError &) {
    }
  return keys;
}

struct Comparison {
  double apart = 0, open = 0;
  bool compared = false, agrees = true;
};

Comparison compare(const Vector &own, const NumericalDerivative &differences, const Vector &scale,
                   double least) {
  const double size = std::max(own.cwiseProduct(scale).cwiseAbs().maxCoeff(), least);
  if (size == 0 && differences.value.isZero(0)) // nothing moves
    return {.compared = true};
  if (!(differences.error < hopeless) || size == 0)
    return {.open = differences.error};
  const double apart = (own.cwiseProduct(scale) - differences.value).cwiseAbs().maxCoeff() / size;
  return {.apart = apart,
          .open = differences.error,
          .compared = true,
          .agrees = apart <= agreement ||
                    (differences.error > resolved && apart <= 10 * differences.error)};
}

double seconds_of(const std::function<void()> &work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

class Judge {
public:
  Judge(std::uint64_t seed, const std::string &folder) : builder_(seed, folder) {}

  VariationVerdict judge() {
    try {
      run();
    } catch (const InputError &error) {
      verdict_ = {.word = "refused", .detail = error.what()};
    } catch (const NumericalError &error) {
      verdict_.word = "failed";
      verdict_.detail = error.what();
    }
    return verdict_;
  }

private:
  void run() {
    const double duration = builder_.set({})
                                ->root()
                                .instance("Analysis", "a")
                                .subsection("Transient")
                                .quantity("Duration");
    system_.emplace(builder_.build({}));
    window_ = find_window(*system_, duration);
    scale_ = scale_of(*system_);
    linearise_tightly();
    if (own_.without_derivative > 0) {
      verdict_.word = "no derivative";
      return;
    }
    compare_states();
    compare_keys();
    compare_determinant();
    if (verdict_.word.empty())
      verdict_.word = verdict_.columns > 0 || !unresolved_ ? "agree" : "unresolved";
  }

  // As tightly as the number of steps allows.
  void linearise_tightly() {
    for (const double tolerance : {1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8})
      try {
        builder_.set_tolerance(tolerance);
        system_.emplace(builder_.build({}));
        tangents_.clear();
        keys_.clear();
        add_keys();
        linearise();
        return;
      } catch (const NumericalError &) {
        if (tolerance == 1e-8)
          throw;
      }
  }

  void add_keys() {
    for (const analyses::SweptParameter &key : keys_of(builder_)) {
      std::vector<motion::KeyNeighbour> neighbours = analyses::key_neighbours(
          key, key.values.front(), [&](const Overrides &o) { return builder_.build(o); });
      tangents_.push_back(std::make_unique<motion::KeyTangent>(
          key.path, system_->model, system_->contacts, std::move(neighbours)));
      keys_.push_back(key);
    }
  }

  void linearise() {
    motion::Trajectory trajectory(system_->model, system_->contacts, tight(*system_));
    trajectory.start(window_.start);
    std::vector<motion::KeyTangent *> tangents;
    for (const auto &tangent : tangents_)
      tangents.push_back(tangent.get());
    const motion::Variation at_start(trajectory, scale_, 1e-12, tangents);
    projection_ = at_start.projection();
    EventSequence sequence;
    sequence.contacts = &system_->contacts.pairs();
    const double with = seconds_of([&] {
      own_ = motion::linearise(trajectory, window_.start, window_.end,
                               {.scale = scale_, .tolerance = 1e-12}, {}, &sequence);
    });
    own_ = motion::linearise(trajectory, window_.start, window_.end,
                             {.scale = scale_, .tolerance = 1e-12}, tangents);
    const double without =
        seconds_of([&] { end_of_motion(*system_, window_.start, window_.end, sequence.list, 0); });
    events_ = sequence.list;
    verdict_.cost = with / without;
    verdict_.events = static_cast<int>(sequence.list.size());
    verdict_.laws = sequence.laws;
    verdict_.kinds = sequence.kinds;
  }

  double size_of_state() const {
    return std::max(window_.start.physical.cwiseProduct(scale_).cwiseAbs().maxCoeff(),
                    own_.end.physical.cwiseProduct(scale_).cwiseAbs().maxCoeff());
  }

  void note(const Comparison &comparison, const std::string &what, double &largest, int &count) {
    if (!comparison.compared) {
      unresolved_ = true;
      verdict_.detail += " " + what + " unresolved (" + digits(comparison.open) + ");";
      return;
    }
    ++count;
    largest = std::max(largest, comparison.apart);
    verdict_.open = std::max(verdict_.open, comparison.open);
    if (comparison.agrees)
      return;
    verdict_.word = "wrong";
    verdict_.detail += " " + what + " differs by " + digits(comparison.apart) + ", open " +
                       digits(comparison.open) + ";";
  }

  std::optional<Vector> scaled_flow(const System &system, const Vector &deviation) const {
    if (++motions_ > most_motions)
      throw NumericalError("the differences take more than " + std::to_string(most_motions) +
                           " motions");
    MotionState start = window_.start;
    start.physical += deviation;
    std::optional<Vector> end = end_of_motion(system, start, window_.end, events_, maximum_step_);
    if (end)
      *end = end->cwiseProduct(scale_);
    return end;
  }

  // By shorter and shorter steps of the motions.
  Comparison compare_with_care(const std::function<Comparison()> &compare_once) {
    Comparison comparison = compare_once();
    for (const double steps : short_steps) {
      if ((comparison.compared && comparison.agrees) || std::isinf(comparison.open))
        break;
      maximum_step_ = (window_.end - window_.start.time) / steps;
      comparison = compare_once();
    }
    maximum_step_ = 0; // none
    return comparison;
  }

  void compare_states() {
    const Index size = scale_.size();
    for (Index j = 0; j < size; ++j) {
      const Vector direction = projection_.by_state.col(j);
      const double length = direction.cwiseProduct(scale_).cwiseAbs().maxCoeff();
      if (length == 0)
        continue;
      const double step = 1e-3 * size_of_state() / length;
      const auto compare_once = [&] {
        const NumericalDerivative differences = numerical_derivative(
            [&](double e) { return scaled_flow(*system_, e * direction); }, step);
        return compare(own_.by_state.col(j), differences, scale_, 1e-6 * length);
      };
      note(compare_with_care(compare_once), "column " + std::to_string(j), verdict_.by_state,
           verdict_.columns);
    }
  }

  void compare_keys() {
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      const double value = keys_[k].values.front();
      const Vector direction = projection_.by_key.col(static_cast<Index>(k));
      const auto compare_once = [&] {
        const NumericalDerivative differences = numerical_derivative(
            [&](double e) -> std::optional<Vector> {
              try {
                return scaled_flow(builder_.build({keys_[k].at(value + e)}), e * direction);
              } catch (const InputError &) {
                return std::nullopt;
              }
            },
            1e-3 * std::abs(value), 9);
        return compare(own_.by_key.col(static_cast<Index>(k)), differences, scale_,
                       1e-6 * size_of_state() / std::abs(value));
      };
      note(compare_with_care(compare_once), keys_[k].path, verdict_.by_key, verdict_.keys);
    }
  }

  // Of matrices that rounding leaves a determinant, and where nothing was projected.
  void compare_determinant() {
    verdict_.determinant = std::numeric_limits<double>::quiet_NaN();
    const Matrix scaled = scale_.asDiagonal() * own_.by_state * scale_.cwiseInverse().asDiagonal();
    const Eigen::FullPivLU<Matrix> lu(scaled);
    const Vector pivots = lu.matrixLU().diagonal().cwiseAbs();
    if (!projection_.by_state.isIdentity(0) || !(pivots.minCoeff() > 1e-7 * pivots.maxCoeff()))
      return;
    const double product = pivots.array().log().sum();
    verdict_.determinant = std::abs(product - own_.determinant.logarithm);
    if (verdict_.determinant > 1e-7) {
      verdict_.word = "wrong";
      verdict_.detail += " determinant off by " + digits(verdict_.determinant) + ";";
    }
  }

  mutable int motions_ = 0; ///< for the differences
  double maximum_step_ = 0; ///< of theirs [s]
  bool unresolved_ = false;
  Builder builder_;
  std::optional<System> system_;
  MotionWindow window_;
  Vector scale_;
  std::vector<analyses::SweptParameter> keys_;
  std::vector<std::unique_ptr<motion::KeyTangent>> tangents_;
  motion::LinearMap projection_;
  motion::LinearisedMotion own_;
  std::vector<EventSequence::Event> events_;
  VariationVerdict verdict_;
};

} // namespace

VariationVerdict judge_variation(std::uint64_t seed, const std::string &folder) {
  return Judge(seed, folder).judge();
}

} // namespace vibroimpact::testing
