#include "integration/flight_watcher.h"

#include <atomic>
#include <utility>

namespace vibroimpact::integration {

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
  for (std::size_t k = 0; k < projection.carrier.size(); ++k)
    form.row[layout.physical_size() + 3 * static_cast<Index>(k) + derivative] =
        projection.carrier[k];
  return form;
}

} // namespace

WatchedForm watched_displacement(const Equations &equations, const Projection &projection,
                                 Extent &extent) {
  return {.row = row_of(equations, projection, 0), .extent = &extent};
}

WatchedForm watched_velocity(const Equations &equations, const Projection &projection,
                             Extent &extent) {
  return {.row = row_of(equations, projection, 1), .extent = &extent};
}

WatchedForm watched_acceleration(const Equations &equations, const Projection &projection,
                                 Extent &extent) {
  return {.row = row_of(equations, projection, 1), .differentiated = true, .extent = &extent};
}

WatchedForm watched_contact(const Equations &equations, std::size_t contact,
                            const contact::AffineForm &form, Extent &extent) {
  return {.row = linear_row(equations, contact, form), .extent = &extent};
}

WatchedForm watched_state(const Equations &equations, Index entry, double constant,
                          Extent &extent) {
  LinearRow form = nothing(equations);
  form.row[entry] = 1;
  form.constant = constant;
  return {.row = std::move(form), .extent = &extent};
}

WatchedForms::WatchedForms(const std::vector<WatchedForm> &forms)
    : rows(static_cast<Index>(forms.size()), forms.empty() ? 0 : forms[0].row.row.size()) {
  for (const WatchedForm &form : forms) {
    rows.row(static_cast<Index>(extents.size())) = form.row.row;
    constants.push_back(form.row.constant);
    differentiated.push_back(form.differentiated);
    extents.push_back(form.extent);
  }
}

FlightWatcher::FlightWatcher() {
  static std::atomic<long> watchers = 0;
  identity_ = watchers++;
}

} // namespace vibroimpact::integration
