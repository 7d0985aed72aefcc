#include "periodic/graze_extension.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::periodic {

using contact::AffineForm;
using contact::ContactLaw;
using contact::ContactPair;
using contact::LocalState;
using continuation::Extension;
using continuation::Touch;

namespace {

constexpr double widest_window = 0.25;  // of a window, to either side [periods]
constexpr double farthest_value = 0.1;  // least value or depth over the size of the motion
constexpr double longest_dip = 0.5;     // below zero [periods]; longer ones are no dips
constexpr std::size_t most_windows = 4; // of touches, and of other grazes

// Of the displacements of a contact's sides in the section.
double gap_size(const StroboscopicMap &map, const ContactPair &pair, const Vector &state) {
  const Index n = pair.gap.row.size();
  return (pair.gap.row.cwiseAbs().transpose().cwiseQuotient(map.scale().head(n))).maxCoeff() *
         map.norm(state);
}

// With the acceleration w^2 x a touch of speed v reaches v^2 / (2 w^2 x) deep.
double nearness_of(const GuardMinimum &minimum, double size, double period) {
  if (!minimum.passed)
    return minimum.value / size;
  const double speed = minimum.value * period / (2 * std::numbers::pi * size);
  return speed * speed / 2;
}

// Half-way to the neighbours of the same contact: the touches before and behind a touch, and the
// changes of mode between which a mode in contact lasts.
GrazeWindow window_of(const std::vector<GuardMinimum> &minima, const GuardMinimum &chosen,
                      double start, double end, double period) {
  double from = start, to = end;
  const auto keep_from = [&](double first, double last) {
    if (last < chosen.begin || (last == chosen.begin && !chosen.in_contact))
      from = std::max(from, (last + chosen.begin) / 2);
    if (first > chosen.end || (first == chosen.end && !chosen.in_contact))
      to = std::min(to, (first + chosen.end) / 2);
  };
  for (const GuardMinimum &other : minima) {
    if (!other.passed || other.contact != chosen.contact || &other == &chosen)
      continue;
    if (chosen.in_contact) {
      keep_from(other.begin, other.begin);
      keep_from(other.end, other.end);
    } else if (!other.in_contact) {
      keep_from(other.begin, other.end);
    }
  }
  return {.contact = chosen.contact,
          .mode = chosen.mode,
          .guard = chosen.guard,
          .in_contact = chosen.in_contact,
          .begin = std::max(from / period, chosen.begin / period - widest_window),
          .position = chosen.time / period,
          .end = std::min(to / period, chosen.end / period + widest_window)};
}

/// Parts of a motion one behind the other, with the derivatives of the whole.
struct Chain {
  Vector state;
  Matrix by_state = Matrix::Identity(state.size(), state.size());
  Matrix by_keys;
  EventPattern pattern{};

  static Chain at(const StroboscopicMap &map, const Vector &state) {
    return {.state = state,
            .by_keys = Matrix::Zero(state.size(), static_cast<Index>(map.keys().size()))};
  }

  void go(const StroboscopicMap &map, double from, double to) {
    if (!(to > from))
      return;
    const Flow flow = map.flow(from, to, state);
    state = flow.state;
    by_keys = flow.by_state * by_keys + flow.by_keys;
    by_state = flow.by_state * by_state;
    pattern.append(flow.pattern);
  }
  void touch(const GrazeWindow &window) {
    const bool closed =
        pattern.events.empty() ? pattern.touches : pattern.touches_after.back() != 0;
    pattern.events.push_back({.time = pattern.length,
                              .contact = window.contact,
                              .from = window.mode,
                              .to = window.mode});
    pattern.touches_after.push_back(closed ? 1 : 0);
  }
};

bool is_of(const GrazeWindow &window, const GuardMinimum &minimum) {
  if (minimum.contact != window.contact || minimum.in_contact != window.in_contact)
    return false;
  return !window.in_contact || (minimum.mode == window.mode && minimum.guard == window.guard);
}

// The instant [periods] of the minimum nearest to the position of the window.
double minimum_near(const StroboscopicMap &map, const StroboscopicMap &open, double begin,
                    double end, double position, const GrazeWindow &window, const Vector &state) {
  MinimumObserver observer(map.system().contacts());
  open.observe(begin, end, state, observer);
  double best = std::numeric_limits<double>::quiet_NaN();
  for (const GuardMinimum &minimum : observer.minima()) {
    const double instant = minimum.time / map.period();
    if (is_of(window, minimum) && !minimum.passed &&
        !(std::abs(instant - position) >= std::abs(best - position)))
      best = instant;
  }
  if (std::isnan(best))
    throw NumericalError("the guard of a contact has no minimum at the grazing contact");
  return best;
}

class Touching {
public:
  Touching(const StroboscopicMap &map, const StroboscopicMap &open, const GrazeWindow &window,
           double phase, const Vector &state)
      : map_(map), open_(open), contact_(window.contact), guard_(window.guard),
        mode_(static_cast<std::size_t>(window.mode)), phase_(phase), state_(state),
        pair_(map.system().contacts().pairs()[contact_]) {
    open_.start(phase_, state_); // so that the equations are in the modes of the motion
    local_ = equations().local_state(contact_, time(), view());
  }

