// Where along a motion guards may graze close by.
#include "periodic/graze_extension.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::periodic {

using contact::ContactPair;

namespace {

constexpr double widest_window = 0.25;  // of a window, to either side [periods]
constexpr double farthest_value = 0.1;  // least value or depth over the size of the motion
constexpr double longest_dip = 0.5;     // below zero [periods]; longer ones are no dips
constexpr std::size_t most_windows = 4; // of touches, of other grazes, and of ends of slip

/// The section of a motion [s].
struct Span {
  double begin = 0, end = 0, period = 0;
};

// Of the displacements of a contact's sides in the section.
double gap_size(const StroboscopicMap &map, const ContactPair &pair, const Vector &state) {
  const Index n = pair.gap.row.size();
  const auto largest = [&](const RowVector &row) {
    return row.cwiseAbs().transpose().cwiseQuotient(map.scale().head(n)).maxCoeff();
  };
  const double across = pair.circle ? largest(pair.circle->second().row) : 0;
  return std::max(largest(pair.gap.row), across) * map.norm(state);
}

// With the acceleration w^2 x a touch of speed v reaches v^2 / (2 w^2 x) deep.
double nearness_of(const GuardMinimum &minimum, double size, double period) {
  if (!minimum.passed)
    return minimum.value / size;
  const double speed = minimum.value * period / (2 * std::numbers::pi * size);
  return speed * speed / 2;
}

class Windows {
public:
  Windows(const StroboscopicMap &map, const Vector &state, const MinimumObserver &observer,
          const Span &span)
      : map_{map}, state_{state}, observer_{observer}, span_{span} {}

  /// Those of touches, of other minima and of ends of slip, each the nearest first.
  std::vector<GrazeWindow> list() const {
    std::vector<GrazeWindow> touches, releases, ends;
    for (const GuardMinimum &minimum : observer_.minima())
      if (auto window = of_minimum(minimum))
        (minimum.in_contact ? releases : touches).push_back(*std::move(window));
    for (const SlipEnd &end : observer_.slip_ends())
      ends.push_back(of_end(end));
    keep_nearest(touches);
    for (std::vector<GrazeWindow> *others : {&releases, &ends}) {
      keep_nearest(*others);
      touches.insert(touches.end(), others->begin(), others->end());
    }
    return touches;
  }

private:
  const std::vector<contact::Mode> &modes(std::size_t contact) const {
    return map_.system().contacts().pairs()[contact].law->modes();
  }
  // Slip that sides may not come out of again soon once it has ended.
  bool is_slip(const GuardMinimum &minimum) const {
    const contact::Mode &mode = modes(minimum.contact)[static_cast<std::size_t>(minimum.mode)];
    return mode.friction == contact::Friction::slip &&
           modes(minimum.contact)[static_cast<std::size_t>(mode.guards[minimum.guard].target)]
               .holds_slip;
  }

  std::optional<GrazeWindow> of_minimum(const GuardMinimum &minimum) const {
    const ContactPair &pair = map_.system().contacts().pairs()[minimum.contact];
    const double size =
        minimum.in_contact ? observer_.largest(minimum) : gap_size(map_, pair, state_);
    const double near = nearness_of(minimum, size, span_.period);
    const bool slip = minimum.passed && is_slip(minimum);
    if (!(std::abs(near) < farthest_value) || !(slip || is_dip(minimum)))
      return std::nullopt;
    GrazeWindow window = window_of(minimum, slip);
    window.nearness = near;
    return window;
  }

  // What has not come back at the end of the section goes on at its start.
  bool is_dip(const GuardMinimum &minimum) const {
    const bool lasts = observer_.lasts(minimum);
    const double back = observer_.first_parting(minimum.contact).value_or(span_.begin);
    const double length =
        lasts ? span_.end - minimum.begin + back - span_.begin : minimum.end - minimum.begin;
    return !(lasts && minimum.in_contact) && length <= longest_dip * span_.period;
  }

  // Half-way to the neighbours of the same contact: the touches before and behind a touch, and the
  // changes of mode between which a mode in contact lasts. Where a slip rate falls to zero it has
  // its minimum at once.
  GrazeWindow window_of(const GuardMinimum &chosen, bool at_begin) const {
    const double period = span_.period;
    double from = span_.begin, to = span_.end;
    const auto keep_from = [&](double first, double last) {
      if (last < chosen.begin || (last == chosen.begin && !chosen.in_contact))
        from = std::max(from, (last + chosen.begin) / 2);
      if (first > chosen.end || (first == chosen.end && !chosen.in_contact))
        to = std::min(to, (first + chosen.end) / 2);
    };
    for (const GuardMinimum &other : observer_.minima()) {
      if (!other.passed || other.contact != chosen.contact || &other == &chosen)
        continue;
      if (chosen.in_contact) {
        keep_from(other.begin, other.begin);
        keep_from(other.end, other.end);
      } else if (!other.in_contact) {
        keep_from(other.begin, other.end);
      }
    }
    const double last = at_begin ? chosen.begin : chosen.end;
    return {.contact = chosen.contact,
            .mode = chosen.mode,
            .guard = chosen.guard,
            .in_contact = chosen.in_contact,
            .begin = std::max(from / period, chosen.begin / period - widest_window),
            .position = (at_begin ? chosen.begin : chosen.time) / period,
            .end = std::min(to / period, last / period + widest_window),
            .passed = chosen.passed};
  }

  // From half-way behind the change before it: the slip must have begun. The nearest are those
  // behind which the next change follows soon.
  GrazeWindow of_end(const SlipEnd &end) const {
    double from = span_.begin;
    for (const GuardMinimum &other : observer_.minima())
      if (other.passed && other.contact == end.contact)
        for (const double change : {other.begin, other.end})
          if (change < end.time)
            from = std::max(from, (change + end.time) / 2);
    const double period = span_.period, at = end.time / period;
    return {.contact = end.contact,
            .mode = end.mode,
            .guard = end.guard,
            .in_contact = true,
            .begin = std::max(from / period, at - widest_window),
            .position = at,
            .end = std::min(span_.end / period, at + widest_window),
            .nearness = (end.next > end.time ? end.next - end.time : span_.period) / period,
            .stick = Overlooked{end.contact, end.stick, end.slips_on}};
  }

  static void keep_nearest(std::vector<GrazeWindow> &windows) {
    std::stable_sort(windows.begin(), windows.end(),
                     [](const GrazeWindow &a, const GrazeWindow &b) {
                       return std::abs(a.nearness) < std::abs(b.nearness);
                     });
    windows.resize(std::min(windows.size(), most_windows));
  }

  const StroboscopicMap &map_;
  const Vector &state_;
  const MinimumObserver &observer_;
  Span span_;
};

} // namespace

std::vector<GrazeWindow> graze_windows(const StroboscopicMap &map, const Section &section,
                                       const Vector &state) {
  const double begin = map.first_phase(section), end = begin + section.length();
  MinimumObserver observer(map.system().contacts());
  map.observe(begin, end, state, observer);
  const double period = map.period();
  return Windows(map, state, observer, {begin * period, end * period, period}).list();
}

} // namespace vibroimpact::periodic
