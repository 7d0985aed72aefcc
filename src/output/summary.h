// The few values of a run that a person or a test compares.
#pragma once

#include "contact/truncation.h"
#include "output/point_totals.h"
#include "output/record.h"
#include "output/summary_list.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::output {

/// `body.NAME.frequency[1] = 2.95 [Hz]`, counted from 1; then damping ratio, effective and total
/// mass along x, y, z, and for modal bodies the orthogonality residual.
SummaryList body_summary(const reduction::ReducedBody &body);

/// `contact.NAME.flexibility_share = 0.97 [1]` and `contact.NAME.impact_error = 0.008 [1]` of each
/// contact for which they are known.
SummaryList contact_summary(const std::vector<contact::ContactFigures> &contacts);

/// Nobody reads the lines of more points than this.
constexpr std::size_t most_listed_points = 100;

/// The lines of all points in the order of their index: `analysis.NAME.name = value [unit]`, with
/// outer axes `analysis.NAME[2,1,17].name`, counted from 1, below `# analysis.NAME[2,1,17]: TEXT`
/// for what a finished point says in words; then the lines of `totals`, to which
/// all points are added. Where more than most_listed_points have numbers these are left out and
/// `analysis.NAME.points` tells how many points there are; so are words of more points than that.
SummaryList analysis_summary(const AnalysisHeader &header, const derived::PointSequence &points,
                             PointTotals &totals);

} // namespace vibroimpact::output
