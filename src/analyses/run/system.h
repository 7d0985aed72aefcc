// Everything a motion needs, built from a parameter file and the reduced bodies.
#pragma once

#include "contact/contact_set.h"
#include "model/initial_condition.h"
#include "model/model.h"
#include "motion/settings.h"
#include "parameters/values.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct System {
  model::Model model;
  contact::ContactSet contacts;
  motion::Settings integration;
  model::InitialState initial;
};

/// Builds the system of an analysis at other values of some keys. Local; InputError.
using SystemSource = std::function<System(const std::vector<parameters::Override> &)>;

/// The keys with which an analysis picks excitations, contacts and initial conditions.
void declare_selection(parameters::Section &analysis, const std::string &initial_default);

/// The system an analysis works on. `bodies` are the reduced bodies of the file.
System build_system(const parameters::Values &root, const parameters::Values &analysis,
                    std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies);

/// Names in a list key at the top of the file, or every instance of `kind` when the key is empty.
/// InputError for a name that has no section.
std::vector<std::string> listed_instances(const parameters::Values &root, const std::string &key,
                                          const std::string &kind);

} // namespace vibroimpact::analyses
