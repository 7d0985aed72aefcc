#include "contact/attachment_damping.h"

#include "reduction/known_flexibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vibroimpact::contact {

namespace {

constexpr double enough_damping = 0.05;
// Ratios come back from the damping matrix: one that was given as enough is so.
constexpr double least_damping = enough_damping * (1 - 1e-9);

/// Of the highest coordinate that moves the point and is no normal mode, since nothing bounds its
/// error as one; infinite without any.
double attached_damping_ratio(const reduction::ReducedBody &body, const RowVector &row) {
  const Vector omega = body.omega();
  const Vector ratios = body.damping_ratio();
  double highest = 0;
  double ratio = std::numeric_limits<double>::infinity();
  for (Index j = 0; j < body.eigen_residual.size(); ++j)
    if (std::isnan(body.eigen_residual[j]) && row[j] != 0 && omega[j] > highest) {
      highest = omega[j];
      ratio = ratios[j];
    }
  return ratio;
}

double attached_damping_ratio(const std::string &side, const Vector3 &normal,
                              const model::Model &model) {
  model::PointReference reference;
  if (!model.find_point(side, reference))
    return std::numeric_limits<double>::infinity();
  const reduction::ReducedBody &body = *model.bodies()[reference.body];
  return attached_damping_ratio(body,
                                normal.transpose() * body.points[reference.point].rows.topRows(3));
}

} // namespace

std::string attachment_damping_warning(const ContactSet &contacts, const model::Model &model,
                                       std::set<std::string> &known) {
  constexpr int most_named = 8;
  std::ostringstream text;
  double least = enough_damping;
  int count = 0;
  for (const ContactPair &pair : contacts.pairs())
    for (const std::string &side : {pair.side_a, pair.side_b}) {
      const double ratio = attached_damping_ratio(side, pair.normal, model);
      if (!(ratio < least_damping) || !known.insert(side).second)
        continue;
      least = std::min(least, ratio);
      if (++count <= most_named)
        text << (count > 1 ? ", " : "") << side;
    }
  if (count == 0)
    return "";
  if (count > most_named)
    text << " and " << count - most_named << " more";
  text
      << " have attachment modes with a damping ratio of " << least
      << ": they stand for many modes and ring like one after each impact, which brings contacts "
         "early, "
         "multiplies them and makes peak forces too large. Set Attachment damping ratio, 0.3 where "
         "nothing better is known, 0.05 at least";
  return "the points " + text.str();
}

} // namespace vibroimpact::contact
