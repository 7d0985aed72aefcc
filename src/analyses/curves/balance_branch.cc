#include "analyses/curves/balance_branch.h"

#include "analyses/curves/balance_table.h"
#include "analyses/keys/keyed_system.h"
#include "analyses/run/single_point.h"
#include "continuation/branch.h"
#include "continuation/harmonic_series.h"
#include "continuation/stored_steps.h"

#include <algorithm>
#include <numbers>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::HarmonicBalance;
using periodic::check_harmonic;
using periodic::HarmonicGrid;

namespace {

constexpr const char *balance_branch_section = "Harmonic balance";
constexpr const char *balance_subject = "A harmonic balance";

// Largest amplitude of the displacements, or clearance where nothing moves.
Vector sizes(const Matrix &elements, const contact::ContactSet &contacts) {
  double size = elements.rightCols(elements.cols() - 1).rowwise().norm().maxCoeff();
  if (size == 0)
    for (const contact::ContactPair &pair : contacts.pairs())
      size = std::max(size, std::abs(pair.clearance));
  return Vector::Constant(elements.rows(), size > 0 ? size : 1);
}

} // namespace

void BalanceBranch::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section =
      analysis.subsection(balance_branch_section,
                          "Periodic motions along a key as Fourier series of few harmonics: an "
                          "approximation to those of a branch, and with one harmonic averaging.");
  declare_branch_keys(section);
  section
      .integer("Harmonics", "5", Range{.lower = 1, .upper = 1000}, "H",
               "Harmonics of the forcing that the motion is made of.")
      .integer("Samples per period", "0", Range{.lower = 0, .upper = 1e6}, "",
               "Instants of a period at which forces are evaluated, in intervals of 6 by Gauss's "
               "rule that are cut where a contact begins or ends; at least 4 H + 2. 0: 24 H, at "
               "least 96: half a wave of the shortest product of harmonics in an interval, whose "
               "integral is then exact to 5e-10.")
      .quantities("Guess", "", dimension::none, range::any, "",
                  "Motion from which Newton's method starts, in SI, as the array `coefficients` of "
                  "another harmonic balance holds it: of each coordinate mean, cosine and sine of "
                  "the first harmonic, of the second... up to any one. Empty: the linear response, "
                  "as if no contact could close.",
                  0, 1000000)
      .text("Excitation", "",
            "Excitation whose period is that of the forcing, or whose frequency is the key; empty "
            "when there is only one with a period.");
}

std::shared_ptr<const Analysis> BalanceBranch::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(balance_branch_section);
  const SweptParameter parameter = read_key_range(values);
  Settings settings{.parameter = parameter,
                    .start_value = read_start(parameter, values),
                    .directions = read_direction(values),
                    .continuation = read_continuation(values, parameter),
                    .harmonics = values.integer("Harmonics"),
                    .samples = values.integer("Samples per period"),
                    .guess = values.quantities("Guess"),
                    .excitation = values.text("Excitation"),
                    .section = values};
  if (const long least = 4 * settings.harmonics + 2;
      settings.samples != 0 && settings.samples < least)
    values.reject("Samples per period", "must be 0 or at least " + std::to_string(least) + " for " +
                                            std::to_string(settings.harmonics) + " Harmonics.");
  return std::make_shared<BalanceBranch>(std::move(settings));
}

Index BalanceBranch::intervals() const {
  if (settings_.samples == 0)
    return periodic::default_intervals(settings_.harmonics);
  return (settings_.samples + HarmonicGrid::nodes - 1) / HarmonicGrid::nodes;
}

// At both ends of a frequency the other excitations must fit too.
void BalanceBranch::check(const System &system) const {
  const SweptParameter &parameter = settings_.parameter;
  check_start(parameter, settings_.start_value, system, settings_.excitation, balance_subject);
  const std::size_t source = sweep_source(system, settings_.excitation, balance_subject);
  check_harmonic(system.model, system.contacts, source, settings_.harmonics);
  if (parameter.is_frequency()) {
    model::Model model = system.model;
    model.set_frequency(source, 2 * std::numbers::pi * parameter.values.back());
    check_harmonic(model, system.contacts, source, settings_.harmonics);
  }
  check_guess(system);
}

// An odd number of coefficients for each coordinate, no more than the harmonics have.
void BalanceBranch::check_guess(const System &system) const {
  if (settings_.guess.empty())
    return;
  const auto given = static_cast<Index>(settings_.guess.size());
  const Index n = system.model.size(), most = 2 * settings_.harmonics + 1;
  if (given % n != 0 || (given / n) % 2 == 0 || given / n > most)
    settings_.section.value().reject(
        "Guess", "must have for each of " + std::to_string(n) +
                     " coordinates an odd number of coefficients, " + std::to_string(most) +
                     " at most for " + std::to_string(settings_.harmonics) + " Harmonics.");
}

Matrix BalanceBranch::guess(Index coordinates) const {
  const Index given = static_cast<Index>(settings_.guess.size()) / coordinates;
  const Matrix by_columns = Eigen::Map<const Matrix>(settings_.guess.data(), given, coordinates);
  return continuation::with_harmonics(by_columns.transpose(), settings_.harmonics);
}

PointResult BalanceBranch::compute(System &system, LineContext &context) const {
  const SweptParameter &parameter = settings_.parameter;
  const double key =
      start_value(parameter, settings_.start_value, system, settings_.excitation, balance_subject);
  const double range = parameter.values.back() - parameter.values.front();
  KeyedBalance balance(parameter, settings_.excitation, system, context, settings_.harmonics,
                       intervals());
  const auto m = balance.equations(key).rows.rows();
  HarmonicBalance unscaled(balance, settings_.harmonics, Vector::Ones(m), range);
  const Vector first = settings_.guess.empty() ? unscaled.linear_response(key)
                                               : unscaled.state_of(guess(system.model.size()), key);
  const auto scaled = [&](const Vector &state) {
    return HarmonicBalance(balance, settings_.harmonics,
                           sizes(unscaled.motion(state, key).elements, system.contacts), range);
  };
  HarmonicBalance rough = scaled(first);
  const std::unique_ptr<StepRecord> steps = context.steps({});
  const BranchPoint start = recorded(steps.get(), "start", [&] {
    return continuation::solve(rough, {.state = first, .keys = Vector::Constant(1, key)},
                               settings_.continuation);
  });
  const auto problem = std::make_shared<HarmonicBalance>(scaled(start.point.state));
  BalanceTable table(parameter, balance, *problem);
  BranchFollower(
      {settings_.directions, settings_.continuation}, table,
      [&](double share) { context.note_progress(share); }, steps.get())
      .run(problem, 0, start);
  PointResult result;
  table.add_fields(result);
  return result;
}

void BalanceBranch::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
