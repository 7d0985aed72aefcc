// The quantities that recorders watch, as polynomials along a step: those of the named points, of
// the contacts and of the rotors, and the choice of them in the parameter file.
//
// Displacements and velocities are relative to the base the body stands on, where that moves also
// in space; accelerations are absolute. At a contact change both one-sided values are seen, that
// before it at the end of a step and that after it at the start of the next.
#pragma once

#include "analyses/system.h"
#include "motion/observer.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct ObservedQuantity {
  std::string path; ///< of its fields: "point/frame.head/displacement_x"
  std::string kind; ///< as in the key Quantities: "displacement"
  std::string unit;
  std::string meaning; ///< "displacement relative to the base along x"
  std::function<motion::Bernstein(const motion::StepView &view)> curve;
  /// The same where it is linear in the motion; none where it is not.
  std::function<motion::MonitoredForm(const motion::Equations &equations,
                                      motion::ValueRange &range)>
      form{};
};

/// What a recorder watches, by name; empty lists mean everything.
struct ObservedSelection {
  std::vector<std::string> points; ///< "body.point"
  std::vector<std::string> kinds;

  bool has(const std::string &kind) const;
};

/// Declares the keys Points and Quantities.
void declare_selection_of_quantities(parameters::Section &section);
/// InputError for kinds that do not exist.
ObservedSelection read_selection_of_quantities(const parameters::Values &section);
/// Refuses names of points that the model does not have. InputError.
void check_points(const ObservedSelection &selection, const System &system,
                  const parameters::Values &section);

/// All quantities of the selection but the contact forces, which are no polynomials.
std::vector<ObservedQuantity> observed_quantities(const ObservedSelection &selection,
                                                  const System &system);

/// Is a contact in a mode that counts as contact?
bool in_contact(const motion::StepView &view, std::size_t contact);

} // namespace vibroimpact::analyses
