#include "analyses/isolators/isolator_results.h"

#include "analyses/isolators/isolator_averaging.h"
#include "analyses/results/fields.h"
#include "analyses/results/stacked_points.h"
#include "common/scalar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

using std::numbers::pi;

/// Columns of equal length along one dimension.
class Table {
public:
  Table(std::string dimension, std::string prefix)
      : dimension_(std::move(dimension)), prefix_(std::move(prefix)) {}
  void add(const std::string &name, double value, const std::string &description) {
    const auto same = [&](const Column &column) { return column.name == name; };
    auto found = std::find_if(columns_.begin(), columns_.end(), same);
    if (found == columns_.end())
      found = columns_.insert(columns_.end(), Column{name, description, {}});
    found->values.push_back(value);
  }
  void into(const FieldWriter &result) const {
    for (const Column &column : columns_)
      result.series(prefix_ + column.name, dimension_, column.values, "1", column.description);
  }

private:
  struct Column {
    std::string name, description;
    std::vector<double> values;
  };
  std::string dimension_, prefix_;
  std::vector<Column> columns_;
};

/// From 0 to 1, dense at both ends.
double share_of(std::size_t i, std::size_t points) {
  return (1 - std::cos(pi * static_cast<double>(i) / static_cast<double>(points - 1))) / 2;
}

double even_share(std::size_t i, std::size_t points) {
  return static_cast<double>(i) / static_cast<double>(points - 1);
}

} // namespace

void add_linear_step(const FieldWriter &result, const IsolatorSystem &isolator,
                     const StopConditions &conditions, std::optional<double> wanted) {
  const double zeta = conditions.damping.isolator;
  const FieldWriter listed = result.listed();
  result.number("natural_frequency", isolator.natural_frequency() / (2 * pi), "Hz",
                "of the isolator without stops");
  result.number("damping_ratio", zeta, "1", "zeta_0, of the isolator");
  result.number("stop_damping_ratio", conditions.damping.stop, "1",
                "zeta_1, of a stop, over the critical damping of the isolator");
  result.number("unfolding_ratio", conditions.unfolding_ratio, "1",
                "lambda in the first unfolding parameter");
  listed.number("working_ratio", conditions.working_ratio, "1",
                "lambda_w, working over natural frequency");
  listed.number("transmissibility", transmissibility(conditions.working_ratio, zeta), "1",
                "of the isolator at the working frequency");
  if (!wanted)
    return;
  result.number("wanted_transmissibility", *wanted, "1", "that the file asks for");
  listed.number("least_ratio", ratio_for_transmissibility(*wanted, zeta), "1",
                "frequency ratio from which the transmissibility is at most the wanted one");
  listed.number("least_ratio_undamped", undamped_ratio_for_transmissibility(*wanted), "1",
                "the same without damping, sqrt(1 + 1/T)");
}

void add_plane(const FieldWriter &result, const StopConditions &conditions, std::size_t points) {
  const double rho = conditions.damping.rho();
  const double force = conditions.largest_force();
  Table sets("set_point", "set/"), hysteresis("hysteresis_point", "hysteresis/");
  for (std::size_t i = 0; i < points; ++i) {
    const double first = even_share(i, points);
    sets.add("alpha_1", first, "first unfolding parameter");
    sets.add("b2", set_b2(first, rho), "alpha_2 on B2, where the force is zero");
    sets.add("b3_plus", set_b3_plus(first, rho), "alpha_2 on B3+");
    sets.add("b3_minus", set_b3_minus(first, rho), "alpha_2 on B3-");
    const double zeta = conditions.unfolding_ratio *
                        (conditions.damping.stop + conditions.damping.isolator); // pi/2 of alpha mu
    sets.add("largest_force", set_b2(first, rho) - std::pow(force * first / (2 * zeta), 2),
             "alpha_2 where f is the largest force that leaves the working frequency linear");
  }
  constexpr double least = 0.01;
  for (std::size_t i = 0; i < points; ++i) {
    const double z = least + (1 - least) * even_share(i, points);
    const HysteresisPoint cusp = hysteresis_set(z, rho);
    const StopChoice stop = stop_of(cusp.at, conditions.damping, conditions.unfolding_ratio);
    hysteresis.add("z", z, "clearance over the amplitude of the cusp");
    hysteresis.add("alpha_1", cusp.at.first, "first unfolding parameter on the hysteresis set");
    hysteresis.add("alpha_2", cusp.at.second, "second unfolding parameter there");
    hysteresis.add("eta", cusp.eta, "of the cusp");
    hysteresis.add("stiffness", stop.stiffness, "mu there");
    hysteresis.add("force", stop.force, "f there");
    hysteresis.add("frequency_ratio", std::sqrt(1 + stop.stiffness * (1 + 4 * cusp.eta / pi)),
                   "lambda of the cusp");
  }
  sets.into(result);
  hysteresis.into(result);
}

