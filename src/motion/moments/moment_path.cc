#include "motion/moments/moment_path.h"

#include "common/error.h"
#include "common/signals.h"
#include "motion/episode/gauss_jacobi.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

constexpr int rungs_per_octave = 4;
constexpr std::size_t most_tables = 48;
/// Rungs that a step may lose at once.
constexpr int most_rungs_down = 8;

} // namespace

MomentPath::MomentPath(Equations &equations, ExactPhases &phases, const Settings &settings,
                       Accuracy &counts)
    : equations_(equations), phases_(phases), counts_(counts),
      step_(equations, settings.relative_tolerance),
      views_(equations, step_, settings.relative_tolerance), ranges_(equations, step_),
      unit_(equations.model().highest_frequency() > 0 ? 1 / equations.model().highest_frequency()
                                                      : 1),
      event_tolerance_(settings.event_tolerance),
      longest_(settings.maximum_step > 0 ? settings.maximum_step
                                         : std::numeric_limits<double>::infinity()) {}

void MomentPath::begin() {
  running_ = false;
  rung_ = 0;
  step_.begin();
}

double MomentPath::length_of(int rung) const {
  return unit_ * std::exp2(static_cast<double>(rung) / rungs_per_octave);
}

const MomentTables &MomentPath::tables_of(int rung) {
  const auto known = tables_.find(rung);
  if (known != tables_.end())
    return known->second;
  if (tables_.size() >= most_tables)
    tables_.clear();
  return tables_.emplace(rung, step_.tables(length_of(rung))).first->second;
}

bool MomentPath::start(double time, const Vector &state) {
  if (!phases_.take_sources(time))
    return false;
  if (step_.take(phases_.excitation()))
    tables_.clear();
  step_.start(state, phases_.excitation(), time, equations_.modes(), event_tolerance_);
  return running_ = true;
}

// With the rung of the next attempt. False: no shorter step is possible.
bool MomentPath::refuse(std::optional<double> error, double h) {
  ++counts_.rejected_steps;
  const int rung = static_cast<int>(std::floor(rungs_per_octave * std::log2(h / unit_)));
  const int down = error ? std::clamp(static_cast<int>(std::ceil(rungs_per_octave *
                                                                 std::log2(*error) / n_moments)),
                                      1, most_rungs_down)
                         : rungs_per_octave;
  rung_ = std::min(rung_, rung) - down;
  constexpr double shortest = 1e-9; // of the shortest time scale
  return length_of(rung_) > shortest * unit_;
}

bool MomentPath::advance(double &time, const Vector &state, double limit, const Report *report) {
  state_ = state;
  if (!running_ && !start(time, state))
    return false;
  const double from = time;
  while (time < limit) {
    leave_if_stopped();
    const double most = std::min(limit - time, longest_);
    const bool on_ladder = length_of(rung_) < most;
    const double h = on_ladder ? length_of(rung_) : most;
    const std::optional<double> error =
        on_ladder ? step_.attempt(h, tables_of(rung_)) : step_.attempt(h, step_.tables(h));
    if (!error || *error > 1) {
      if (refuse(error, h))
        continue;
      running_ = false;
      rung_ = 0;
      break;
    }
    accept(time, *error, on_ladder, report);
    time = h == limit - time ? limit : time + h;
    step_.go_on(phases_.excitation(), time);
  }
  if (!state_.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
  return time > from;
}

void MomentPath::accept(double time, double error, bool on_ladder, const Report *report) {
  ++counts_.steps;
  ++counts_.moment_steps;
  list_changes(report != nullptr);
  if (!report)
    skip_changes();
  else if (ranges_.ask(report->observers) && step_.resolved())
    show_whole(time, *report);
  else
    show(time, *report);
  const Index n = equations_.layout().n;
  state_.head(2 * n) = step_.rows_at_end().head(2 * n);
  if (on_ladder && error < std::exp2(-(n_moments + 1.0) / rungs_per_octave))
    ++rung_;
}

void MomentPath::list_changes(bool observed) {
  changes_.clear();
  for (const std::size_t c : step_.listed()) {
    const auto &stretches = step_.course(c).stretches();
    for (std::size_t s = 0; s + 1 < stretches.size(); ++s)
      changes_.push_back({.x = stretches[s].to, .contact = c, .stretch = s});
  }
  if (observed)
    correct_changes();
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change &a, const Change &b) { return a.x < b.x; });
}

