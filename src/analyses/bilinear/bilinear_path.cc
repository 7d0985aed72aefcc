// Where a bilinear motion is at any instant, and its extreme values.
#include "analyses/bilinear/bilinear_motion.h"

#include "common/decompositions.h"
#include "common/scalar.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

constexpr double same_step = 1e-13; // [rad]
constexpr int least_steps = 16;     // of an interval
constexpr int most_corrections = 8;

/// Angle since the contact closed, in [0, 2 pi).
double since_closing(const BilinearMotion &motion, double angle) {
  const double since = std::fmod(angle - motion.closing_phase, full_turn);
  return since < 0 ? since + full_turn : since;
}

/// exp(A h) for one h after the other, of which many are equal.
class Propagator {
public:
  explicit Propagator(const Matrix &generator) : generator_(generator) {}
  const Matrix &operator()(double h) {
    if (step_.size() == 0 || std::abs(h - length_) > same_step) {
      step_ = exponential(generator_ * h);
      length_ = h;
    }
    return step_;
  }

private:
  const Matrix &generator_;
  Matrix step_;
  double length_ = 0;
};

/// Where the rate of a form is zero within [0, h] from y on, as it changes its sign there: Newton's
/// method from the secant, kept inside.
double zero_of_rate(const Matrix &generator, const RowVector &rate, const Vector &y, double h,
                    double first, double last) {
  double t = h * first / (first - last);
  for (int k = 0; k < most_corrections; ++k) {
    const Vector there = exponential(generator * t) * y;
    const double step = rate.dot(there) / (rate * generator).dot(there);
    const double next = std::clamp(t - step, 0.0, h);
    const bool done = !(std::abs(next - t) > 1e-14 * h);
    t = std::isfinite(next) ? next : t;
    if (done)
      break;
  }
  return t;
}

void include(FormRange &range, double value) {
  range.minimum = std::min(range.minimum, value);
  range.maximum = std::max(range.maximum, value);
}

Matrix stacked(const std::vector<RowVector> &forms, Index size) {
  Matrix rows(static_cast<Index>(forms.size()), size);
  for (std::size_t k = 0; k < forms.size(); ++k)
    rows.row(static_cast<Index>(k)) = forms[k];
  return rows;
}

} // namespace

bool is_closed(const BilinearMotion &motion, double angle) {
  return since_closing(motion, angle) < motion.contact_angle;
}

Matrix states_of(const TiedSystem &system, const BilinearMotion &motion, const Vector &angles) {
  std::vector<Index> order(static_cast<std::size_t>(angles.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return since_closing(motion, angles[a]) < since_closing(motion, angles[b]);
  });
  Propagator open(system.open()), closed(system.closed());
  Matrix states(system.size(), angles.size());
  Vector y = motion.closed_start, in_open = motion.open_start;
  double at = 0, open_at = motion.contact_angle;
  for (const Index k : order) {
    const double since = since_closing(motion, angles[k]);
    if (since < motion.contact_angle) {
      y = closed(since - at) * y;
      at = since;
      states.col(k) = y;
    } else {
      in_open = open(since - open_at) * in_open;
      open_at = since;
      states.col(k) = in_open;
    }
  }
  return states;
}

std::vector<FormRange> ranges(const TiedSystem &system, const BilinearMotion &motion,
                              const std::vector<RowVector> &forms, bool closed,
                              std::size_t samples) {
  std::vector<FormRange> found(forms.size(), {.minimum = infinity, .maximum = -infinity});
  const double length = closed ? motion.contact_angle : full_turn - motion.contact_angle;
  if (!(length > 0))
    return found;
  const Matrix &generator = closed ? system.closed() : system.open();
  const int steps =
      std::max(least_steps, static_cast<int>(std::ceil(length / full_turn * double(samples))));
  const double h = length / steps;
  const Matrix step = exponential(generator * h), values = stacked(forms, system.size());
  const Matrix rates = values * generator;
  Vector y = closed ? motion.closed_start : motion.open_start;
  for (int i = 0; i <= steps; ++i) {
    const Vector next = step * y, here = values * y, rate = rates * y, after = rates * next;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      const auto row = static_cast<Index>(k);
      include(found[k], here[row]);
      if (i == steps || !(rate[row] * after[row] < 0))
        continue;
      const double t = zero_of_rate(generator, rates.row(row), y, h, rate[row], after[row]);
      include(found[k], values.row(row).dot(exponential(generator * t) * y));
    }
    y = next;
  }
  return found;
}

} // namespace vibroimpact::analyses
