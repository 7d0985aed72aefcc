#include "motion/moments/moment_views.h"

#include "contact/free_mode.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {
constexpr int most_view_halvings = 12;
} // namespace

MomentViews::MomentViews(Equations &equations, const MomentStep &step, double tolerance)
    : equations_(equations), step_(step), tolerance_(tolerance) {}

void MomentViews::begin() {
  acting_ = step_.acting();
  stretches_.assign(equations_.contacts().size(), 0);
}

// Forces, and rates of internal states.
void MomentViews::add(std::size_t contact, std::size_t stretch, double x, double factor,
                      Vector &rates) const {
  const CourseStretch &of = step_.course(contact).stretches()[stretch];
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  if (contact::forceless(pair.law->modes()[static_cast<std::size_t>(of.mode)]))
    return;
  const StateLayout &layout = equations_.layout();
  pair.law->evaluate(of.mode, step_.course(contact).at(of, x), response_);
  for (int d = 0; d < pair.n_directions(); ++d)
    rates.segment(layout.velocity(), layout.n) +=
        factor * component_force(response_, static_cast<std::size_t>(d)) *
        pair.along(d).projection->row.transpose().cwiseQuotient(equations_.model().mass());
  for (int i = 0; i < pair.n_internal(); ++i)
    rates[layout.internal() + pair.internal_offset + i] +=
        factor * response_.internal_rate[static_cast<std::size_t>(i)];
}

void MomentViews::pass(std::size_t contact, double x, EndPoint &point) {
  std::size_t &stretch = stretches_[contact];
  add(contact, stretch, x, -1, point.rates);
  add(contact, ++stretch, x, 1, point.rates);
}

void MomentViews::fill(double time, double x, EndPoint &point) const {
  const StateLayout &layout = equations_.layout();
  const Index n = layout.n;
  const model::Model &model = equations_.model();
  const Vector rows = step_.rows_at(x);
  point.time = time + x * step_.length();
  point.state.head(2 * n) = rows.head(2 * n);
  point.higher.resize(layout.physical_size(), 0);
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
  point.rates.setZero(layout.physical_size());
  point.rates.head(n) = rows.segment(n, n);
  point.rates.segment(n, n) = force.cwiseQuotient(model.mass());
  for (const std::size_t c : acting_) {
    step_.set_internal(c, step_.course(c).stretches()[stretches_[c]], x,
                       point.state.data() + layout.internal());
    add(c, stretches_[c], x, 1, point.rates);
  }
}

MomentViews::Motion MomentViews::between(const EndPoint &start, const EndPoint &end,
                                         double tau) const {
  const double h = end.time - start.time;
  const Index n = equations_.layout().n;
  Motion motion{.position = Vector::Zero(n), .velocity = Vector::Zero(n)};
  for (const bool at_end : {false, true})
    for (std::size_t order = 0; order < 3; ++order) {
      std::array<double, 3> unit{};
      unit[order] = 1;
      const std::array<double, 3> none{};
      const Bernstein share =
          at_end ? Bernstein::quintic(h, none, unit) : Bernstein::quintic(h, unit, none);
      const EndPoint &point = at_end ? end : start;
      const auto value = order == 0   ? point.state.head(n)
                         : order == 1 ? point.state.segment(n, n)
                                      : point.rates.segment(n, n);
      motion.position += share(tau) * value;
      motion.velocity += share.derivative()(tau) / h * value;
    }
  return motion;
}

// In the middle, in the energy norm.
double MomentViews::missed(const EndPoint &start, const EndPoint &middle,
                           const EndPoint &end) const {
  const Index n = equations_.layout().n;
  const double h = end.time - start.time;
  const auto &a = start.state;
  const Motion seen = between(start, end, 0.5);
  Vector rows(2 * n);
  rows << seen.position, seen.velocity;
  rows -= middle.state.head(2 * n);
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
