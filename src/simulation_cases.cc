// The cases of analyses: what they run on, and how the analyses that they evaluate are repeated.
#include "analyses/run/constants.h"
#include "simulation.h"

namespace vibroimpact {

using parameters::Override;
using parameters::ParameterSet;
using parameters::Values;

namespace {

/// The section whose contacts, excitations and initial conditions an analysis works with: that of
/// the analysis it evaluates, if it does.
Values selecting_section(const Values &root, const std::string &name) {
  const Values section = root.instance("Analysis", name);
  if (section.choice("Type") == analyses::grid_type)
    return selecting_section(root,
                             analyses::repeated_analysis(section, root.instances("Analysis")));
  const std::string evaluated = analyses::create_analysis(section)->evaluated();
  return evaluated.empty() ? section : selecting_section(root, evaluated);
}

} // namespace

analyses::Case Simulation::build_case(const Job &job,
                                      const std::vector<Override> &overrides) const {
  return build_case(overrides.empty() ? job.parameters : job.parameters->with(overrides),
                    job.repeated);
}

analyses::Case Simulation::build_case(const std::shared_ptr<const ParameterSet> &parameters,
                                      const std::string &name) const {
  const Values root = parameters->root();
  analyses::Case work{
      .analysis = analyses::create_analysis(root.instance("Analysis", name)),
      .system = analyses::build_system(root, selecting_section(root, name), bodies(root)),
      .source = [this, parameters, name](const std::vector<Override> &more) {
        const Values changed = parameters->with(more)->root();
        return analyses::build_system(changed, selecting_section(changed, name), bodies(changed));
      }};
  if (!work.analysis->evaluated().empty())
    work.outcomes = std::make_shared<derived::RepeatedAnalysis>(
        [this, parameters](const std::string &evaluated, const std::vector<Override> &more) {
          return repetition(parameters, evaluated, more);
        });
  return work;
}

// The keys that the search changes have the last word.
derived::Repetition Simulation::repetition(const std::shared_ptr<const ParameterSet> &around,
                                           const std::string &name,
                                           const std::vector<Override> &changes) const {
  const Values section = around->root().instance("Analysis", name);
  const bool grid = section.choice("Type") == analyses::grid_type;
  const std::string repeated =
      grid ? analyses::repeated_analysis(section, around->root().instances("Analysis")) : name;
  const std::vector<std::string> names =
      grid ? std::vector<std::string>{repeated, name} : std::vector<std::string>{name};
  const auto parameters = analyses::with_constants(around, names)->with(changes);
  const Values root = parameters->root();
  const auto keys = grid ? analyses::read_grid(root.instance("Analysis", name), repeated)
                         : std::vector<analyses::GridKey>{};
  return {.root = root,
          .analysis = name,
          .keys = keys,
          .outer_axes = analyses::grid_axes(keys, *parameters),
          .factory = [this, parameters, repeated](const std::vector<Override> &more) {
            return build_case(more.empty() ? parameters : parameters->with(more), repeated);
          }};
}

} // namespace vibroimpact
