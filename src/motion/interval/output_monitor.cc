#include "motion/interval/output_monitor.h"

#include <atomic>
#include <utility>

namespace vibroimpact::motion {

using model::Projection;

namespace {

LinearRow nothing(const Equations &equations) {
  const auto n_sources = static_cast<Index>(equations.model().sources().size());
  return {.row = RowVector::Zero(equations.layout().physical_size() + 3 * n_sources)};
}

// `derivative`: 0 for coordinates and sources, 1 for their rates.
LinearRow row_of(const Equations &equations, const Projection &projection, Index derivative) {
  const StateLayout &layout = equations.layout();
  LinearRow form = nothing(equations);
  form.row.segment(derivative * layout.velocity(), layout.n) = projection.row;
  for (std::size_t k = 0; k < projection.base_coefficients.size(); ++k)
    form.row[layout.physical_size() + 3 * static_cast<Index>(k) + derivative] =
        projection.base_coefficients[k];
  return form;
}

} // namespace

MonitoredForm monitored_displacement(const Equations &equations, const Projection &projection,
                                     ValueRange &range) {
  return {.row = row_of(equations, projection, 0), .range = &range};
}

MonitoredForm monitored_velocity(const Equations &equations, const Projection &projection,
                                 ValueRange &range) {
  return {.row = row_of(equations, projection, 1), .range = &range};
}

MonitoredForm monitored_acceleration(const Equations &equations, const Projection &projection,
                                     ValueRange &range) {
  return {.row = row_of(equations, projection, 1), .differentiated = true, .range = &range};
}

MonitoredForm monitored_contact(const Equations &equations, std::size_t contact,
                                const contact::AffineForm &form, ValueRange &range) {
  return {.row = linear_row(equations, contact, form), .range = &range};
}

MonitoredForm monitored_force(const Equations &equations, std::size_t contact, ValueRange &range) {
  const contact::Mode &mode = equations.mode(contact);
  if (mode.affine)
    return monitored_contact(equations, contact, mode.affine->force, range);
  return {.contact = contact, .range = &range};
}

MonitoredForm monitored_state(const Equations &equations, Index entry, double constant,
                              ValueRange &range) {
  LinearRow form = nothing(equations);
  form.row[entry] = 1;
  form.constant = constant;
  return {.row = std::move(form), .range = &range};
}

MonitoredForms::MonitoredForms(const std::vector<MonitoredForm> &forms) {
  for (const MonitoredForm &form : forms) {
    if (form.contact) {
      forces.push_back({.contact = *form.contact, .range = form.range});
      continue;
    }
    const auto place = static_cast<Index>(ranges.size());
    rows.conservativeResize(place + 1, form.row.row.size());
    rows.row(place) = form.row.row;
    constants.push_back(form.row.constant);
    differentiated.push_back(form.differentiated);
    ranges.push_back(form.range);
  }
}

OutputMonitor::OutputMonitor() {
  static std::atomic<long> monitors = 0;
  identity_ = monitors++;
}

} // namespace vibroimpact::motion
