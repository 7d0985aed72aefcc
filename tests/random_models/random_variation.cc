#include "random_models/random_variation.h"

#include "analyses/keys/keyed_system.h"
#include "common/error.h"
#include "motion/variation/linearised_motion.h"
#include "periodic/stroboscopic_map.h"
#include "random_models/keyed_model.h"
#include "random_models/random_model.h"
#include "random_models/random_text.h"
#include "random_models/windowed_motion.h"
#include "support/motion_derivative.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>

namespace vibroimpact::testing {

namespace {

using analyses::System;
using motion::MotionState;
constexpr double agreement = 1e-7;
constexpr double resolved = 1e-8;
constexpr double hopeless = 1e-5;
constexpr double variation_tolerance = 1e-12;
constexpr int most_motions = 2000; // for one window
// Keys move events within a window by no more than its length times the step, a thousandth;
// instants are rounded to 2e-16 of the time. Differences by keys need a longer window for seven
// digits.
constexpr double shortest_window = 2e-6; // of the time
// Where differences do not agree: they see the error of the motion's own steps.
constexpr std::array<double, 2> short_steps = {2e3, 2e4};
// What dies out within one, or leaves no room between events, shows in a shorter one, or in one
// before contacts come to rest.
constexpr std::array<WindowChoice, 8> choices = {{{.instants = 6, .margin = 1},
                                                  {.instants = 2, .margin = 1},
                                                  {.instants = 1, .margin = 1},
                                                  {.instants = 1, .margin = 0.1},
                                                  {.instants = 1, .margin = 0.01},
                                                  {.place = 0, .instants = 2, .margin = 1},
                                                  {.place = 0, .instants = 1, .margin = 0.1},
                                                  {.place = 0.6, .instants = 1, .margin = 0.1}}};

struct Comparison {
  double apart = 0; ///< relative to the column
  double open = 0;  ///< what the differences leave open
  bool compared = false, agrees = true;
  bool sharp() const { return compared && apart <= agreement; }
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
          .agrees = apart <= agreement || apart <= 10 * differences.error};
}

double seconds_of(const std::function<void()> &work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string word_of(const std::map<std::string, Found> &found) {
  std::string word = "agree";
  for (const auto &[what, one] : found)
    if (std::isnan(one.apart))
      return "unresolved";
    else if (one.apart > agreement)
      word = "agree but for rounding";
  return word;
}

class WindowJudge {
public:
  /// What `verdict` says of other windows is known.
  WindowJudge(KeyedModel &random, MotionWindow window, VariationVerdict verdict)
      : random_(random), window_(std::move(window)), verdict_(std::move(verdict)) {}

  VariationVerdict judge() {
    take_tolerance();
    if (!linearise())
      return verdict_;
    if (own_.without_derivative > 0) {
      verdict_.word = "no derivative";
      return verdict_;
    }
    compare_states();
    compare_keys();
    compare_determinant();
    compare_multipliers();
    if (verdict_.word.empty())
      verdict_.word = word_of(verdict_.found);
    return verdict_;
  }

private:
  // As tight as the number of steps allows.
  void take_tolerance() {
    for (const double tolerance : {1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8})
      try {
        random_.set_tolerance(tolerance);
        system_.emplace(random_.build({}));
        motion::Trajectory trajectory(system_->model, system_->contacts, tight(*system_));
        trajectory.start(window_.start);
        EventSequence sequence(system_->contacts.pairs());
        const double seconds = seconds_of([&] { trajectory.advance(window_.end, sequence); });
        seconds_ = seconds;
        window_.events = sequence.list;
        verdict_.events += static_cast<int>(sequence.list.size());
        verdict_.laws.merge(sequence.laws);
        verdict_.kinds.merge(sequence.kinds);
        scale_ = scale_of(*system_);
        return;
      } catch (const NumericalError &) {
        if (tolerance == 1e-8)
          throw;
      }
  }

  void add_keys() {
    for (const analyses::SweptParameter &key : random_.keys()) {
      std::vector<motion::KeyNeighbour> neighbours = analyses::key_neighbours(
          key, key.values.front(), [&](const Overrides &o) { return random_.build(o); });
      tangents_.push_back(std::make_unique<motion::KeyTangent>(
          key.path, system_->model, system_->contacts, std::move(neighbours)));
      keys_.push_back(key);
    }
  }

  // Where the motion has an end, so has its variation.
  bool linearise() {
    add_keys();
    motion::Settings settings = tight(*system_);
    settings.maximum_steps *= 100; // keys may need to see steps of a motion in closed form
    motion::Trajectory trajectory(system_->model, system_->contacts, settings);
    trajectory.start(window_.start);
    std::vector<motion::KeyTangent *> tangents;
    for (const auto &tangent : tangents_)
      tangents.push_back(tangent.get());
    const motion::VariationAccuracy accuracy{.scale = scale_, .tolerance = variation_tolerance};
    projection_ = motion::Variation(trajectory, scale_, variation_tolerance, tangents).projection();
    try {
      const double with = seconds_of(
          [&] { own_ = motion::Lineariser(trajectory, accuracy)(window_.start, window_.end); });
      verdict_.cost = with / seconds_;
      own_ = motion::Lineariser(trajectory, accuracy)(window_.start, window_.end, tangents);
    } catch (const NumericalError &error) {
      verdict_.word = "wrong";
      verdict_.detail = error.what();
      return false;
    }
    return true;
  }

  double size_of_state() const {
    return std::max(window_.start.physical.cwiseProduct(scale_).cwiseAbs().maxCoeff(),
                    own_.end.physical.cwiseProduct(scale_).cwiseAbs().maxCoeff());
  }

  bool wanted(const std::string &what) const {
    const auto known = verdict_.found.find(what);
    return known == verdict_.found.end() || !(known->second.apart <= agreement);
  }

  // The best of all windows counts; in each they must agree.
  void note(const Comparison &comparison, const std::string &what) {
    auto &best = verdict_.found.try_emplace(what).first->second;
    if (comparison.compared && !(best.apart <= comparison.apart))
      best = {.apart = comparison.apart, .open = comparison.open};
    if (!comparison.compared || comparison.agrees)
      return;
    verdict_.word = "wrong";
    verdict_.detail += " " + what + " differs by " + digits(comparison.apart) + ", open " +
                       digits(comparison.open) + ";";
  }

  std::optional<Vector> scaled_flow(const System &system, const Vector &deviation) const {
    if (++motions_ > most_motions)
      return std::nullopt;
    MotionState start = window_.start;
    start.physical += deviation;
    std::optional<Vector> end = end_of_motion(system, window_, start, maximum_step_);
    if (end)
      *end = end->cwiseProduct(scale_);
    return end;
  }

  // By shorter and shorter steps of the motions.
  Comparison compare_with_care(const std::function<Comparison()> &compare_once) {
    Comparison comparison = compare_once();
    for (const double steps : short_steps) {
      if (comparison.sharp() || std::isinf(comparison.open))
        break;
      maximum_step_ = (window_.end - window_.start.time) / steps;
      comparison = compare_once();
    }
    maximum_step_ = 0; // none
    return comparison;
  }

  void compare_states() {
    const Index size = scale_.size();
    differences_ = Matrix::Zero(size, size);
    all_columns_ = verdict_.multipliers.word.empty();
    for (Index j = 0; j < size; ++j) {
      const std::string what = "column " + std::to_string(j);
      if (!all_columns_ && !wanted(what))
        continue;
      const Vector direction = projection_.by_state.col(j);
      const double length = direction.cwiseProduct(scale_).cwiseAbs().maxCoeff();
      // What is held has no deviation but rounding.
      if (length <= 1e-12 * scale_[j])
        continue;
      const double step = 1e-3 * size_of_state() / length;
      const auto compare_once = [&] {
        const NumericalDerivative differences = numerical_derivative(
            [&](double e) { return scaled_flow(*system_, e * direction); }, step);
        if (differences.value.size() > 0)
          differences_.col(j) = differences.value / scale_[j];
        return compare(own_.by_state.col(j), differences, scale_, 1e-6 * length);
      };
      const Comparison comparison = compare_with_care(compare_once);
      all_columns_ = all_columns_ && comparison.compared;
      note(comparison, what);
    }
  }

  void compare_keys() {
    if (window_.end - window_.start.time < shortest_window * window_.start.time)
      return note_unresolved_keys();
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      if (!wanted(keys_[k].path))
        continue;
      const double value = keys_[k].values.front();
      const Vector direction = projection_.by_key.col(static_cast<Index>(k));
      const auto compare_once = [&] {
        const NumericalDerivative differences = numerical_derivative(
            [&](double e) -> std::optional<Vector> {
              try {
                return scaled_flow(random_.build({keys_[k].at(value + e)}), e * direction);
              } catch (const InputError &) {
                return std::nullopt;
              }
            },
            1e-3 * std::abs(value), 9);
        return compare(own_.by_key.col(static_cast<Index>(k)), differences, scale_,
                       1e-6 * size_of_state() / std::abs(value));
      };
      note(compare_with_care(compare_once), keys_[k].path);
    }
  }

  void note_unresolved_keys() {
    for (const analyses::SweptParameter &key : keys_)
      note({}, key.path);
  }

  // Of matrices that rounding leaves a determinant, and where nothing was projected.
  void compare_determinant() {
    const Eigen::FullPivLU<Matrix> lu(scaled());
    const Vector pivots = lu.matrixLU().diagonal().cwiseAbs();
    if (!projection_.by_state.isIdentity(0) || !(pivots.minCoeff() > 1e-7 * pivots.maxCoeff()))
      return;
    const double product = pivots.array().log().sum();
    const double apart = std::abs(product - own_.determinant.logarithm);
    verdict_.determinant =
        std::isnan(verdict_.determinant) ? apart : std::max(apart, verdict_.determinant);
    if (verdict_.determinant > 1e-7) {
      verdict_.word = "wrong";
      verdict_.detail += " determinant off by " + digits(verdict_.determinant) + ";";
    }
  }

  void compare_multipliers() {
    if (!all_columns_ || !verdict_.word.empty())
      return;
    verdict_.multipliers =
        compare_spectra(periodic::multipliers_of(own_.by_state, scale_), scaled(), differences_);
    if (verdict_.multipliers.word == "different") {
      verdict_.word = "wrong";
      verdict_.detail += " multipliers differ by " + digits(verdict_.multipliers.apart) + ";";
    }
  }

  Matrix scaled() const {
    return scale_.asDiagonal() * own_.by_state * scale_.cwiseInverse().asDiagonal();
  }

  mutable int motions_ = 0; ///< for the differences
  bool all_columns_ = true; ///< by differences in this window
  double maximum_step_ = 0; ///< of theirs [s]
  double seconds_ = 0;      ///< that the motion takes
  KeyedModel &random_;
  std::optional<System> system_;
  MotionWindow window_;
  Vector scale_;
  std::vector<analyses::SweptParameter> keys_;
  std::vector<std::unique_ptr<motion::KeyTangent>> tangents_;
  motion::LinearMap projection_;
  motion::LinearisedMotion own_;
  Matrix differences_; ///< of scaled states by scaled states
  VariationVerdict verdict_;
};

VariationVerdict judge_window(KeyedModel &random, const WindowChoice &choice,
                              VariationVerdict known) {
  try {
    random.set_tolerance(1e-10);
    const System system = random.build({});
    const double duration = random.set({})
                                ->root()
                                .instance("Analysis", "a")
                                .subsection("Transient")
                                .quantity("Duration");
    known.word.clear();
    return WindowJudge(random, find_window(system, duration, choice), known).judge();
  } catch (const InputError &error) {
    return {.word = "refused", .detail = error.what()};
  } catch (const NumericalError &error) {
    known.word = "failed";
    known.detail = error.what();
    return known;
  }
}

// In another window.
bool goes_on(const std::string &word) {
  return word == "unresolved" || word == "failed" || word == "no derivative" ||
         word == "agree but for rounding";
}

} // namespace

double VariationVerdict::largest() const {
  double largest = 0;
  for (const auto &[what, one] : found)
    largest = std::fmax(largest, one.apart); // not of NaN
  return largest;
}

VariationVerdict judge_variation(std::uint64_t seed, const std::string &folder) {
  KeyedModel random(random_model({.seed = seed}), folder);
  VariationVerdict verdict;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    verdict = judge_window(random, choices[i], std::move(verdict));
    verdict.window = static_cast<int>(i);
    if (!goes_on(verdict.word))
      break;
  }
  if ((verdict.word == "failed" || verdict.word == "no derivative") && !verdict.found.empty())
    verdict.word = word_of(verdict.found);
  for (const auto &[what, found] : verdict.found)
    if (!(found.apart <= agreement))
      verdict.detail +=
          " " + what + ": " + digits(found.apart) + ", open " + digits(found.open) + ";";
  return verdict;
}

} // namespace vibroimpact::testing
