// Quantities of a motion by name, as functions along a step: for recorders that sample or integrate
// what the user chooses.
#pragma once

#include "analyses/channels.h"
#include "analyses/system.h"
#include "motion/observer.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// A quantity along one step; tau = 0 ... 1.
using StepFunction = std::function<double(double tau)>;

struct ObservedSignal {
  std::string name; ///< path of its fields: "point/frame.head/displacement_x"
  std::string unit;
  std::string description;
  std::function<StepFunction(const motion::StepView &view)> along;
};

/// Declares the keys Points, Quantity and Contacts.
void declare_signals(parameters::Section &section);
/// The signals that these keys choose. InputError for unknown names and when nothing is chosen.
std::vector<ObservedSignal> chosen_signals(const parameters::Values &values, const System &system);

/// Declares the key Points alone.
void declare_points(parameters::Section &section);
/// The channels of the points that the key Points chooses. InputError for unknown names.
std::vector<Channel> chosen_channels(const parameters::Values &values, const System &system);
/// The contacts that `key` chooses: all, none, or names. InputError for unknown names.
std::vector<std::size_t> chosen_contacts(const parameters::Values &values, const std::string &key,
                                         const System &system);

} // namespace vibroimpact::analyses
