#include "motion/interval/observer.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace vibroimpact::motion {

namespace {

bool must_see_steps(Observer &observer, const Equations &equations) {
  if (observer.sees_steps(equations))
    return true;
  std::vector<Output> outputs;
  observer.outputs(equations, outputs);
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const Output &output) { return !is_linear(*output.form, equations); });
}

} // namespace

void Audience::ask(const Equations &equations) {
  outputs.clear();
  for (Observer *observer : list)
    observer->outputs(equations, outputs);
}

void Audience::show(const StepView &view) const {
  for (const Output &output : outputs)
    output.include(view);
  for (Observer *observer : list)
    observer->step(view);
}

void Audience::show(const Interval &interval) const {
  for (Observer *observer : list)
    observer->interval(interval);
}

Observers::Observers(std::vector<Observer *> list) : list_(std::move(list)) {
  static std::atomic<long> made = 0;
  identity_ = made++;
}

bool Observers::want_integrals() const {
  return std::any_of(list_.begin(), list_.end(),
                     [](const Observer *observer) { return observer->wants_integrals(); });
}

void Observers::event(const ContactEvent &event) const {
  for (Observer *observer : list_)
    observer->event(event);
}

Audience Observers::those(bool in_steps, const Equations &equations) const {
  Audience audience;
  std::copy_if(list_.begin(), list_.end(), std::back_inserter(audience.list),
               [&](Observer *one) { return must_see_steps(*one, equations) == in_steps; });
  audience.ask(equations);
  return audience;
}

} // namespace vibroimpact::motion
