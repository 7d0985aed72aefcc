#include "analyses/recorders/friction.h"

namespace vibroimpact::analyses {

using contact::Friction;

FrictionRecorder::Labels::Labels(const std::string &contact)
    : energy("contact/" + contact + "/friction/energy", "J",
             "energy that friction takes in the recorded window"),
      work_rate("contact/" + contact + "/friction/work_rate", "W",
                "mean of normal force times sliding speed, of which wear is a multiple"),
      sliding_way("contact/" + contact + "/friction/sliding_way", "m",
                  "way of the surfaces on each other in the recorded window"),
      stick_fraction("contact/" + contact + "/friction/stick_fraction", "1",
                     "part of the recorded window in which the sides stick"),
      slip_fraction("contact/" + contact + "/friction/slip_fraction", "1",
                    "part of the recorded window in which they slip"),
      sticks("contact/" + contact + "/friction/sticks", "1",
             "times the sides come to stick in the recorded window"),
      slips("contact/" + contact + "/friction/slips", "1",
            "times they begin to slip or turn back, or touch in slip") {}

FrictionRecorder::FrictionRecorder(const System &system) : contacts_(system.contacts) {
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (!contacts_.pairs()[c].tangential.empty())
      tracks_.push_back({.contact = c, .labels = Labels(contacts_.pairs()[c].name)});
}

void FrictionRecorder::declare(parameters::Section & /*analysis*/) {}

RecorderFactory FrictionRecorder::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<FrictionRecorder>(system); };
}

void FrictionRecorder::begin(const Window &window, const motion::Trajectory &trajectory) {
  window_ = window;
  layout_ = trajectory.layout();
  first_ = trajectory.state();
  for (Track &track : tracks_) {
    track.stuck = track.slipped = 0;
    track.sticks = track.slips = 0;
  }
}

void FrictionRecorder::interval(const motion::Interval &part) {
  for (Track &track : tracks_) {
    const Friction friction = part.equations().mode(track.contact).friction;
    track.stuck += friction == Friction::stick ? part.length() : 0;
    track.slipped += friction == Friction::slip ? part.length() : 0;
  }
}

void FrictionRecorder::event(const motion::ContactEvent &event) {
  const contact::ContactPair &pair = contacts_.pairs()[event.contact];
  if (pair.tangential.empty() || event.from == event.to)
    return;
  Track &track = tracks_[static_cast<std::size_t>(pair.sliding_place)];
  const Friction now = pair.law->modes()[static_cast<std::size_t>(event.to)].friction;
  const Friction before = pair.law->modes()[static_cast<std::size_t>(event.from)].friction;
  if (pair.law->n_tangential() > 1 && before == now) // all slip along two directions is one
    return;
  track.sticks += now == Friction::stick ? 1 : 0;
  track.slips += now == Friction::slip ? 1 : 0;
}

void FrictionRecorder::end(const motion::Trajectory &trajectory) {
  change_ = trajectory.state() - first_;
}

void FrictionRecorder::add_fields(const FieldWriter &result) const {
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const Track &track = tracks_[k];
    const auto place = static_cast<Index>(k);
    result.number(track.labels.energy, change_[layout_.friction_work(place)]);
    result.number(track.labels.work_rate, change_[layout_.wear_work(place)] / window_.length());
    result.number(track.labels.sliding_way, change_[layout_.sliding_way(place)]);
    result.number(track.labels.stick_fraction, track.stuck / window_.length());
    result.number(track.labels.slip_fraction, track.slipped / window_.length());
    result.number(track.labels.sticks, static_cast<double>(track.sticks));
    result.number(track.labels.slips, static_cast<double>(track.slips));
  }
}

} // namespace vibroimpact::analyses
