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

double MomentViews::force(std::size_t contact, int mode, double x) const {
  const contact::ContactLaw &law = *equations_.contacts().pairs()[contact].law;
  if (contact::forceless(law.modes()[static_cast<std::size_t>(mode)]))
    return 0;
  law.evaluate(mode, step_.course(contact).curve().at(x), response_);
  return response_.force;
}

void MomentViews::pass(std::size_t contact, int from, double x, EndPoint &point) const {
  const double jump = force(contact, equations_.modes()[contact], x) - force(contact, from, x);
  if (jump != 0)
    point.rates.tail(equations_.layout().n) +=
        jump * equations_.contacts().pairs()[contact].gap.row.transpose().cwiseQuotient(
                   equations_.model().mass());
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
  for (const std::size_t c : acting_)
    if (const double push = this->force(c, equations_.modes()[c], x); push != 0)
      force += push * equations_.contacts().pairs()[c].gap.row.transpose();
  point.rates.resize(2 * n);
  point.rates.head(n) = rows.segment(n, n);
  point.rates.tail(n) = force.cwiseQuotient(model.mass());
}

MomentViews::Motion MomentViews::between(const EndPoint &start, const EndPoint &end, double tau) {
  const double h = end.time - start.time;
  const Index n = start.rates.size() / 2;
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
                                      : point.rates.tail(n);
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
