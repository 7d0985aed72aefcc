#include "output/summary.h"

#include "reduction/known_flexibility.h"

#include <array>
#include <cmath>
#include <limits>

namespace vibroimpact::output {

namespace {

/// NaN stands for what is not known.
void add_along_axes(SummaryList &list, const std::string &name, const RowVector &values,
                    const std::string &unit) {
  constexpr std::array axes = {".x", ".y", ".z"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (const double value = values[static_cast<Index>(axis)]; !std::isnan(value))
      list.add(name + axes[axis], value, unit);
}

std::size_t point_count(const AnalysisHeader &header) {
  std::size_t count = 1;
  for (const Axis &axis : header.axes)
    count *= axis.size();
  return count;
}

std::string index_in_brackets(const std::vector<std::size_t> &index) {
  std::string text;
  for (const std::size_t position : index)
    text.append(text.empty() ? "[" : ",").append(std::to_string(position + 1));
  return text.empty() ? text : text + "]";
}

} // namespace

SummaryList body_summary(const reduction::ReducedBody &body) {
  constexpr double two_pi = 6.283185307179586476925;
  const std::string prefix = "body." + body.name + ".";
  const auto numbered = [&](const std::string &name, Index j) {
    return prefix + name + "[" + std::to_string(j + 1) + "]";
  };
  SummaryList list;
  for (Index j = 0; j < body.size(); ++j)
    list.add(numbered("frequency", j), body.omega()[j] / two_pi, "Hz");
  for (Index j = 0; j < body.size(); ++j)
    list.add(numbered("damping_ratio", j), body.damping_ratio()[j], "1");
  for (Index j = 0; j < body.size(); ++j)
    add_along_axes(list, numbered("effective_mass", j), body.effective_mass().row(j), "kg");
  add_along_axes(list, prefix + "total_mass", body.total_mass.transpose(), "kg");
  for (const reduction::BodyPoint &point : body.points)
    if (point.interface.empty() && point.static_displacement.size() > 0) {
      const std::string name = prefix + "static." + point.name + ".";
      add_along_axes(list, name + "displacement", point.static_displacement.head(3).transpose(),
                     "m");
      add_along_axes(list, name + "rotation", point.static_displacement.tail(3).transpose(), "rad");
    }
  for (const reduction::BodyPoint &point : body.points)
    if (point.interface.empty() && point.flexibility.size() > 0) {
      RowVector share(3);
      for (int axis = 0; axis < 3; ++axis)
        share[axis] = std::isnan(reduction::flexibility_along(point, Vector3::Unit(axis)))
                          ? std::numeric_limits<double>::quiet_NaN()
                          : body.flexibility_share(point, Vector3::Unit(axis));
      add_along_axes(list, prefix + "flexibility_share." + point.name, share, "1");
    }
  if (body.modal())
    list.add(prefix + "orthogonality_residual", body.orthogonality_residual, "1");
  return list;
}

SummaryList contact_summary(const std::vector<contact::ContactFigures> &contacts) {
  SummaryList list;
  for (const contact::ContactFigures &contact : contacts) {
    const auto add = [&](const std::string &name, double value) {
      if (!std::isnan(value))
        list.add("contact." + contact.name + "." + name, value, "1");
    };
    add("flexibility_share", contact.flexibility_share);
    add("impact_error", contact.impact_error);
    if (!contact.no_impact_error.empty())
      list.add_note("contact." + contact.name + ".impact_error",
                    "not known: " + contact.no_impact_error);
  }
  return list;
}

namespace {

void add_numbers(SummaryList &list, const PointResult &point, const std::string &prefix) {
  for (const SummaryLine &line : point.summary) {
    const bool absolute = line.name().starts_with('/');
    list.add(absolute ? line.name().substr(1) : prefix + line.name(), line.value, line.unit());
  }
}

} // namespace

SummaryList analysis_summary(const AnalysisHeader &header, const derived::PointSequence &points,
                             PointTotals &totals) {
  const std::string prefix = "analysis." + header.name;
  SummaryList words, all; // of the points
  std::size_t with_words = 0, with_numbers = 0;
  points([&](const PointResult &point) {
    totals.add(point);
    const std::string name = prefix + index_in_brackets(point.index);
    // Of points without numbers the totals give the reasons.
    if (!point.reason.empty() && (point.status == Status::finished || !point.summary.empty()) &&
        ++with_words <= most_listed_points)
      for (SummaryList *list : {&words, &all})
        list->add_note(name, point.reason);
    if (!point.summary.empty() && ++with_numbers <= most_listed_points)
      add_numbers(all, point, name + ".");
  });
  const bool listed = with_numbers <= most_listed_points;
  SummaryList list;
  if (!listed)
    list.add(prefix + ".points", static_cast<double>(point_count(header)), "1");
  list.append(listed ? all : words);
  totals.add_to(list, prefix);
  return list;
}

} // namespace vibroimpact::output
