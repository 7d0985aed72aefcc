#include "analyses/isolators/isolator_branches.h"

#include "analyses/curves/branch_rows.h"
#include "analyses/design/design_keys.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using parameters::Override;
using parameters::Values;

namespace {

SweptParameter read_key(const Values &section, const char *key, const std::string &other) {
  section.require(key);
  const std::string path = section.key_path(key);
  const auto number = section.parameters().number_at(path);
  if (!number)
    section.reject(key, "must be a key with one number as its value");
  if (path == other)
    section.reject(key, "must be another key than Stiffness key");
  return {.path = path, .unit = number->unit, .values = {}, .origin = section.place(key) + ":"};
}

bool among(const std::string &name, const std::vector<std::string> &names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Without the key Record a branch records them too.
bool records_displacements(const Values &branch) {
  const std::vector<std::string> recorded = branch.names("Record");
  const std::vector<std::string> quantities =
      branch.subsection("Extreme values").names("Quantities");
  return (recorded.empty() || among("extreme values", recorded)) &&
         (among("all", quantities) || among("displacement", quantities));
}

bool equal(double one, double other) {
  return std::abs(one - other) <= 1e-9 * std::max(std::abs(one), std::abs(other));
}

bool same_isolator(const IsolatorSystem &one, const IsolatorSystem &other) {
  return equal(one.mass, other.mass) && equal(one.stiffness, other.stiffness) &&
         equal(one.damping, other.damping) && equal(one.stop_damping, other.stop_damping) &&
         equal(one.force, other.force);
}

const std::vector<double> &values_of(const Evaluated &evaluated, std::size_t name) {
  return evaluated.outcomes.at(name).values;
}

bool is_turning_point(double kind) {
  return kind == kind_number(continuation::Special::fold) ||
         kind == kind_number(continuation::Special::grazing_fold);
}

// 0 and 1 are the ends of the range of the key.
void check_ends(const std::vector<double> &reasons) {
  for (const double reason : reasons)
    if (reason != 0 && reason != 1)
      throw NumericalError("it ends between the ends of its range, so that folds may be missing "
                           "(field end/reason of the branch: " +
                           std::to_string(std::lround(reason)) + ")");
}

std::vector<double> ratios_of(const Outcome &frequencies, const IsolatorSystem &isolator) {
  std::vector<double> ratios;
  for (const double frequency : frequencies.values)
    ratios.push_back(frequencies.one.value * frequency / isolator.natural_frequency());
  return ratios;
}

bool turns(const std::vector<double> &ratios) {
  for (std::size_t i = 2; i < ratios.size(); ++i)
    if ((ratios[i] - ratios[i - 1]) * (ratios[i - 1] - ratios[i - 2]) < 0)
      return true;
  return false;
}

} // namespace

void IsolatorBranches::declare(parameters::Section &section) {
  section
      .text("Repeat", "",
            "Name of an analysis of the type branch over the frequency, which records the "
            "extreme values; with it the folds are also found exactly. Empty means by averaging "
            "alone.")
      .text("Stiffness key", "",
            "With Repeat: key whose value in SI is the stiffness of the stops, as for --set: "
            "Variables/stop_stiffness.")
      .required("Repeat is given")
      .text("Clearance key", "",
            "With Repeat: key whose value in SI is the clearance of both stops.")
      .required("Repeat is given");
}

IsolatorBranches::IsolatorBranches(const Values &section) {
  if (!section.has("Repeat")) {
    for (const char *key : {"Stiffness key", "Clearance key"})
      if (section.has(key))
        section.reject(key, "must not be set when Repeat is not set");
    return;
  }
  evaluated_ = evaluated_analysis(section);
  const Values repeated = section.parameters().root().instance("Analysis", evaluated_);
  if (repeated.choice("Type") != "branch")
    section.reject("Repeat", "must be an analysis of the type branch");
  if (repeated.subsection("Branch").has("Parameter"))
    section.reject("Repeat", "must be a branch over the frequency, without the key Parameter");
  if (!records_displacements(repeated))
    section.reject("Repeat", "must be a branch that records extreme values of displacements");
  stiffness_ = read_key(section, "Stiffness key", "");
  clearance_ = read_key(section, "Clearance key", stiffness_.path);
}

std::vector<std::string> IsolatorBranches::keys() const {
  if (evaluated_.empty())
    return {};
  return {stiffness_.path, clearance_.path};
}

std::vector<Override> IsolatorBranches::overrides(const StopChoice &stop,
                                                  const IsolatorSystem &isolator) const {
  return {stiffness_.at(stop.stiffness * isolator.stiffness),
          clearance_.at(isolator.clearance_of(stop))};
}

void IsolatorBranches::check(const SystemSource &build, const std::string &excitation) const {
  if (evaluated_.empty())
    return;
  const IsolatorSystem isolator = read_isolator(build({}), excitation);
  const StopChoice other{.stiffness = 1.25 * isolator.stop().stiffness + 0.5,
                         .force = 0.75 * isolator.stop().force};
  const IsolatorSystem changed = read_isolator(build(overrides(other, isolator)), excitation);
  const auto refuse = [](const SweptParameter &key, const std::string &what) {
    throw InputError(key.origin + " " + key.path + " must be " + what + ".");
  };
  if (!equal(changed.stop_stiffness, other.stiffness * isolator.stiffness))
    refuse(stiffness_, "the stiffness of both stops in N/m");
  if (!equal(changed.clearance, isolator.clearance_of(other)))
    refuse(clearance_, "the clearance of both stops in m");
  if (!same_isolator(isolator, changed))
    refuse(stiffness_, "a key that, like the Clearance key, changes nothing but the stops");
}

// The arrays of special points are there only where the branch has any, which a graze may be too.
ExactResponse IsolatorBranches::follow(const StopChoice &stop, const IsolatorSystem &isolator,
                                       const Outcomes &outcomes,
                                       const std::function<void(double share)> &progress) const {
  const std::vector<Override> changes = overrides(stop, isolator);
  const std::string displacement =
      "point/" + isolator.point + "/displacement_" + isolator.axis + "/";
  const auto run = [&](const std::vector<std::string> &names) {
    return outcomes.evaluate(evaluated_, changes, names, progress);
  };
  ExactResponse response;
  try {
    const Evaluated points = run(
        {"frequency", "stable", displacement + "maximum", displacement + "minimum", "end/reason"});
    check_ends(values_of(points, 4));
    response.ratios = ratios_of(points.outcomes.at(0), isolator);
    response.stable = values_of(points, 1);
    for (std::size_t i = 0; i < response.ratios.size(); ++i) {
      const double largest =
          std::max(std::abs(values_of(points, 2)[i]), std::abs(values_of(points, 3)[i]));
      response.amplitudes.push_back(largest / isolator.clearance_of(stop));
      response.peak = std::fmax(response.peak, response.amplitudes.back());
    }
    if (!turns(response.ratios))
      return response;
    const Evaluated special = run({"special/frequency", "special/kind"});
    const std::vector<double> ratios = ratios_of(special.outcomes.at(0), isolator);
    for (std::size_t i = 0; i < ratios.size(); ++i)
      if (is_turning_point(values_of(special, 1)[i]))
        response.folds.push_back(ratios[i]);
    std::sort(response.folds.begin(), response.folds.end());
  } catch (const NumericalError &error) {
    response.failure = error.what();
  }
  return response;
}

} // namespace vibroimpact::analyses
