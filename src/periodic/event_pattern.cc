#include "periodic/event_pattern.h"

#include <algorithm>

namespace vibroimpact::periodic {

void EventPattern::append(const EventPattern &next) {
  if (length == 0) {
    *this = next;
    return;
  }
  for (PatternEvent event : next.events) {
    event.time += length;
    events.push_back(event);
  }
  touches_after.insert(touches_after.end(), next.touches_after.begin(), next.touches_after.end());
  length += next.length;
}

std::vector<int> EventPattern::numbers() const {
  std::vector<int> numbers = modes;
  for (const PatternEvent &event : events)
    numbers.insert(numbers.end(),
                   {static_cast<int>(event.contact), event.from, event.to, event.onset ? 1 : 0});
  return numbers;
}

bool EventPattern::same_order(const EventPattern &other) const {
  return modes == other.modes &&
         std::equal(events.begin(), events.end(), other.events.begin(), other.events.end(),
                    [](const PatternEvent &a, const PatternEvent &b) { return a.same_change(b); });
}

double EventPattern::nearest_event() const {
  double nearest = length;
  for (const PatternEvent &event : events)
    nearest = std::min({nearest, event.time, length - event.time});
  return nearest;
}

// Times of a motion that repeats itself: the last stay goes on into the first.
double EventPattern::longest_stay(double weight_of_contact) const {
  double best = 0, instant = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool last = i + 1 == events.size();
    const double end = last ? length + events.front().time : events[i + 1].time;
    const double stay = (end - events[i].time) * (touches_after[i] ? weight_of_contact : 2);
    if (stay > best) {
      best = stay;
      instant = (events[i].time + end) / 2;
    }
  }
  return instant < length ? instant : instant - length;
}

// The modes of a phase are known with its first interval; several events may lead into it.
void PatternObserver::see(const motion::Equations &equations) {
  std::vector<int> modes = equations.modes();
  bool closed = false;
  for (std::size_t c = 0; c < modes.size(); ++c)
    if (in_contact(c, modes[c]))
      closed = true;
    else
      modes[c] = -1;
  if (!begun_) {
    begun_ = true;
    pattern_.modes = std::move(modes);
    pattern_.touches = closed;
  }
  for (; entered_ < pattern_.events.size(); ++entered_)
    pattern_.touches_after[entered_] = closed ? 1 : 0;
}

void PatternObserver::event(const motion::ContactEvent &event) {
  if (!event.onset && !in_contact(event.contact, event.from) &&
      !in_contact(event.contact, event.to))
    return;
  pattern_.events.push_back({.time = event.time - start_,
                             .contact = event.contact,
                             .from = event.from,
                             .to = event.to,
                             .onset = event.onset});
  pattern_.touches_after.push_back(0);
}

EventPattern PatternObserver::pattern(double end) const {
  EventPattern pattern = pattern_;
  pattern.length = end - start_;
  return pattern;
}

} // namespace vibroimpact::periodic
