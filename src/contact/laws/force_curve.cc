#include "contact/laws/force_curve.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vibroimpact::contact {

ForceCurve::ForceCurve(std::vector<double> lengths, std::vector<double> forces)
    : lengths_(std::move(lengths)), forces_(std::move(forces)), areas_(lengths_.size(), 0.0) {
  if (lengths_.size() < 2 || lengths_.size() != forces_.size())
    throw std::invalid_argument("a curve has two points or more, each with a force");
  for (std::size_t i = 1; i < lengths_.size(); ++i)
    areas_[i] =
        areas_[i - 1] + 0.5 * (forces_[i] + forces_[i - 1]) * (lengths_[i] - lengths_[i - 1]);
}

double ForceCurve::slope(std::size_t segment) const {
  return (forces_[segment + 1] - forces_[segment]) / (lengths_[segment + 1] - lengths_[segment]);
}

double ForceCurve::intercept(std::size_t segment) const {
  return forces_[segment] - slope(segment) * lengths_[segment];
}

std::size_t ForceCurve::segment(double length) const {
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
  return static_cast<std::size_t>(above - lengths_.begin()) - 1;
}

double ForceCurve::operator()(double length) const {
  const std::size_t s = segment(length);
  return forces_[s] + slope(s) * (length - lengths_[s]);
}

double ForceCurve::area(double length, std::size_t segment) const {
  const double way = length - lengths_[segment];
  return areas_[segment] + (forces_[segment] + 0.5 * slope(segment) * way) * way;
}

} // namespace vibroimpact::contact
