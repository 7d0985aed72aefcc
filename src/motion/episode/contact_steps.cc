#include "motion/episode/contact_steps.h"

#include "motion/system/friction_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

ConstVectorView step_view_of(const Vector &x) { return {x.data(), x.size()}; }

} // namespace

ContactSteps::ContactSteps(const Equations &equations, double tolerance)
    : equations_(equations), inner_points_(inner_points(tolerance)) {}

// Ten steps show a contact with the restitution 0.5 to 1e-6.
int ContactSteps::inner_points(double tolerance) {
  constexpr double of_nine = 1e-6;
  return std::clamp(static_cast<int>(std::lround(9 * std::pow(of_nine / tolerance, 0.125))), 7, 25);
}

// State, rates, and the third derivative of the coordinates. With x' = S x + b f and rows y = C x:
// q''' = C S^2 x + C S b f + C b f' in the rows of the velocities.
void ContactSteps::fill(const PhaseEpisode &contact, double time, const double *amplitudes,
                        EndPoint &point) {
  const ExactPhase &phase = contact.linear().phase();
  const StateLayout &layout = equations_.layout();
  const Index n = layout.n;
  const Index size = layout.physical_size();
  const Index n_sources = (phase.columns().rows() - size) / 3;
  const ConstVectorView x(amplitudes, static_cast<Index>(phase.n_amplitudes()));
  point.time = time;
  point.state.head(size).noalias() = contact.state_rows() * x;
  point.rates.resize(layout.size());
  equations_.rates(time, step_view_of(point.state), VectorView(point.rates.data(), layout.size()));
  equations_.source_values(time, point.sources);
  rows_.noalias() = contact.bent_rows() * x;
  for (Index k = 0; k < n_sources; ++k)
    point.sources[static_cast<std::size_t>(k)][3] = rows_[size + 3 * k + 1];
  point.higher.setZero(size, 1);
  add_contact_rates(equations_, contact.contact(), response_, point);
  point.higher.col(0).segment(n, n).array() /= equations_.model().mass().array();
  point.higher.col(0) += rows_.head(size);
  add_bent_force(contact, point);
  point.higher.col(0).head(n) = point.rates.segment(n, n);
}

// C S b f, the law having been evaluated.
void ContactSteps::add_bent_force(const PhaseEpisode &contact, EndPoint &point) const {
  const contact::ContactPair &pair = contact.pair();
  if (!pair.circle) {
    point.higher.col(0) += response_.force * contact.bent_load();
    return;
  }
  const contact::AcrossAxis force = pair.circle->force(
      equations_.frame(contact.contact(), point.time, step_view_of(point.state)), response_);
  for (int d = 0; d < 2; ++d)
    point.higher.col(0) += force[static_cast<std::size_t>(d)] * contact.bent_load(d);
}

void ContactSteps::find_points(const PhaseEpisode &contact, double time, const Vector &state) {
  const ContactEpisode &solved = contact.solution();
  ShownPoints &shown = solved.tools().shown(inner_points_);
  const auto count = static_cast<std::size_t>(shown.rule.nodes.size());
  const std::vector<double> moments = solved.moments(shown.between);
  points_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t =
        static_cast<double>(shown.rule.nodes[static_cast<Index>(i)]) * contact.duration();
    const double *amplitudes = amplitudes_.data();
    if (i == 0) {
      amplitudes = contact.before().data();
    } else if (i + 1 == count) {
      amplitudes = contact.after().data();
    } else {
      amplitudes_.resize(contact.before().size());
      kernel().turn(contact.linear().phase().view(), contact.before().data(), t,
                    amplitudes_.data());
      contact.add_force(moments, shown.between.n_targets(), static_cast<int>(i) - 1,
                        amplitudes_.data());
      amplitudes = amplitudes_.data();
    }
    points_[i].state = state;
    fill(contact, time + t, amplitudes, points_[i]);
  }
}

// Positions are sums of amplitudes, whose rounding shows in second derivatives over steps as short
// as those next to the ends. Where a position is what the velocities make of its neighbour (the
// integral of their polynomial of degree 5) within that rounding, it is set to it.
void ContactSteps::smooth_position(const EndPoint &neighbour, EndPoint &point) const {
  constexpr double rounding = 1024 * std::numeric_limits<double>::epsilon();
  const Index n = equations_.layout().n;
  const double h = point.time - neighbour.time;
  for (Index j = 0; j < n; ++j) {
    const double by_rates = neighbour.state[j] +
                            0.5 * h * (neighbour.state[n + j] + point.state[n + j]) +
                            h * h / 10 * (neighbour.rates[n + j] - point.rates[n + j]) +
                            h * h * h / 120 * (neighbour.higher(n + j, 0) + point.higher(n + j, 0));
    if (std::abs(by_rates - point.state[j]) <= rounding * std::abs(point.state[j]))
      point.state[j] = by_rates;
  }
}

// From both ends to the middle.
void ContactSteps::smooth_positions() {
  const std::size_t last = points_.size() - 1;
  for (std::size_t i = 1; 2 * i < last; ++i) {
    smooth_position(points_[i - 1], points_[i]);
    smooth_position(points_[last - i + 1], points_[last - i]);
  }
}

// Between the ends the integrals grow by the trapezoidal rule, which only those see who look into a
// contact; the sum at the end is that of the work.
void ContactSteps::set_integrals(double time, const Vector &state, ContactWork *work) {
  const Index count = equations_.layout().size() - equations_.layout().integrals();
  for (std::size_t i = 1; i < points_.size(); ++i)
    points_[i].state.tail(count) =
        points_[i - 1].state.tail(count) +
        0.5 * (points_[i].time - points_[i - 1].time) *
            (points_[i - 1].rates.tail(count) + points_[i].rates.tail(count));
  if (!work)
    return;
  Vector whole = state;
  work->add(time, whole);
  points_.back().state.tail(count) = whole.tail(count);
}

int ContactSteps::show(const PhaseEpisode &contact, double time, ContactWork *work, Vector &state,
                       const Audience &audience) {
  find_points(contact, time, state);
  smooth_positions();
  set_integrals(time, state, work);
  for (std::size_t i = 1; i < points_.size(); ++i)
    audience.show(StepView(equations_, points_[i - 1], points_[i]));
  state = points_.back().state;
  return static_cast<int>(points_.size()) - 1;
}

} // namespace vibroimpact::motion
