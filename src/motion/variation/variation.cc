#include "motion/variation/variation.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "contact/free_mode.h"
#include "motion/path/trajectory.h"
#include "motion/variation/contact_deviations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace vibroimpact::motion {

namespace {

// Of two delays at one instant, relative to the larger: below, deviating motions have both events
// at one instant too.
constexpr double equal_delays = 1e-6;

// Of what is left of a column beside those before it: below, it is the rounding of the column.
constexpr double dependent_column = 1e-14;

// Beside the part before it. The state between two parts has the error of the motion's steps, and
// before the end of a contact whose slope is infinite there this counts relative to the gap, which
// goes with the time that is left: with a thousandth of the part before, 1e-5 of a multiplier.
constexpr double short_part = 0.1;
// Steps of the motion.
constexpr int most_joined = 16;
// Of the fastest mode [rad]: over longer parts contacts observe all modes (observable_columns.h).
constexpr double longest_turn = 1;
// Of contacts that may pass as a whole.
constexpr int most_joined_in_contact = 64;
constexpr double longest_turn_in_contact = 8;

bool same_instant(double one, double other) {
  return std::abs(one - other) <= 8 * std::numeric_limits<double>::epsilon() * std::abs(other);
}

} // namespace

double Determinant::value() const { return sign * std::exp(logarithm); }

Variation::Variation(const Trajectory &trajectory, Vector scale, double tolerance,
                     std::vector<KeyTangent *> keys)
    : equations_(trajectory.equations()), accuracy_{.scale = std::move(scale),
                                                    .tolerance = tolerance},
      saltations_(equations_, keys_, accuracy_.scale), phases_(equations_, Settings()) {
  if (accuracy_.scale.size() != equations_.layout().physical_size())
    throw std::logic_error("a variation needs one scale for each physical state");
  begin(trajectory, std::move(keys));
}

void Variation::begin(const Trajectory &trajectory, std::vector<KeyTangent *> keys) {
  keys_ = std::move(keys);
  start_ = trajectory.time();
  const Equations &motion = trajectory.equations();
  for (const contact::ContactPair &pair : motion.contacts().pairs())
    if (pair.circle && pair.law->rigid())
      throw NumericalError("contact " + pair.name +
                           " has rigid sides in a circular gap: motions with it have no known "
                           "derivative");
  for (std::size_t c = 0; c < motion.modes().size(); ++c)
    equations_.set_mode(c, motion.modes()[c]);
  equations_.set_source_break(motion.source_break());
  for (KeyTangent *key : keys_)
    key->enter(start_, motion.source_break());
  closed_forms_ = !keys_.empty() && keys_keep_linear() && phases_.take_sources(start_);
  projection_ = start_projection(equations_, keys_, start_, trajectory.state());
  columns_ = projection_.by_key;
  determinant_ = {};
  waiting_.reset();
  joined_ = 0;
  last_part_.reset();
  instant_ = {};
  last_event_ = -std::numeric_limits<double>::infinity();
  tangential_events_ = 0;
}

void Variation::set_columns(const Matrix &columns) {
  forget_parts();
  Matrix all(columns.rows(), columns.cols() + n_keys());
  all.rightCols(n_keys()) = columns_.rightCols(n_keys());
  if (projection_.by_state.isIdentity(0))
    all.leftCols(columns.cols()) = columns;
  else
    all.leftCols(columns.cols()) = projection_.by_state * columns;
  columns_ = std::move(all);
}

Vector Variation::orthonormalise() {
  forget_parts();
  const Index count = columns_.cols() - n_keys();
  const Matrix scaled = accuracy_.scale.asDiagonal() * columns_.leftCols(count);
  const Orthonormal found = orthonormalised(scaled, Basis::columns);
  Vector growth(count);
  for (Index k = 0; k < count; ++k) {
    const double left = std::abs(found.diagonal[k]);
    growth[k] = left > dependent_column * scaled.col(k).norm()
                    ? std::log(left)
                    : -std::numeric_limits<double>::infinity();
  }
  columns_.leftCols(count) = accuracy_.scale.cwiseInverse().asDiagonal() * found.basis;
  return growth;
}

// The modes and the interval between breaks that hold from a state on.
void Variation::follow(const Equations &motion, double time, const Vector &state) {
  const auto &modes = motion.modes();
  if (modes != equations_.modes())
    forget_parts();
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
  if (motion.source_break() != equations_.source_break())
    pass_break(state, time, motion.source_break());
}

void Variation::pass_break(const Vector &state, double time, double next) {
  forget_parts();
  if (!keys_.empty())
    columns_.rightCols(n_keys()) += saltations_.at_break(state, next);
  equations_.set_source_break(next);
  for (KeyTangent *key : keys_)
    key->enter(time, next);
  closed_forms_ = !keys_.empty() && keys_keep_linear() && phases_.take_sources(time);
}

bool Variation::keys_keep_linear() const {
  return std::all_of(keys_.begin(), keys_.end(),
                     [](const KeyTangent *key) { return key->keeps_linear(); });
}

// False: the phase is not linear, or the sources have no closed form, which the keys need.
bool Variation::pass_linear(double time, const Vector &state, double h) {
  if (!keys_.empty() && !closed_forms_)
    return false;
  LinearPhase *const phase = keys_.empty() ? phases_.find() : phases_.present();
  if (!phase)
    return false;
  phases_.enter(*phase);
  LinearFlow &flow = phase->part<LinearFlow>();
  Matrix forced;
  if (!keys_.empty())
    forced = flow.forced(keys_, phases_.excitation(), time, state, h);
  flow.propagate(h, columns_);
  if (!keys_.empty())
    columns_.rightCols(n_keys()) += forced;
  determinant_.logarithm += flow.divergence() * h;
  return true;
}

