#include "analyses/bilinear/bilinear_approximation.h"

#include "analyses/bilinear/bilinear_fields.h"
#include "analyses/keys/keyed_system.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/results/fields.h"
#include "common/error.h"
#include "parameters/text.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

namespace vibroimpact::analyses {

namespace {

constexpr const char *bilinear_approximation_section = "Bilinear approximation";

std::size_t source_of(const System &system, const std::string &excitation) {
  return sweep_source(system, excitation, "A bilinear approximation");
}

/// The stable one with the longest contact, else the one with the longest; nullptr when none is
/// admissible.
const BilinearMotion *chosen(const std::vector<BilinearMotion> &motions) {
  const BilinearMotion *best = nullptr;
  const auto rank = [](const BilinearMotion &motion) {
    return std::tuple(motion.largest_multiplier < 1, motion.contact_angle, motion.closes);
  };
  for (const BilinearMotion &motion : motions)
    if (motion.admissible() && (best == nullptr || rank(motion) > rank(*best)))
      best = &motion;
  return best;
}

std::size_t admissible(const std::vector<BilinearMotion> &motions) {
  return static_cast<std::size_t>(
      std::count_if(motions.begin(), motions.end(),
                    [](const BilinearMotion &motion) { return motion.admissible(); }));
}

std::string why_none(const std::vector<BilinearMotion> &motions) {
  std::map<std::string, int> counts;
  for (const BilinearMotion &motion : motions)
    ++counts[motion.objection];
  std::vector<std::string> parts;
  for (const auto &[objection, count] : counts)
    parts.push_back(objection + " in " + std::to_string(count));
  return "no motion with at most one open and one tied phase in each period; of " +
         std::to_string(motions.size()) + " solutions of the equations " +
         parameters::join(parts, ", ");
}

} // namespace

void BilinearApproximation::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(bilinear_approximation_section,
                  "Motions that open and close one contact once in each period and are tied there, "
                  "whatever its law, stitched together from linear responses.")
      .quantity("First frequency", "", dimension::frequency, range::positive, "f_1",
                "Lowest frequency.")
      .required()
      .quantity("Last frequency", "", dimension::frequency, range::positive, "f_2",
                "Highest frequency.")
      .required()
      .integer("Points", "200", Range{.lower = 1, .upper = 1e6}, "", "Number of frequencies.")
      .choice("Spacing", "linear", {"linear", "logarithmic"}, "How the frequencies are spaced.")
      .text("Excitation", "",
            "Harmonic excitation whose frequency is varied; empty when only one has a period. The "
            "others must be constant.")
      .integer("Cells", "360", Range{.lower = 8, .upper = 1e5}, "",
               "Equal parts of the period among which the time in contact is sought.")
      .integer("Samples per period", "720", Range{.lower = 32, .upper = 1e6}, "",
               "Samples of the history and of the search for extreme values.")
      .integer("Highest order", "10", Range{.lower = 1, .upper = 1000}, "",
               "Highest multiple of the frequency whose amplitude is given; at most a quarter of "
               "the samples.");
}

std::shared_ptr<const Analysis> BilinearApproximation::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(bilinear_approximation_section);
  Settings settings{.frequencies = read_frequencies(values),
                    .excitation = values.text("Excitation"),
                    .cells = static_cast<std::size_t>(values.integer("Cells")),
                    .samples = static_cast<std::size_t>(values.integer("Samples per period")),
                    .orders = static_cast<std::size_t>(values.integer("Highest order"))};
  if (4 * settings.orders > settings.samples)
    values.reject("Highest order", "must be at most a quarter of Samples per period, which is " +
                                       std::to_string(settings.samples) + ".");
  return std::make_shared<BilinearApproximation>(std::move(settings));
}

std::vector<Axis> BilinearApproximation::axes() const {
  SweptParameter frequency;
  frequency.values = settings_.frequencies;
  return {frequency.axis()};
}

void BilinearApproximation::check(const System &system) const {
  TiedSystem::check(system, source_of(system, settings_.excitation));
}

PointResult BilinearApproximation::compute(std::size_t point, const System &system) const {
  const double omega = 2 * std::numbers::pi * settings_.frequencies[point];
  const TiedSystem tied(system, source_of(system, settings_.excitation), omega);
  const std::vector<BilinearMotion> motions =
      bilinear_motions(tied, settings_.cells, settings_.samples);
  const BilinearMotion *motion = chosen(motions);
  if (motion == nullptr)
    throw NumericalError(why_none(motions));
  PointResult result{.index = {point}};
  add_bilinear_motion(result, system, tied, *motion, settings_.samples, settings_.orders);
  FieldWriter(result).number(
      "admissible_solutions", static_cast<double>(admissible(motions)), "1",
      "of the equations, whose contact only pushes and whose sides do not overlap");
  return result;
}

void BilinearApproximation::run_line(std::size_t line, System &system, LineContext &context) const {
  if (context.find({line}) != nullptr) {
    context.skip();
    return;
  }
  try {
    context.store(compute(line, system));
  } catch (const NumericalError &error) {
    context.store({.index = {line}, .status = Status::failed, .reason = error.what()});
  }
}

} // namespace vibroimpact::analyses
