// Fields that several analyses share.
#pragma once

#include "analyses/results/field_writer.h"
#include "contact/contact_set.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Dimension of states. Another name than that of the field, whose values are no coordinate.
inline constexpr const char *state_dimension = "state_index";

/// What a motion has settled to.
void add_settled(const FieldWriter &result, bool steady, long multiple, long cycles);

/// Accuracy of a motion as fields and summary lines.
void add_accuracy(const FieldWriter &result, const motion::Accuracy &accuracy,
                  const motion::Settings &settings);

/// True when the energy balance of the motion did not close.
bool unbalanced(const PointResult &result);
/// True when the motion was recorded before it was judged steady.
bool recorded_unsettled(const PointResult &result);
/// Touches of the motion that rounding decides.
double undecided_events(const PointResult &result);

/// Impact tables of all contacts as fields, and as summary lines of the first `summary_lines`; sums
/// and maxima of the groups of contacts.
void add_impacts(const FieldWriter &result, const contact::ContactSet &contacts,
                 const motion::ImpactLog &log, std::size_t summary_lines);

/// Force samples of the recorded impacts of all contacts, impacts separated by NaN.
void add_pulses(const FieldWriter &result, const contact::ContactSet &contacts,
                const motion::ImpactLog &log);

} // namespace vibroimpact::analyses
