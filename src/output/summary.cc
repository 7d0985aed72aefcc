#include "output/summary.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace vibroimpact::output {

namespace {

std::string along_axes(const std::string &name, const RowVector &values, const std::string &unit) {
  constexpr std::array axes = {".x", ".y", ".z"};
  std::string text;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    text += summary_line(name + axes[axis], values[static_cast<Index>(axis)], unit);
  return text;
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

std::string summary_line(const std::string &name, double value, const std::string &unit) {
  std::array<char, 40> number;
  // The sign of a NaN depends on how it came about.
  std::snprintf(number.data(), number.size(), "%.12g", std::isnan(value) ? std::abs(value) : value);
  return name + " = " + number.data() + " [" + unit + "]\n";
}

std::string body_summary(const reduction::ReducedBody &body) {
  constexpr double two_pi = 6.283185307179586476925;
  const std::string prefix = "body." + body.name + ".";
  const auto numbered = [&](const std::string &name, Index j) {
    return prefix + name + "[" + std::to_string(j + 1) + "]";
  };
  std::string text;
  for (Index j = 0; j < body.size(); ++j)
    text += summary_line(numbered("frequency", j), body.omega()[j] / two_pi, "Hz");
  for (Index j = 0; j < body.size(); ++j)
    text += summary_line(numbered("damping_ratio", j), body.damping_ratio()[j], "1");
  for (Index j = 0; j < body.size(); ++j)
    text += along_axes(numbered("effective_mass", j), body.effective_mass().row(j), "kg");
  text += along_axes(prefix + "total_mass", body.total_mass.transpose(), "kg");
  for (const reduction::BodyPoint &point : body.points)
    if (point.interface.empty() && point.static_displacement.size() > 0) {
      const std::string name = prefix + "static." + point.name + ".";
      text += along_axes(name + "displacement", point.static_displacement.head(3).transpose(), "m");
      text += along_axes(name + "rotation", point.static_displacement.tail(3).transpose(), "rad");
    }
  for (const reduction::BodyPoint &point : body.points)
    if (point.interface.empty() && point.flexibility.size() > 0) {
      RowVector share(3);
      for (int axis = 0; axis < 3; ++axis)
        share[axis] = body.flexibility_share(point, Vector3::Unit(axis));
      text += along_axes(prefix + "flexibility_share." + point.name, share, "1");
    }
  if (body.modal())
    text += summary_line(prefix + "orthogonality_residual", body.orthogonality_residual, "1");
  return text;
}

std::string contact_summary(const std::vector<contact::ContactFigures> &contacts) {
  std::string text;
  for (const contact::ContactFigures &contact : contacts) {
    const auto add = [&](const std::string &name, double value) {
      if (!std::isnan(value))
        text += summary_line("contact." + contact.name + "." + name, value, "1");
    };
    add("flexibility_share", contact.flexibility_share);
    add("impact_error", contact.impact_error);
  }
  return text;
}

std::string analysis_summary(const AnalysisHeader &header, const derived::PointSequence &points,
                             PointTotals &totals) {
  const std::string prefix = "analysis." + header.name;
  std::string text;
  const std::size_t count = point_count(header);
  const bool listed = count <= most_listed_points;
  if (!listed)
    text += summary_line(prefix + ".points", static_cast<double>(count), "1");
  points([&](const PointResult &point) {
    totals.add(point);
    if (!listed)
      return;
    const std::string point_prefix =
        point.summary.empty() ? "" : prefix + index_in_brackets(point.index) + ".";
    if (point.status == Status::finished && !point.reason.empty())
      text += "# " + prefix + index_in_brackets(point.index) + ": " + point.reason + "\n";
    for (const SummaryLine &line : point.summary) {
      const bool absolute = line.name().starts_with('/');
      text += summary_line(absolute ? line.name().substr(1) : point_prefix + line.name(),
                           line.value, line.unit());
    }
  });
  return text + totals.summary_lines(prefix);
}

} // namespace vibroimpact::output
