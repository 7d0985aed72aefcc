#include "analyses/recorders/window_recording.h"

namespace vibroimpact::analyses {

using motion::Observer;
using motion::Trajectory;

WindowRecording::WindowRecording(const std::vector<RecorderFactory> &factories,
                                 const System &system) {
  for (const RecorderFactory &factory : factories)
    recorders_.push_back(factory(system));
  together_ = observers({});
}

motion::Observers WindowRecording::observers(std::vector<Observer *> list) const {
  for (const auto &recorder : recorders_)
    list.push_back(recorder.get());
  return list;
}

void WindowRecording::run(const Window &window, Trajectory &trajectory,
                          const std::function<void(long period)> &after_period) {
  watch(window, trajectory, together_, after_period);
}

void WindowRecording::run(const Window &window, Trajectory &trajectory,
                          const std::vector<Observer *> &also) {
  watch(window, trajectory, observers(also), {});
}

void WindowRecording::watch(const Window &window, Trajectory &trajectory,
                            const motion::Observers &all,
                            const std::function<void(long period)> &after_period) {
  for (const auto &recorder : recorders_)
    recorder->begin(window, trajectory);
  for (long cycle = 1; cycle <= window.cycles; ++cycle) {
    trajectory.advance(cycle == window.cycles
                           ? window.end
                           : window.start + static_cast<double>(cycle) * window.period,
                       all);
    for (const auto &recorder : recorders_)
      recorder->period_end(cycle, trajectory);
    if (after_period)
      after_period(cycle);
  }
  if (window.cycles == 0)
    trajectory.advance(window.end, all);
  for (const auto &recorder : recorders_)
    recorder->end(trajectory);
}

void WindowRecording::keep_extrema() {
  std::erase_if(recorders_, [](const auto &recorder) { return !recorder->keeps_extrema(); });
  together_ = observers({});
}

std::vector<ObservedExtremum> WindowRecording::extrema() const {
  std::vector<ObservedExtremum> all;
  for (const auto &recorder : recorders_)
    for (ObservedExtremum &one : recorder->extrema())
      all.push_back(std::move(one));
  return all;
}

void WindowRecording::add_tangents(const TangentMotion &motion, const FieldWriter &result) const {
  for (const auto &recorder : recorders_)
    recorder->add_tangents(motion, result);
}

void WindowRecording::add_fields(const FieldWriter &result) const {
  for (const auto &recorder : recorders_)
    recorder->add_fields(result);
}

Window periods_window(double start, double period, long cycles) {
  return {.start = start,
          .end = start + static_cast<double>(cycles) * period,
          .period = period,
          .cycles = cycles};
}

} // namespace vibroimpact::analyses