void MomentPath::skip_changes() {
  for (const Change &change : changes_)
    equations_.set_mode(change.contact, step_.course(change.contact).last_mode());
  counts_.events += static_cast<long>(changes_.size());
  for (const std::size_t c : step_.listed())
    step_.set_internal(c, step_.course(c).stretches().back(), 1,
                       state_.data() + equations_.layout().internal());
}

// Of a direction by moving bases and surfaces [m/s].
double MomentPath::base_rate(Index row, double time) const {
  const ContactRows &rows = step_.contact_rows();
  double rate = rows.speeds[row];
  for (Index s = 0; s < rows.base.cols(); ++s)
    if (rows.base(row, s) != 0)
      rate += rows.base(row, s) *
              equations_.model().sources()[static_cast<std::size_t>(s)].function->rate(
                  equations_.source_time(time));
  return rate;
}

// Impulse and works of a contact over a stretch of its course.
void MomentPath::add_integrals(double time, std::size_t contact, const CourseStretch &stretch) {
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  const StateLayout &layout = equations_.layout();
  const auto place = static_cast<Index>(contact);
  const double h = step_.length();
  const auto carried = [&](std::size_t direction, double x) {
    return base_rate(step_.contact_rows().first(contact) + static_cast<Index>(direction),
                     time + h * x);
  };
  const ForceIntegrals integrals =
      step_.course(contact).integrals(*pair.law, stretch, carried, response_);
  state_[layout.impulse(place)] += h * integrals.force;
  state_[layout.contact_work(place)] += h * integrals.dissipated;
  state_[layout.input_work()] -= h * integrals.carried;
  state_[layout.absolute_input_work()] += h * std::abs(integrals.carried);
  if (pair.sliding_place < 0)
    return;
  state_[layout.friction_work(pair.sliding_place)] += h * integrals.friction;
  state_[layout.wear_work(pair.sliding_place)] += h * integrals.wear;
  state_[layout.sliding_way(pair.sliding_place)] += h * integrals.sliding;
}

// Work of loads, circulatory forces and damping over a time, by a Gauss rule that integrates the
// square of the velocity and its product with the position exactly; both at a part of it are
// polynomials of degree 6 and 7 at most.
void MomentPath::add_power(double start, double end,
                           const std::function<MomentViews::Motion(double)> &motion) {
  static const GaussRule rule = JacobiPolynomials(0, 0, 7).rule();
  const StateLayout &layout = equations_.layout();
  const double h = end - start;
  Vector load, damping;
  for (Index i = 0; i < rule.nodes.size(); ++i) {
    const auto x = static_cast<double>(rule.nodes[i]);
    const double weight = h * static_cast<double>(rule.weights[i]);
    const auto [q, v] = motion(x);
    equations_.model().load(equations_.source_time(start + h * x), load);
    equations_.model().damping().apply(ConstVectorView(v.data(), v.size()), damping);
    const double power =
        load.dot(v) + equations_.model().circulatory_power(ConstVectorView(q.data(), q.size()),
                                                           ConstVectorView(v.data(), v.size()));
    state_[layout.input_work()] += weight * power;
    state_[layout.absolute_input_work()] += weight * std::abs(power);
    state_[layout.damping_work()] += weight * damping.dot(v);
  }
}

// From the zero of the polynomial to where the guard falls by the motion itself, whose gap the
// polynomial misses by kinks within the step: a Newton step, unless it is no small part of the
// stretches on both sides.
void MomentPath::correct(Change &change) const {
  constexpr double small = 0.1;
  const ContactCourse &course = step_.course(change.contact);
  const CourseStretch &before = course.stretches()[change.stretch];
  const CourseStretch &after = course.stretches()[change.stretch + 1];
  const contact::AffineForm &form = guard_of(change).indicator;
  change.slope = course.form(form, before).derivative()(change.x);
  contact::LocalState local = step_.contact_rows().local(change.contact, step_.rows_at(change.x));
  local.internal = course.at(before, change.x).internal;
  const double missed = -form(local) / change.slope;
  if (std::abs(missed) < small * std::min(before.to - before.from, after.to - after.from))
    change.x += missed;
}

void MomentPath::correct_changes() {
  step_.sum_lacks();
  for (Change &change : changes_)
    correct(change);
  for (const Change &change : changes_)
    step_.move_change(change.contact, change.stretch, change.x);
  step_.sum_lacks();
}

const contact::Guard &MomentPath::guard_of(const Change &change) const {
  const CourseStretch &stretch = step_.course(change.contact).stretches()[change.stretch];
  const auto &modes = equations_.contacts().pairs()[change.contact].law->modes();
  return modes[static_cast<std::size_t>(stretch.mode)].guards[*stretch.guard];
}