namespace {

void add_corner(const FieldWriter &result, const std::string &name, const StopChoice &stop,
                const StopConditions &conditions, const std::string &of) {
  const UnfoldingParameters at = unfolding_of(stop, conditions.damping, conditions.unfolding_ratio);
  const FieldWriter corner = result.below("corner/" + name + "/").listed();
  corner.number("force", stop.force, "1", "f " + of);
  corner.number("stiffness", stop.stiffness, "1", "mu " + of);
  corner.number("alpha_1", at.first, "1", "alpha_1 " + of);
  corner.number("alpha_2", at.second, "1", "alpha_2 " + of);
}

void add_curves(const FieldWriter &result, const StopConditions &conditions, std::size_t points) {
  Table limits("limit_point", "limit/");
  const double first = 1 / conditions.allowed, last = conditions.largest_force();
  for (std::size_t i = 1; i <= points && first < last; ++i) {
    const double force = first * std::pow(last / first, even_share(i, points + 1));
    const double least = conditions.least_stiffness(force);
    const UnfoldingParameters at =
        unfolding_of({least, force}, conditions.damping, conditions.unfolding_ratio);
    limits.add("force", force, "f, static displacement under the force over the clearance");
    limits.add("least_stiffness", least, "mu that the allowed displacement needs");
    limits.add("least_stiffness_alpha_1", at.first, "alpha_1 there");
    limits.add("least_stiffness_alpha_2", at.second, "alpha_2 there");
    limits.add("largest_stiffness", conditions.largest_stiffness(force),
               "mu up to which there is no jump, by the key Jump limit");
    limits.add("first_jump_stiffness", stiffness_of_first_jump(force, conditions.damping),
               "least mu with which the averaged response jumps");
  }
  limits.into(result);
}

} // namespace

void add_limits(const FieldWriter &result, const StopConditions &conditions,
                const StopCorners &corners, const IsolatorSystem &isolator, std::size_t points) {
  const FieldWriter listed = result.listed();
  listed.number("largest_force", conditions.largest_force(), "1",
                "f that leaves the working frequency linear");
  result.number("allowed_amplification", conditions.allowed, "1",
                "allowed displacement over the static one");
  result.number("margin", conditions.margin, "1", "by which the conditions are more than met");
  const double force = isolator.stop().force;
  listed.number("present/force", force, "1", "f with the clearance of the file");
  listed.number("present/least_stiffness", conditions.least_stiffness(force), "1",
                "mu that the allowed displacement needs with the clearance of the file");
  listed.number("present/largest_stiffness", conditions.largest_stiffness(force), "1",
                "mu up to which there is no jump with the clearance of the file");
  add_corner(result, "resonance_and_jump", corners.resonance_and_jump, conditions,
             "where the allowed displacement and the limit of jumps meet: the largest clearance");
  add_corner(result, "linear_and_resonance", corners.linear_and_resonance, conditions,
             "where the largest force and the allowed displacement meet: the softest stop");
  add_corner(result, "linear_and_jump", corners.linear_and_jump, conditions,
             "where the largest force and the limit of jumps meet");
  add_curves(result, conditions, points);
}

namespace {

void add_array(const FieldWriter &judged, const std::string &name, const std::string &dimension,
               const std::vector<double> &values, const std::string &description) {
  if (!values.empty())
    judged.series(name, dimension, values, "1", description);
}

void add_folds(const FieldWriter &judged, const std::string &method,
               const std::vector<double> &folds, const std::string &how) {
  judged.number(method + "/folds", static_cast<double>(folds.size()), "1",
                "folds of the response curve, " + how);
  add_array(judged, method + "/fold_ratio", method + "_fold", folds, "lambda of the folds, " + how);
}

// From one first touch over the peak to the other.
void add_averaged_curve(const FieldWriter &judged, const AveragedResponse &response,
                        std::size_t points) {
  Table curve("averaged_point", "averaged/");
  for (const int side : {0, 1})
    for (std::size_t i = 0; i < points && response.reaches_stop(); ++i) {
      const double share = share_of(side == 0 ? points - 1 - i : i, points);
      const double z = response.least_z() + (1 - response.least_z()) * share;
      curve.add("frequency_ratio", response.ratios(z)[static_cast<std::size_t>(side)],
                "lambda along the averaged response");
      curve.add("amplitude", 1 / z, "over the clearance, along the averaged response");
    }
  curve.into(judged);
}

// eta = -u +- sqrt(D), D = alpha_1^2 (rho z - 1) - alpha_2 z^2, between its zero and z = 1 or, on
// an isola, its other zero.
void add_expansion_curve(const FieldWriter &judged, const UnfoldingParameters &at, double rho,
                         double stiffness, std::size_t points) {
  const double a = at.first * at.first;
  const double root = std::sqrt(std::max(0.0, rho * rho * a * a - 4 * at.second * a));
  const double least = 2 * a / (rho * a + root); // the lower zero, without cancellation
  const double other = at.second > 0 ? (rho * a + root) / (2 * at.second) : 1;
  const double most = std::min(1.0, other);
  Table curve("expansion_point", "expansion/");
  for (const int side : {-1, 1})
    for (std::size_t i = 0; i < points && least < most; ++i) {
      const double z = least + (most - least) * share_of(side < 0 ? points - 1 - i : i, points);
      const double d = std::max(0.0, a * (rho * z - 1) - at.second * z * z);
      const double eta = side * std::sqrt(d) - (z - z * z * z / 6);
      curve.add("z", z, "clearance over amplitude along the curve of the expansion");
      curve.add("eta", eta, "frequency parameter along the curve of the expansion");
      curve.add("frequency_ratio", std::sqrt(1 + stiffness * (1 + 4 * eta / pi)),
                "lambda along the curve of the expansion");
    }
  curve.into(judged);
}

constexpr const char *stop_kinds =
    "1 chosen; corners: 2 of allowed displacement and limit of jumps, 3 of largest force and "
    "allowed displacement, 4 of largest force and limit of jumps; 5 to 8 an example of the regions "
    "I to IV; 9 of the file";

} // namespace

