#include "contact/restitution_relation.h"

#include "common/zero.h"

#include <boost/math/special_functions/log1p.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace vibroimpact::contact {

namespace {

// ln[(1 + d) / (1 - e d)] - (1 + e) d, grouped so that nothing cancels for small d. Negative next
// to the trivial root d = 0, it grows without bound as d approaches 1/e, so that the wanted root
// lies between.
double exact_mismatch(double e, double d) {
  return boost::math::log1pmx(d) - boost::math::log1pmx(-e * d);
}

// Just inside the singularity at e d = 1.
constexpr double inside = 1 - 4 * std::numeric_limits<double>::epsilon();

double exact_damping(double e) {
  if (e == 1)
    return 0;
  // Near e = 1 the root is 3/2 (1 - e) + ...; below a tenth of it the mismatch is still negative.
  const double lower = 0.1 * (1 - e);
  const double upper = inside / e;
  if (!std::isfinite(upper) || !(exact_mismatch(e, upper) > 0))
    return 1 / e; // e so small that the root and 1/e are one number, or none
  return zero_between([e](double d) { return exact_mismatch(e, d); }, lower, upper);
}

using Relation = double (*)(double);
const std::vector<std::pair<std::string, Relation>> &relations() {
  static const std::vector<std::pair<std::string, Relation>> list = {
      {"exact", exact_damping},
      {"hunt-crossley", [](double e) { return 1.5 * (1 - e); }},
      {"herbert-mcwhannell",
       [](double e) { return 6 * (1 - e) / ((2 * e - 1) * (2 * e - 1) + 3); }},
      {"lee-wang", [](double e) { return 0.75 * (1 - e); }},
      {"lankarani-nikravesh", [](double e) { return 0.75 * (1 - e * e); }},
      {"gonthier", [](double e) { return (1 - e * e) / e; }},
      {"flores", [](double e) { return 1.6 * (1 - e) / e; }},
  };
  return list;
}

} // namespace

double dimensionless_damping(const std::string &relation, double restitution_coefficient) {
  if (!(restitution_coefficient > 0) || restitution_coefficient > 1)
    throw std::invalid_argument("a restitution coefficient lies above 0 and up to 1");
  for (const auto &[name, formula] : relations())
    if (name == relation)
      return formula(restitution_coefficient);
  throw std::invalid_argument("unknown relation " + relation);
}

double exact_restitution(double dimensionless_damping) {
  const double d = dimensionless_damping;
  if (d == 0)
    return 1;
  // In e the mismatch rises from ln(1 + d) - d < 0 at 0 to beyond zero at min(1, 1/d).
  const double upper = d < 1 ? 1 : inside / d;
  if (!(exact_mismatch(upper, d) > 0))
    return upper;
  return zero_between([d](double e) { return exact_mismatch(e, d); }, 0.0, upper);
}

std::vector<std::string> restitution_relations() {
  std::vector<std::string> names;
  for (const auto &relation : relations())
    names.push_back(relation.first);
  return names;
}

} // namespace vibroimpact::contact