  double value() const { return form()(local_); }

  RowVector gradient() const {
    const motion::StateLayout &layout = open_.system().layout();
    RowVector row = RowVector::Zero(layout.physical_size());
    row.head(layout.n) = form().gap * pair_.gap.row;
    row.segment(layout.velocity(), layout.n) = form().gap_rate * pair_.gap.row;
    for (std::size_t i = 0; i < form().internal.size(); ++i)
      row[layout.internal() + pair_.internal_offset + static_cast<Index>(i)] = form().internal[i];
    return row;
  }

  // G_x x_p + G_p at a fixed time, where x_p is given at the fixed phase.
  RowVector by_keys(const Matrix &by_keys) const {
    const Vector rates = open_.rates(phase_, state_);
    const auto pick = [this](const ContactLaw &law) -> const AffineForm & {
      return law.modes()[mode_].guards[guard_].indicator;
    };
    open_.start(phase_, state_);
    RowVector row(by_keys.cols());
    for (Index k = 0; k < row.size(); ++k) {
      ForcedKey &key = *map_.keys()[static_cast<std::size_t>(k)];
      key.tangent.enter(time(),
                        equations().source_break()); // no motion of this map may have led here
      row[k] = gradient().dot(by_keys.col(k) - rates * (phase_ * key.period)) +
               key.tangent.form(equations(), contact_, pick, time(), state_);
    }
    return row;
  }

  Touch kind() const {
    if (pair_.law->modes()[mode_].in_contact)
      return Touch::smooth;
    if (pair_.law->rigid())
      return Touch::square_root;
    return dashpot() != 0 && lets_go() ? Touch::corner : Touch::smooth;
  }

  // Derivative, by the value, of the state behind a touch of the kind `corner`.
  Vector jump() const {
    const motion::StateLayout &layout = open_.system().layout();
    Vector jump = Vector::Zero(layout.physical_size());
    const Matrix response = equations().response_to(Matrix(pair_.gap.row), time(), view());
    jump.segment(layout.velocity(), layout.n) = -dashpot() * response.col(0);
    const std::vector<AffineForm> &reset = closing().reset;
    for (std::size_t i = 0; i < reset.size() && form().gap != 0; ++i)
      jump[layout.internal() + pair_.internal_offset + static_cast<Index>(i)] =
          reset[i].gap / form().gap;
    return jump;
  }

private:
  const motion::Equations &equations() const { return open_.system().equations(); }
  ConstVectorView view() const { return {state_.data(), state_.size()}; }
  double time() const { return phase_ * open_.period(); }
  const contact::Guard &closing() const { return pair_.law->modes()[mode_].guards[guard_]; }
  const AffineForm &form() const { return closing().indicator; }

  // -dF/d(gap rate) just behind the touch.
  double dashpot() const {
    contact::LawResponse response;
    pair_.law->evaluate(closing().target, local_, response);
    return -response.force_by_gap_rate;
  }

  // A guard ends the contact as soon as the sides part.
  bool lets_go() const {
    LocalState parting = local_;
    parting.gap_rate += 1;
    const contact::Mode &mode = pair_.law->modes()[static_cast<std::size_t>(closing().target)];
    return std::any_of(mode.guards.begin(), mode.guards.end(), [&](const contact::Guard &guard) {
      return guard.indicator(parting) < guard.indicator(local_);
    });
  }

  const StroboscopicMap &map_, &open_;
  std::size_t contact_, guard_, mode_;
  double phase_;
  const Vector &state_;
  const ContactPair &pair_;
  LocalState local_;
};

// What has not come back at the end of the section goes on at its start.
bool is_dip(const MinimumObserver &observer, const GuardMinimum &minimum, double start, double end,
            double period) {
  const bool lasts = observer.lasts(minimum);
  const double back = observer.first_parting(minimum.contact).value_or(start);
  const double length = lasts ? end - minimum.begin + back - start : minimum.end - minimum.begin;
  return !(lasts && minimum.in_contact) && length <= longest_dip * period;
}

void keep_nearest(std::vector<GrazeWindow> &windows) {
  std::stable_sort(windows.begin(), windows.end(), [](const GrazeWindow &a, const GrazeWindow &b) {
    return std::abs(a.nearness) < std::abs(b.nearness);
  });
  windows.resize(std::min(windows.size(), most_windows));
}

} // namespace

