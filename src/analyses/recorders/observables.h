// The quantities that are observed of motions: their names, what they are of a motion, and the
// choice of them in the parameter file.
//
// Displacements and velocities are relative to the base the body stands on, where that moves also
// in space; accelerations are absolute. At a contact change both one-sided values are seen, that
// before it at the end of a step and that after it at the start of the next.
#pragma once

#include "analyses/run/system.h"
#include "motion/interval/output.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct Observable {
  std::string path; ///< of its fields: "point/frame.head/displacement_x"
  std::string kind; ///< as in the key Quantities: "displacement"
  std::string unit;
  std::string meaning; ///< "displacement relative to the base"
  motion::OutputForm form;
  std::string supplement{};               ///< " along x"
  std::optional<std::size_t> impact_of{}; ///< of this contact: it says nothing before the first one

  std::string description() const { return meaning + supplement; }
  bool is_force() const { return std::holds_alternative<motion::ForceForm>(form); }
  /// Is it known in closed form where the motion is?
  bool is_linear() const { return !std::holds_alternative<motion::CurveForm>(form); }
};

/// False: it says nothing in the present modes, as what belongs to an impact between impacts.
bool is_seen(const Observable &observable, const motion::Equations &equations);
/// A quantity along one step; tau = 0 ... 1.
using StepFunction = std::function<double(double tau)>;
StepFunction along(const Observable &observable, const motion::StepView &view);

/// What is observed, by name; empty lists mean everything.
struct ObservedSelection {
  std::vector<std::string> points; ///< "body.point"
  std::vector<std::string> kinds;
  std::vector<std::string> connections{};

  bool has(const std::string &kind) const;
};

/// Of points, of connections, of contacts one after the other, of rotors.
std::vector<Observable> observables(const ObservedSelection &selection, const System &system);
/// Of points and connections alone, all of them motion::PointForm; `fixed`: displacements in space
/// also where no base moves the point.
std::vector<Observable> point_observables(const model::Model &model,
                                          const ObservedSelection &selection, bool fixed = false);
Observable gap_of(const contact::ContactSet &contacts, std::size_t contact);
Observable normal_force(const contact::ContactSet &contacts, std::size_t contact);
/// Moves the normal forces behind all others.
void put_forces_last(std::vector<Observable> &list);

/// Is a contact in a mode that counts as contact?
bool in_contact(const motion::StepView &view, std::size_t contact);

/// Declares the keys Points and Quantities; `more`: kinds beside those of observables().
void declare_selection_of_quantities(parameters::Section &section,
                                     const std::vector<std::string> &more = {});
/// InputError for kinds that do not exist.
ObservedSelection read_selection_of_quantities(const parameters::Values &section,
                                               const std::vector<std::string> &more = {});
/// Refuses names of points that the model does not have. InputError.
void check_points(const ObservedSelection &selection, const System &system,
                  const parameters::Values &section);

/// Declares the keys Points, Connections, Quantity and Contacts.
void declare_signals(parameters::Section &section);
/// What these keys choose. InputError for unknown names and when nothing is chosen.
std::vector<Observable> chosen_signals(const parameters::Values &values, const System &system);

/// Declares the keys Points and Connections.
void declare_points(parameters::Section &section);
/// Displacements, velocities or accelerations (`orders` 0, 1, 2) of the points and connections that
/// the keys choose. InputError for unknown names.
std::vector<Observable> chosen_points(const parameters::Values &values, const System &system,
                                      std::initializer_list<int> orders);
/// The contacts that `key` chooses: all, none, or names. InputError for unknown names.
std::vector<std::size_t> chosen_contacts(const parameters::Values &values, const std::string &key,
                                         const System &system);

} // namespace vibroimpact::analyses
