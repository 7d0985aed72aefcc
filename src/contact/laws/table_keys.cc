#include "contact/laws/table_keys.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibroimpact::contact {

namespace {

using parameters::Values;

constexpr const char *section_name = "Table";
constexpr int most_points = 1000;

void declare_curve(parameters::Section &law, const std::string &prefix, const std::string &symbol,
                   const std::string &penetrations, const std::string &forces) {
  using namespace parameters;
  const std::string force = prefix.empty() ? "Force" : prefix + " force";
  const std::string penetration = prefix.empty() ? "Penetration" : prefix + " penetration";
  law.quantities(penetration, "", dimension::length, range::non_negative, "u_" + symbol,
                 penetrations, 2, most_points);
  if (prefix.empty())
    law.required();
  law.quantities(force, "", dimension::force, range::non_negative, "F_" + symbol, forces, 2,
                 most_points);
  law.required(prefix.empty() ? "" : penetration + " is given");
}

/// Two lists as a curve that begins at (0, 0).
ForceCurve read_curve(const Values &law, const std::string &penetration, const std::string &force) {
  law.require(force);
  const std::vector<double> lengths = law.quantities(penetration);
  const std::vector<double> forces = law.quantities(force);
  if (lengths.size() != forces.size())
    law.reject(force, "must have as many values as " + penetration + ", " +
                          std::to_string(lengths.size()) + ".");
  if (lengths.front() != 0)
    law.reject(penetration, "must begin with 0.");
  if (forces.front() != 0)
    law.reject(force, "must begin with 0: the force must not jump where the sides touch.");
  if (std::adjacent_find(lengths.begin(), lengths.end(), std::greater_equal<>()) != lengths.end())
    law.reject(penetration, "must increase from value to value.");
  if (forces.back() < forces[forces.size() - 2])
    law.reject(force, "must not fall at the end: the last two values are continued straight, so "
                      "that the force would pull.");
  return {lengths, forces};
}

/// Only the first segment of the loading curve, with others behind it, may be as steep.
void check_slopes(const Values &law, const ForceCurve &curve, bool loading) {
  const double stiffness = law.quantity("Unloading stiffness");
  for (std::size_t s = 0; s < curve.n_segments(); ++s) {
    const double slope = curve.slope(s);
    const bool elastic =
        loading && s == 0 && curve.n_segments() > 1 && CrushCurves::is_elastic(slope, stiffness);
    if (!elastic && !(slope < stiffness))
      law.reject("Unloading stiffness",
                 "must be above all slopes of the curves, but for a first, elastic segment of "
                 "Force; one is " +
                     std::to_string(slope) + " N/m.");
  }
}

CrushCurves read_crush(const Values &law, const ForceCurve &loading) {
  law.require("Unloading stiffness");
  if (std::count(loading.forces().begin(), loading.forces().end(), 0.0) > 1)
    law.reject("Force", "must be above zero behind the first value when there is an Unloading "
                        "stiffness.");
  check_slopes(law, loading, true);
  std::optional<ForceCurve> unloading;
  if (law.has("Unloading penetration"))
    unloading = read_curve(law, "Unloading penetration", "Unloading force");
  if (unloading)
    check_slopes(law, *unloading, false);
  if (law.quantity("Damping constant") != 0)
    law.reject("Damping constant", "must be 0 N s/m when there is an Unloading stiffness.");
  try {
    return {loading, unloading, law.quantity("Unloading stiffness")};
  } catch (const std::invalid_argument &refused) {
    law.reject("Unloading force", refused.what());
  }
}

} // namespace

void declare_table(parameters::Section &contact) {
  using namespace parameters;
  Section &law = contact.subsection(
      section_name, "Force over penetration as a list of points with straight lines between them; "
                    "the last line goes on. With an Unloading stiffness the stop crushes: a "
                    "residual penetration stays and grows from impact to impact.");
  declare_curve(law, "", "i", "Penetrations of the points, increasing from 0.",
                "Normal forces at these penetrations, the first of which is 0.");
  law.quantity("Unloading stiffness", "", dimension::stiffness, range::positive, "K",
               "Slope at which the force falls where the motion turns, down to zero or to the "
               "unloading curve; steeper than both curves, but for a first, elastic segment of the "
               "loading curve.")
      .required("Unloading penetration is given");
  declare_curve(law, "Unloading", "j",
                "Penetrations of the points of an unloading curve, increasing from 0. Without it "
                "the stop does not come back.",
                "Normal forces at these penetrations, below those of the loading curve.");
  law.quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c",
               "Contact force per unit penetration rate, in addition to the table.")
      .choice("Tension", "cut off", {"cut off", "pull"},
              "What happens where the dashpot would pull: no force, or the pull.");
}

TableKeys read_table(const Values &contact) {
  const Values law = contact.subsection(section_name);
  law.require("Penetration");
  const ForceCurve loading = read_curve(law, "Penetration", "Force");
  TableKeys keys{.loading = loading,
                 .damping_constant = law.quantity("Damping constant"),
                 .pulls = law.choice("Tension") == "pull"};
  if (law.has("Unloading force") && !law.has("Unloading penetration"))
    law.reject("Unloading force", "must not be set when Unloading penetration is not set.");
  if (law.has("Unloading stiffness") || law.has("Unloading penetration"))
    keys.crush = read_crush(law, loading);
  return keys;
}

} // namespace vibroimpact::contact
