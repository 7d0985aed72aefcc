// What an isolator design has found, as fields and summary lines.
#pragma once

#include "analyses/isolators/isolator_branches.h"
#include "analyses/isolators/isolator_constraints.h"
#include "analyses/results/field_writer.h"

#include <optional>
#include <vector>

namespace vibroimpact::analyses {

/// Numbers of the field `stop/kind`.
enum class StopKind {
  chosen = 1,
  resonance_and_jump = 2,
  linear_and_resonance = 3,
  linear_and_jump = 4,
  region_one = 5,
  region_two = 6,
  region_three = 7,
  region_four = 8,
  listed = 9
};

struct StopToJudge {
  StopKind kind = StopKind::listed;
  StopChoice choice;
};

/// Natural frequency, damping ratios, and transmissibility at the working frequency; where one is
/// wanted, the least frequency ratio for it, exact and without damping.
void add_linear_step(const FieldWriter &result, const IsolatorSystem &isolator,
                     const StopConditions &conditions, std::optional<double> transmissibility);

/// The bifurcation sets along alpha_1 and the hysteresis set along z.
void add_plane(const FieldWriter &result, const StopConditions &conditions, std::size_t points);

/// The conditions along f, their corners, and the two limits of the stiffness at the present f.
void add_limits(const FieldWriter &result, const StopConditions &conditions,
                const StopCorners &corners, const IsolatorSystem &isolator, std::size_t points);

/// Place of a stop in the plane, its region, its averaged response curve and the expansion of that.
PointResult judge_by_averaging(const StopToJudge &stop, const IsolatorSystem &isolator,
                               const StopConditions &conditions, std::size_t points);
/// Its exact response, the stop having this clearance [m].
void add_exact(PointResult &judged, const ExactResponse &exact, double clearance);

/// Arrays over the stops, of which the first is the chosen one where there is one; the summary
/// lists them.
void add_judged(PointResult &result, const std::vector<PointResult> &judged);

} // namespace vibroimpact::analyses
