#include "contact/unknown_flexibility.h"

#include "reduction/known_flexibility.h"

#include <cmath>
#include <sstream>

namespace vibroimpact::contact {

namespace {

using reduction::ReducedBody;

/// Share of the highest coordinate that moves the point, of all that do.
double share_of_highest(const ReducedBody &body, const RowVector &row) {
  Index highest = -1;
  for (Index j = 0; j < body.size(); ++j)
    if (body.stiffness[j] > 0 && row[j] != 0 &&
        (highest < 0 || body.stiffness[j] > body.stiffness[highest]))
      highest = j;
  return highest < 0 ? 0
                     : row[highest] * row[highest] / body.stiffness[highest] /
                           reduction::kept_flexibility(body, row);
}

/// "plate.tip (1.2e-05 m/N, of which the highest mode has 3 %)"; empty where all is known.
std::string unknown_side(const std::string &name, const ContactPair &pair,
                         const model::Model &model) {
  model::PointReference reference;
  if (!model.find_point(name, reference))
    return "";
  const ReducedBody &body = *model.bodies()[reference.body];
  const reduction::BodyPoint &point = body.points[reference.point];
  if (body.type != "modes" || !std::isnan(reduction::flexibility_along(point, pair.normal)))
    return "";
  const RowVector row = pair.normal.transpose() * point.rows.topRows(3);
  std::ostringstream text;
  text.precision(3);
  text << name << " (" << reduction::kept_flexibility(body, row)
       << " m/N, of which the highest mode has " << 100 * share_of_highest(body, row) << " %)";
  return text.str();
}

} // namespace

std::string unknown_flexibility_warning(const ContactSet &contacts, const model::Model &model,
                                        std::set<std::string> &known) {
  constexpr int most_named = 8;
  std::string named;
  int count = 0;
  for (const ContactPair &pair : contacts.pairs())
    for (const std::string &side : {pair.side_a, pair.side_b})
      if (const std::string text = unknown_side(side, pair, model);
          !text.empty() && known.insert(side).second && ++count <= most_named)
        named += (named.empty() ? "" : ", ") + text;
  if (count > most_named)
    named += " and " + std::to_string(count - most_named) + " more";
  return named.empty()
             ? ""
             : "of the static flexibility where contacts touch, nothing is known but that of the "
               "given modes: " +
                   named +
                   ". What the modes left out would add is missing, so that forces of contacts "
                   "come out too large; the share of the highest mode says by how much where "
                   "contacts "
                   "are long. Those shorter than its period meet the mass of the modes left out, "
                   "of "
                   "which the file says nothing: with one to three modes that is mostly 3 to 15 % "
                   "of the "
                   "peak force. Compare with more modes, or read the results.h5 of the run that "
                   "they are "
                   "from. Set Static stiffness or Residual flexibility of these "
                   "Points, and name them in Modal data/Attachments";
}

} // namespace vibroimpact::contact