// In the state just before it.
void MomentPath::note_residual(double time, const Change &change) {
  const contact::LocalState local =
      equations_.local_state(change.contact, time, ConstVectorView(state_.data(), state_.size()));
  if (change.slope != 0)
    counts_.event_residual =
        std::max(counts_.event_residual,
                 std::abs(guard_of(change).indicator(local) / change.slope) * step_.length());
}

// The mode itself changes in the report.
void MomentPath::pass(double time, const Change &change, const Report &report) {
  const CourseStretch &stretch = step_.course(change.contact).stretches()[change.stretch];
  note_residual(time + change.x * step_.length(), change);
  if (report.integrals)
    add_integrals(time, change.contact, stretch);
  report.change(time + change.x * step_.length(), change.contact, *stretch.guard, state_);
}

void MomentPath::show(double time, const Report &report) {
  start_point_.state = state_;
  double from = 0;
  views_.begin();
  views_.fill(time, from, start_point_);
  for (std::size_t next = 0; next <= changes_.size(); ++next) {
    const double to = next < changes_.size() ? changes_[next].x : 1;
    if (time + to * step_.length() > start_point_.time) {
      end_point_.state = state_;
      views_.fill(time, to, end_point_);
      views_.show(
          time, from, start_point_, to, end_point_, [&](const EndPoint &a, const EndPoint &b) {
            if (report.integrals)
              add_power(a.time, b.time, [&](double tau) { return views_.between(a, b, tau); });
            report.show(StepView(equations_, a, b));
          });
      state_.head(end_point_.rates.size()) = end_point_.state.head(end_point_.rates.size());
    } else {
      end_point_ = start_point_;
    }
    from = to;
    if (next == changes_.size())
      break;
    const Change &change = changes_[next];
    pass(time, change, report);
    start_point_ = end_point_;
    start_point_.state = state_;
    views_.pass(change.contact, to, start_point_);
  }
  if (report.integrals)
    for (const std::size_t c : step_.acting())
      add_integrals(time, c, step_.course(c).stretches().back());
}

// Over the whole step.
void MomentPath::add_power(double time) {
  const Index n = equations_.layout().n;
  std::vector<DirectionCurve> curves;
  for (Index j = 0; j < n; ++j)
    curves.push_back(step_.coordinate(j));
  add_power(time, time + step_.length(), [&](double x) {
    MomentViews::Motion motion{.position = Vector(n), .velocity = Vector(n)};
    for (Index j = 0; j < n; ++j) {
      motion.position[j] = curves[static_cast<std::size_t>(j)].position(x);
      motion.velocity[j] = curves[static_cast<std::size_t>(j)].rate(x);
    }
    return motion;
  });
}

// From where the last one has ended.
void MomentPath::show_part(double end, const Report &report) {
  if (!(end > start_point_.time))
    return;
  const Interval part(equations_, start_point_.time, start_point_.state, end, state_);
  for (Observer *observer : report.observers)
    observer->interval(part);
  start_point_.time = end;
}

// As parts between contact changes, with the extreme values by the step's own polynomials. The
// power, and the forces that last to the end, are integrated over the step as a whole.
void MomentPath::show_whole(double time, const Report &report) {
  const StateLayout &layout = equations_.layout();
  start_point_.state = state_;
  start_point_.time = time;
  for (const Change &change : changes_) {
    const CourseStretch &stretch = step_.course(change.contact).stretches()[change.stretch];
    state_.head(2 * layout.n) = step_.rows_at(change.x).head(2 * layout.n);
    step_.set_internal(change.contact, stretch, change.x, state_.data() + layout.internal());
    if (change.stretch > 0)
      ranges_.ask(report.observers);
    ranges_.include(change.contact, stretch);
    show_part(time + change.x * step_.length(), report);
    pass(time, change, report);
    start_point_.state = state_;
  }
  state_.head(2 * layout.n) = step_.rows_at_end().head(2 * layout.n);
  for (const std::size_t c : step_.listed())
    step_.set_internal(c, step_.course(c).stretches().back(), 1, state_.data() + layout.internal());
  if (report.integrals) {
    for (const std::size_t c : step_.acting())
      add_integrals(time, c, step_.course(c).stretches().back());
    add_power(time);
  }
  ranges_.ask(report.observers);
  ranges_.include_ends();
  show_part(time + step_.length(), report);
}

} // namespace vibroimpact::motion