// That of the phase in which the nonlinear contacts have no force, if it is linear.
LinearFlow *Variation::free_flow() {
  const std::vector<int> modes = equations_.modes();
  for (std::size_t c = 0; c < modes.size(); ++c)
    if (!equations_.mode(c).affine && !equations_.mode(c).holds_gap)
      if (const auto mode = contact::free_mode(*equations_.contacts().pairs()[c].law))
        equations_.set_mode(c, *mode);
  LinearPhase *const phase = phases_.find();
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
  if (!phase)
    return nullptr;
  phases_.enter(*phase);
  return &phase->part<LinearFlow>();
}

void Variation::check(double time) const {
  if (!columns_.allFinite())
    throw NumericalError(
        "the variation of the motion is no longer finite at t = " + std::to_string(time) + " s");
}

bool Variation::sees_steps(const Equations &equations) const {
  bool affine = true;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    affine = affine && equations.mode(c).affine;
  return !keys_keep_linear() || !(affine || keys_.empty());
}

void Variation::step(const StepView &view) {
  follow(view.equations(), view.start(), view.start_state());
  if (pass_linear(view.start(), view.start_state(), view.length())) {
    last_part_.reset();
    check(view.end());
  } else {
    join(view);
  }
}

// The motion's steps follow its own error, and near an event where the slope of a force is infinite
// they become so short that the gap within one is nothing but its rounding. Deviations are taken
// through several at once; the last one waits, since an event may be at its end.
void Variation::join(const StepView &view) {
  const bool whole =
      waiting_ && waiting_->from_event && keys_.empty() && contact_episode(equations_);
  if (joined_ >= (whole ? most_joined_in_contact : most_joined) ||
      turn_of_waiting() > (whole ? longest_turn_in_contact : longest_turn))
    catch_up();
  if (!waiting_)
    waiting_ = {.start = view.start(),
                .end = view.end(),
                .start_state = view.start_state(),
                .end_state = {},
                .from_event = same_instant(view.start(), last_event_)};
  waiting_->end = view.end();
  waiting_->end_state = view.end_state();
  ++joined_;
}

// Of the fastest mode [rad].
double Variation::turn_of_waiting() const {
  return waiting_ ? equations_.model().highest_frequency() * waiting_->length() : 0;
}

// What is left may be far shorter than what was integrated before, and is passed together with it.
void Variation::catch_up() {
  if (!waiting_)
    return;
  SmoothPart part = std::move(*waiting_);
  waiting_.reset();
  joined_ = 0;
  const auto contact = keys_.empty() ? contact_episode(equations_) : std::nullopt;
  const auto divergence = contact ? pass_contact_episode(part, *contact, equations_, phases_,
                                                         accuracy_.tolerance, columns_)
                                  : std::nullopt;
  if (divergence) {
    determinant_.logarithm += *divergence;
    last_part_.reset();
    check(part.end);
    return;
  }
  if (last_part_ && part.length() < short_part * last_part_->part.length()) {
    part.start = last_part_->part.start;
    part.start_state = std::move(last_part_->part.start_state);
    part.from_event = last_part_->part.from_event;
    columns_ = std::move(last_part_->columns);
    determinant_.logarithm = last_part_->logarithm;
  }
  last_part_ = {.part = std::move(part), .columns = columns_, .logarithm = determinant_.logarithm};
  determinant_.logarithm +=
      integrate_beside(last_part_->part, equations_, keys_, accuracy_, free_flow(), columns_);
  check(last_part_->part.end);
}

void Variation::forget_parts() {
  catch_up();
  last_part_.reset();
}

void Variation::interval(const Interval &interval) {
  follow(interval.equations(), interval.start(), interval.start_state());
  forget_parts();
  if (pass_linear(interval.start(), interval.start_state(), interval.length()))
    check(interval.end());
  else
    waiting_ = {.start = interval.start(),
                .end = interval.end(),
                .start_state = interval.start_state(),
                .end_state = interval.end_state(),
                .from_event = same_instant(interval.start(), last_event_)};
}

// At one instant: do deviating motions have this event at another time than those before?
bool Variation::contradicts(const Saltation &saltation, double time) {
  const bool again = same_instant(instant_.time, time);
  bool apart = false;
  if (again && instant_.jumps && saltation.jumps) {
    RowVector delay = saltation.delay;
    for (auto map = instant_.maps.rbegin(); map != instant_.maps.rend(); ++map)
      map->apply_from_right(delay);
    const auto size = [&](const RowVector &row) {
      return row.cwiseQuotient(accuracy_.scale.transpose()).cwiseAbs().maxCoeff();
    };
    apart =
        size(delay - instant_.delay) > equal_delays * std::max(size(delay), size(instant_.delay));
  }
  if (!again) {
    instant_.time = time;
    instant_.maps.clear();
    instant_.delay = saltation.delay;
    instant_.jumps = false;
  }
  instant_.jumps = instant_.jumps || saltation.jumps;
  return apart;
}

void Variation::event(const ContactEvent &event) {
  if (waiting_)
    waiting_->to_event = same_instant(waiting_->end, event.time);
  forget_parts();
  last_event_ = event.time;
  std::optional<Saltation> saltation = saltations_.of(event, start_);
  if (!saltation)
    return;
  const bool apart = contradicts(*saltation, event.time);
  tangential_events_ += apart || !saltation->differentiable ? 1 : 0;
  saltation->by_state.apply(columns_);
  columns_.rightCols(n_keys()) += saltation->by_key;
  const double determinant = saltation->by_state.determinant();
  determinant_.logarithm += std::log(std::abs(determinant));
  determinant_.sign *= determinant < 0 ? -1 : 1;
  instant_.maps.push_back(std::move(saltation->by_state));
}

} // namespace vibroimpact::motion
