// A force over a length as a line through points, continued straight beyond the last one.
#pragma once

#include <cstddef>
#include <vector>

namespace vibroimpact::contact {

class ForceCurve {
public:
  /// At least two points with increasing lengths [m]; forces [N].
  ForceCurve(std::vector<double> lengths, std::vector<double> forces);

  std::size_t n_segments() const { return lengths_.size() - 1; }
  const std::vector<double> &lengths() const { return lengths_; }
  const std::vector<double> &forces() const { return forces_; }
  double slope(std::size_t segment) const; ///< [N/m]
  /// Of the straight line that a segment lies on: its value at length zero [N].
  double intercept(std::size_t segment) const;
  /// Segment of a length; the first and the last one reach to infinity.
  std::size_t segment(double length) const;
  double operator()(double length) const; ///< [N]
  /// Integral from the first point on, up to a length on a segment [J].
  double area(double length, std::size_t segment) const;
  double area(double length) const { return area(length, segment(length)); }

private:
  std::vector<double> lengths_, forces_;
  std::vector<double> areas_; ///< up to each point [J]
};

} // namespace vibroimpact::contact
