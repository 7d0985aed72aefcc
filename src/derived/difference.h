// A field less another field or a level, along one axis.
#pragma once

#include "derived/operation.h"

#include <functional>
#include <string>

namespace vibroimpact::derived {

class Difference {
public:
  Difference(const Line &field, const Line &other) : field_(field), other_(other) {}
  double operator[](std::size_t i) const { return field_[i] - other_[i]; }

private:
  Line field_;
  Line other_;
};

/// Zero of the straight line through two points of which one may lie on zero.
double zero_between(double x_before, double before, double x_after, double after);

/// What the keys Field, Other or Level, and Along ask for.
class Compared {
public:
  explicit Compared(const Request &request);
  Compared(const Compared &) = delete;
  Compared &operator=(const Compared &) = delete;

  const Axis &axis() const { return axis_; }
  const std::string &name() const { return field_.name; }
  std::string other_name() const;
  /// Coordinates of the axis over the other dimensions of both fields; all NaN.
  DerivedArray result(const Request &request, const std::string &description) const;
  void for_each(const std::function<void(std::size_t, const Difference &)> &visit) const;

private:
  LabelledArray field_;
  double level_ = 0;
  LabelledArray other_;
  Axis axis_;
  Frame frame_;
};

} // namespace vibroimpact::derived
