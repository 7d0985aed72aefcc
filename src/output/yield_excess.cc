#include "output/yield_excess.h"

#include <iomanip>
#include <sstream>
#include <string_view>
#include <utility>

namespace vibroimpact::output {

namespace {

constexpr std::string_view stress_field = "/von_mises_stress/maximum";

/// "beam.root" of "point/beam.root/von_mises_stress/maximum", "beam" of "body/beam/..."; empty for
/// other fields.
std::string place_of(const std::string &field) {
  for (const std::string_view kind : {"point/", "body/", "recorded/point/"})
    if (field.starts_with(kind) && field.ends_with(stress_field))
      return field.substr(kind.size(), field.size() - kind.size() - stress_field.size());
  return "";
}

} // namespace

YieldStresses read_yield_stresses(const parameters::Values &file,
                                  const std::vector<reduction::ReducedBody> &bodies) {
  YieldStresses found;
  for (const reduction::ReducedBody &body : bodies) {
    const parameters::Values material = file.instance("Body", body.name).subsection("Material");
    if (material.has("Yield stress"))
      found[body.name] = material.quantity("Yield stress");
  }
  return found;
}

YieldExcess::YieldExcess(YieldStresses yield_stresses)
    : yield_stresses_(std::move(yield_stresses)) {}

void YieldExcess::add(const PointResult &point) {
  if (yield_stresses_.empty())
    return;
  for (const Field &field : point.fields)
    if (const std::string place = place_of(field.name()); !place.empty())
      add(place, field);
}

void YieldExcess::add(const std::string &place, const Field &field) {
  const std::string body = place.substr(0, place.find('.'));
  if (!yield_stresses_.contains(body))
    return;
  Largest &largest = largest_[body];
  for (const double stress : field.values)
    if (stress > largest.stress) // not where it is no number
      largest = {.stress = stress, .place = place};
}

void YieldExcess::add_to(SummaryList &list, const std::string &prefix) const {
  for (const auto &[body, largest] : largest_)
    list.add(prefix + ".body." + body + ".yield_ratio", largest.stress / yield_stresses_.at(body),
             "1");
}

std::vector<std::string> YieldExcess::warnings() const {
  std::vector<std::string> found;
  for (const auto &[body, largest] : largest_) {
    const double ratio = largest.stress / yield_stresses_.at(body);
    if (!(ratio > 1))
      continue;
    std::ostringstream text;
    text << "body " << body << ": the von Mises stress at " << largest.place << " reaches "
         << std::setprecision(3) << ratio
         << " times the Yield stress; the body is modelled as linear elastic";
    found.push_back(text.str());
  }
  return found;
}

} // namespace vibroimpact::output
