#include "motion/moments/moment_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {
constexpr int most_view_halvings = 12;
} // namespace

MomentViews::MomentViews(Equations &equations, const MomentStep &step, double tolerance)
    : equations_(equations), step_(step), tolerance_(tolerance) {}

void MomentViews::add_forces(double x, Vector &force) const {
  const GapCurve::Coefficients polynomials = bernstein_polynomials(x);
  for (const std::size_t c : acting_) {
    const ContactCourse &course = step_.course(c);
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const int mode = equations_.modes()[c];
    if (forceless(pair.law->modes()[static_cast<std::size_t>(mode)]))
      continue;
    pair.law->evaluate(mode, course.curve().at(polynomials), response_);
    force += response_.force * pair.gap.row.transpose();
  }
}

void MomentViews::fill(double time, double x, EndPoint &point) const {
  const Index n = equations_.layout().n;
  const model::Model &model = equations_.model();
  const Vector rows = step_.rows_at(x);
  point.time = time + x * step_.length();
  point.state.head(2 * n) = rows.head(2 * n);
  point.higher.resize(2 * n, 0);
  point.sources.resize(model.sources().size());
  for (std::size_t s = 0; s < point.sources.size(); ++s) {
    const Index first = 2 * n + 3 * static_cast<Index>(s);
    point.sources[s] = {rows[first], rows[first + 1], rows[first + 2]};
  }
  Vector force, part;
  model.load(equations_.source_time(point.time), force);
  model.stiffness().apply(ConstVectorView(rows.data(), n), part);
  force -= part;
  model.damping().apply(ConstVectorView(rows.data() + n, n), part);
  force -= part;
  add_forces(x, force);
  point.rates.resize(2 * n);
  point.rates.head(n) = rows.segment(n, n);
  point.rates.tail(n) = force.cwiseQuotient(model.mass());
}

// By the quintic with position, velocity and acceleration at both ends, of position and velocity in
// the middle.
double MomentViews::missed(const EndPoint &start, const EndPoint &middle,
                           const EndPoint &end) const {
  const Index n = equations_.layout().n;
  const double h = end.time - start.time;
  const auto &a = start.state, &b = end.state;
  Vector rows = Vector::Zero(2 * n);
  rows.head(n) = (a.head(n) + b.head(n)) / 2 + 5 * h / 32 * (a.segment(n, n) - b.segment(n, n)) +
                 h * h / 64 * (start.rates.tail(n) + end.rates.tail(n)) - middle.state.head(n);
  rows.tail(n) = 15 / (8 * h) * (b.head(n) - a.head(n)) -
                 7.0 / 16 * (a.segment(n, n) + b.segment(n, n)) +
                 h / 32 * (end.rates.tail(n) - start.rates.tail(n)) - middle.state.segment(n, n);
  // Over a short part the differences of positions and of times are rounding.
  const auto size = [&](const Vector &of) {
    return std::sqrt(of.cwiseAbs2().dot(equations_.model().mass()));
  };
  const double lost = std::numeric_limits<double>::epsilon() / h *
                      (16 * size(a.head(n)) + 4 * std::abs(end.time) * size(a.segment(n, n)));
  return std::max(0.0, step_.norm(rows) - lost);
}

void MomentViews::halve(double time, double from, const EndPoint &start, double to,
                        const EndPoint &end, int depth, const Show &show) const {
  const double x = (from + to) / 2;
  EndPoint middle;
  middle.state = start.state;
  fill(time, x, middle);
  const bool shortest = !(middle.time > start.time && middle.time < end.time);
  if (depth == 0 || shortest || missed(start, middle, end) <= tolerance_ * step_.largest_norm()) {
    show(start, end);
    return;
  }
  halve(time, from, start, x, middle, depth - 1, show);
  halve(time, x, middle, to, end, depth - 1, show);
}

void MomentViews::show(double time, double from, const EndPoint &start, double to,
                       const EndPoint &end, const Show &show) const {
  halve(time, from, start, to, end, most_view_halvings, show);
}

} // namespace vibroimpact::motion