PointResult judge_by_averaging(const StopToJudge &stop, const IsolatorSystem &isolator,
                               const StopConditions &conditions, std::size_t points) {
  PointResult point;
  const FieldWriter judged(point);
  const UnfoldingParameters at =
      unfolding_of(stop.choice, conditions.damping, conditions.unfolding_ratio);
  const double rho = conditions.damping.rho();
  const Region region = region_of(at, rho);
  judged.number("kind", static_cast<double>(stop.kind), "1", stop_kinds);
  judged.number("alpha_1", at.first, "1", "first unfolding parameter");
  judged.number("alpha_2", at.second, "1", "second unfolding parameter");
  judged.number("region", static_cast<double>(region), "1",
                "1 to 4: I to IV, the last without folds; 0 where there is no force");
  judged.number("stiffness", stop.choice.stiffness, "1", "mu, over that of the isolator");
  judged.number("force", stop.choice.force, "1", "f, static displacement over clearance");
  judged.number("stop_stiffness", stop.choice.stiffness * isolator.stiffness, "N/m",
                "stiffness of the stop");
  judged.number("clearance", isolator.clearance_of(stop.choice), "m", "clearance of the stop");
  judged.number("expansion/folds", folds_in(region), "1",
                "folds of the response curve, by the expansion");
  add_expansion_curve(judged, at, rho, stop.choice.stiffness, points);
  const AveragedResponse response(conditions.damping, stop.choice);
  std::vector<double> folds;
  for (const AveragedPoint &fold : response.folds())
    folds.push_back(fold.ratio);
  add_folds(judged, "averaged", folds, "by averaging");
  const ResponsePeak peak = response.peak();
  judged.number("averaged/peak", peak.amplitude * isolator.clearance_of(stop.choice), "m",
                "largest amplitude by averaging");
  judged.number("averaged/peak_ratio", peak.ratio, "1", "lambda of the largest amplitude");
  add_averaged_curve(judged, response, points);
  return point;
}

void add_exact(PointResult &point, const ExactResponse &exact, double clearance) {
  const std::string how = "of periodic motions";
  point.reason = exact.failure;
  const FieldWriter judged(point);
  if (!exact.failure.empty()) {
    judged.number("exact/folds", nan, "1", "folds of the response curve, " + how);
    return;
  }
  add_folds(judged, "exact", exact.folds, how);
  judged.number("exact/peak", exact.peak * clearance, "m",
                "largest displacement of the periodic motions that were found");
  add_array(judged, "exact/frequency_ratio", "exact_point", exact.ratios,
            "lambda along the branch");
  add_array(judged, "exact/amplitude", "exact_point", exact.amplitudes,
            "largest displacement over the clearance along the branch");
  add_array(judged, "exact/stable", "exact_point", exact.stable, "1 where the motion is stable");
}

void add_judged(PointResult &result, const std::vector<PointResult> &judged) {
  summarise(result, "stop", judged,
            {"kind", "alpha_1", "alpha_2", "region", "stiffness", "force", "stop_stiffness",
             "clearance", "expansion/folds", "averaged/folds", "exact/folds", "averaged/peak",
             "exact/peak"});
  for (std::size_t i = 0; i < judged.size(); ++i)
    if (!judged[i].reason.empty())
      result.reason += (result.reason.empty() ? "" : "; ") + std::string("the branch of stop ") +
                       std::to_string(i + 1) + " is not followed: " + judged[i].reason;
  add_stacked({result, "stop/"}, judged, "design");
}

} // namespace vibroimpact::analyses
