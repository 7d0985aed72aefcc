#include "output/point_totals.h"

#include "analyses/curves/orbit_fields.h"
#include "analyses/results/fields.h"

#include <algorithm>

namespace vibroimpact::output {

namespace {

constexpr std::size_t most_reasons = 3;

// Reasons that differ in an instant or another number are of one kind.
std::string without_numbers(const std::string &text) {
  std::string kind;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] < '0' || text[i] > '9') {
      kind += text[i++];
      continue;
    }
    i = std::min(text.find_first_not_of("0123456789.e+-", i), text.size());
    kind += '#';
  }
  return kind;
}

} // namespace

void PointTotals::add(const PointResult &point) {
  ++points_;
  unsettled_ += analyses::recorded_unsettled(point) ? 1 : 0;
  elsewhere_ += analyses::settled_elsewhere(point) ? 1 : 0;
  unbalanced_ += analyses::unbalanced(point) ? 1 : 0;
  undecided_ += analyses::undecided_events(point);
  yield_.add(point);
  has_motion_ = has_motion_ || !point.motion.empty();
  if (point.status != Status::failed)
    return;
  ++failed_;
  if (point.reason.empty())
    return;
  const std::string kind = without_numbers(point.reason);
  const auto known = std::find_if(reasons_.begin(), reasons_.end(),
                                  [&](const Reason &reason) { return reason.kind == kind; });
  if (known != reasons_.end())
    ++known->points;
  else
    reasons_.push_back({.kind = kind, .text = point.reason, .points = 1});
}

std::size_t PointTotals::listed_reasons() const { return std::min(most_reasons, reasons_.size()); }

void PointTotals::add_to(SummaryList &list, const std::string &prefix) const {
  const auto add = [&list](const std::string &name, double value, const std::string &why = "") {
    if (value > 0)
      list.add(name, value, "1", why);
  };
  add(prefix + ".failed_points", static_cast<double>(failed_));
  for (std::size_t i = 0; i < listed_reasons(); ++i)
    add(prefix + ".failed_points[" + std::to_string(i + 1) + "]",
        static_cast<double>(reasons_[i].points), reasons_[i].text);
  add(prefix + ".unsettled_points", static_cast<double>(unsettled_));
  add(prefix + ".unbalanced_points", static_cast<double>(unbalanced_));
  add(prefix + ".total_undecided_events", undecided_);
  yield_.add_to(list, prefix);
}

std::string PointTotals::failures() const {
  if (failed_ == 0)
    return "";
  std::string text = std::to_string(failed_) + " of " + std::to_string(points_) + " points failed:";
  for (std::size_t i = 0; i < listed_reasons(); ++i)
    text += "\n  " + std::to_string(reasons_[i].points) + ": " + reasons_[i].text;
  if (reasons_.size() > listed_reasons())
    text += "\n  and " + std::to_string(reasons_.size() - listed_reasons()) + " other reasons";
  return text;
}

std::string PointTotals::unsettled() const {
  if (unsettled_ == 0)
    return "";
  return std::to_string(unsettled_) + " of " + std::to_string(points_) +
         " points were recorded before their motion was judged steady (steady in results.h5)";
}

std::string PointTotals::settled_elsewhere() const {
  if (elsewhere_ == 0)
    return "";
  return std::to_string(elsewhere_) + " of " + std::to_string(points_) +
         " periodic orbits are unstable, found from a motion that had settled to another one: it "
         "repeats itself after more than Longest period, or not at all (settled_multiple in "
         "results.h5)";
}

} // namespace vibroimpact::output
