// The list of analyses.
#include "analyses/analysis.h"

#include "analyses/basins/basin_shares.h"
#include "analyses/basins/basins.h"
#include "analyses/bilinear/bilinear_approximation.h"
#include "analyses/curves/balance_branch.h"
#include "analyses/curves/nonlinear_mode.h"
#include "analyses/curves/orbit_branch.h"
#include "analyses/curves/orbit_locus.h"
#include "analyses/curves/periodic_orbit.h"
#include "analyses/design/estimate.h"
#include "analyses/design/optimise.h"
#include "analyses/design/pareto_front.h"
#include "analyses/design/sensitivity.h"
#include "analyses/identification/identify.h"
#include "analyses/isolators/isolator_design.h"
#include "analyses/recorders/recorders.h"
#include "analyses/run/constants.h"
#include "analyses/run/grid.h"
#include "analyses/sweeps/frequency_response.h"
#include "analyses/sweeps/steady_state.h"
#include "analyses/sweeps/stepped_sweep.h"
#include "analyses/transient/campbell.h"
#include "analyses/transient/modal.h"
#include "analyses/transient/transient.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::analyses {

namespace {

struct Entry {
  const char *type;
  void (*declare)(parameters::Section &analysis);
  std::shared_ptr<const Analysis> (*create)(const parameters::Values &analysis);
  bool records = false;                                            ///< has recorders
  bool (*evaluates)(const parameters::Values &analysis) = nullptr; ///< another one; none: never
};

bool always(const parameters::Values & /*analysis*/) { return true; }

constexpr Entry known_analyses[] = {
    {"modal", Modal::declare, Modal::create},
    {"campbell", Campbell::declare, Campbell::create},
    {"transient", Transient::declare, Transient::create, true},
    {"stepped sweep", SteppedSweep::declare, SteppedSweep::create, true},
    {"frequency response", FrequencyResponse::declare, FrequencyResponse::create},
    {"bilinear approximation", BilinearApproximation::declare, BilinearApproximation::create},
    {"steady state", SteadyState::declare, SteadyState::create, true},
    {"branch", OrbitBranch::declare, OrbitBranch::create, true},
    {"nonlinear mode", NonlinearMode::declare, NonlinearMode::create, true},
    {"harmonic balance", BalanceBranch::declare, BalanceBranch::create},
    {"locus", OrbitLocus::declare, OrbitLocus::create, true},
    {"periodic orbit", PeriodicOrbit::declare, PeriodicOrbit::create, true},
    {"basins", Basins::declare, Basins::create},
    {"basin shares", BasinShares::declare, BasinShares::create},
    {"identify", Identify::declare, Identify::create},
    {"estimate", Estimate::declare, Estimate::create, false, always},
    {"optimise", Optimise::declare, Optimise::create, false, always},
    {"isolator design", IsolatorDesign::declare, IsolatorDesign::create, false,
     IsolatorDesign::evaluates},
    {"pareto front", ParetoFront::declare, ParetoFront::create, false, always},
    {"sensitivity", Sensitivity::declare, Sensitivity::create, false, always},
};

} // namespace

void declare_analyses(parameters::Section &root) {
  parameters::Section &analysis =
      root.named_subsection("Analysis", "Something to compute; its keys stand in the section of "
                                        "its type.");
  std::vector<std::string> types;
  for (const Entry &entry : known_analyses)
    types.emplace_back(entry.type);
  types.emplace_back(grid_type);
  analysis.choice("Type", "transient", types, "What is computed.");
  declare_constants(analysis);
  declare_selection(analysis, "all");
  declare_recorders(analysis);
  for (const Entry &entry : known_analyses)
    entry.declare(analysis);
  declare_grid(analysis);
}

bool evaluates_another(const parameters::Values &analysis) {
  const parameters::Values root = analysis.parameters().root();
  const std::string type = analysis.choice("Type");
  if (type == grid_type)
    return evaluates_another(
        root.instance("Analysis", repeated_analysis(analysis, root.instances("Analysis"))));
  const Entry *entry = std::find_if(std::begin(known_analyses), std::end(known_analyses),
                                    [&](const Entry &known) { return type == known.type; });
  return entry->evaluates != nullptr && entry->evaluates(analysis);
}

std::shared_ptr<const Analysis> create_analysis(const parameters::Values &analysis) {
  const std::string type = analysis.choice("Type");
  for (const Entry &entry : known_analyses)
    if (type == entry.type) {
      if (!entry.records && analysis.given("Record"))
        analysis.reject("Record", "must not be set when Type = " + analysis.choice("Type") +
                                      ", which has no recorders");
      return entry.create(analysis);
    }
  throw std::logic_error("analysis type without an entry: " + type);
}

} // namespace vibroimpact::analyses