std::vector<GrazeWindow> graze_windows(const StroboscopicMap &map, const Section &section,
                                       const Vector &state) {
  const double period = map.period();
  MinimumObserver observer(map.system().contacts());
  const double end = section.phase + section.length();
  map.observe(section.phase, end, state, observer);
  std::vector<GrazeWindow> touches, releases;
  for (const GuardMinimum &minimum : observer.minima()) {
    const ContactPair &pair = map.system().contacts().pairs()[minimum.contact];
    if (pair.circle) // not followed
      continue;
    const double size = minimum.in_contact ? observer.largest(minimum) : gap_size(map, pair, state);
    const double near = nearness_of(minimum, size, period);
    if (!(std::abs(near) < farthest_value) ||
        !is_dip(observer, minimum, section.phase * period, end * period, period))
      continue;
    std::vector<GrazeWindow> &windows = minimum.in_contact ? releases : touches;
    windows.push_back(
        window_of(observer.minima(), minimum, section.phase * period, end * period, period));
    windows.back().nearness = near;
  }
  keep_nearest(touches);
  keep_nearest(releases);
  touches.insert(touches.end(), releases.begin(), releases.end());
  return touches;
}

GrazingFlow extend(const StroboscopicMap &map, const StroboscopicMap &open, const Section &section,
                   const Vector &state, const GrazeWindow &window) {
  const auto multiple = static_cast<double>(section.multiple());
  const double last = section.phase + section.length();
  const double ahead = window.begin - section.phase;
  const double shift = -std::floor(ahead / multiple + 1e-12) * multiple;
  const double begin = std::max(section.phase, window.begin + shift), end = window.end + shift;
  if (end > last + 1e-12)
    throw NumericalError("the motion is cut where a contact is to graze");
  Chain chain = Chain::at(map, state);
  const std::vector<Index> unseen = map.idle(section.phase, state);
  chain.state(unseen).setZero();
  chain.by_state(Eigen::all, unseen).setZero();
  chain.go(map, section.phase, begin);
  const double touch =
      minimum_near(map, open, begin, end, window.position + shift, window, chain.state);
  chain.go(open, begin, touch);
  chain.touch(window);
  const Vector at_touch = chain.state;
  const Touching touching(map, open, window, touch, at_touch);
  GrazingFlow flow{.touch = touch};
  Extension &extension = flow.extension;
  extension.value = touching.value();
  extension.by_state = touching.gradient() * chain.by_state;
  extension.by_keys = touching.by_keys(chain.by_keys);
  extension.touch = touching.kind();
  Chain behind = Chain::at(map, at_touch);
  const Vector jump = extension.touch == Touch::corner ? touching.jump() : Vector();
  behind.go(open, touch, end);
  behind.go(map, end, last);
  const auto mirrored = [&](const Matrix &columns) { return map.mirrored(section, columns); };
  if (jump.size() > 0)
    extension.jump = mirrored(behind.by_state * jump);
  chain.pattern.append(behind.pattern);
  extension.smooth.residual = mirrored(behind.state) - state;
  extension.smooth.by_state =
      mirrored(behind.by_state * chain.by_state) - Matrix::Identity(state.size(), state.size());
  extension.smooth.by_keys = mirrored(behind.by_state * chain.by_keys + behind.by_keys);
  extension.smooth.pattern = chain.pattern.numbers();
  extension.smooth.chart_margin = chain.pattern.nearest_event() / map.period();
  flow.pattern = std::move(chain.pattern);
  return flow;
}

Flow flow_past(const StroboscopicMap &map, const StroboscopicMap &open, double from, double to,
               const Vector &state, const GrazeWindow &window) {
  Chain chain = Chain::at(map, state);
  chain.go(map, from, std::min(to, window.begin));
  chain.go(open, std::max(from, window.begin), std::min(to, window.end));
  chain.go(map, window.end, to);
  return {.state = chain.state,
          .rates = {},
          .by_state = chain.by_state,
          .by_keys = chain.by_keys,
          .pattern = chain.pattern,
          .determinant = {}};
}

} // namespace vibroimpact::periodic
