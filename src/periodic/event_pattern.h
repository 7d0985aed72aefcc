// Which contact changes a motion goes through between two section phases, in which order. Changes
// between modes without contact, such as a stop that has parted for good, are none: nothing jumps.
//
// Two motions of one pattern are connected by smooth motions: along a branch the pattern changes at
// grazes only, as long as both motions begin at the same section phase.
#pragma once

#include "motion/interval/observer.h"

#include <vector>

namespace vibroimpact::periodic {

struct PatternEvent {
  double time = 0; ///< since the start of the motion [s]
  std::size_t contact = 0;
  int from = 0, to = 0; ///< modes
  bool onset = false;   ///< the sides have met

  bool same_change(const PatternEvent &other) const {
    return contact == other.contact && from == other.from && to == other.to && onset == other.onset;
  }
};

struct EventPattern {
  std::vector<int> modes; ///< of all contacts at the start; -1 where there is no contact
  bool touches = false;   ///< a contact is closed at the start
  std::vector<PatternEvent> events;
  /// Of the phases that begin with each event: is a contact closed there?
  std::vector<char> touches_after;
  double length = 0; ///< of the motion [s]

  /// What the motion goes through next.
  void append(const EventPattern &next);
  /// Modes and changes without their times.
  std::vector<int> numbers() const;
  /// The same contacts and changes in the same order, whenever they happen.
  bool same_order(const EventPattern &other) const;
  /// Distance in time from the start, which is also the end of a motion that repeats itself, to
  /// the nearest event [s]; the length where there is none.
  double nearest_event() const;
  /// The middle of the longest stay in one phase of a motion that repeats itself, after the start
  /// [s]; phases without a closed contact count double. 0 without events.
  double calmest_instant() const { return longest_stay(1); }
  /// The middle of the longest stay without a closed contact; 0 where there is none.
  double open_instant() const { return longest_stay(0); }

private:
  double longest_stay(double weight_of_contact) const;
};

/// Notes the pattern of the motion that it observes.
class PatternObserver : public motion::Observer {
public:
  PatternObserver(const contact::ContactSet &contacts, double start)
      : contacts_(contacts), start_(start) {}
  bool sees_steps(const motion::Equations & /*equations*/) const override { return false; }
  void interval(const motion::Interval &interval) override { see(interval.equations()); }
  bool wants_integrals() const override { return false; }
  void event(const motion::ContactEvent &event) override;
  EventPattern pattern(double end) const;

private:
  void see(const motion::Equations &equations);
  bool in_contact(std::size_t contact, int mode) const {
    return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].in_contact;
  }

  const contact::ContactSet &contacts_;
  double start_;
  EventPattern pattern_;
  std::size_t entered_ = 0; ///< events whose phase has been seen
  bool begun_ = false;
};

} // namespace vibroimpact::periodic
