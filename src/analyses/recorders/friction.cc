#include "analyses/recorders/friction.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using contact::Friction;

namespace {

constexpr const char *friction_section = "Friction";
constexpr const char *sector_dimension = "friction_sector";

bool has_sectors(const contact::ContactPair &pair) {
  return pair.circle && !pair.tangential.empty();
}

std::string friction_path(const std::string &contact) {
  return "contact/" + contact + "/friction/";
}

} // namespace

FrictionRecorder::Labels::Labels(const std::string &contact)
    : energy(friction_path(contact) + "energy", "J",
             "energy that friction takes in the recorded window"),
      work_rate(friction_path(contact) + "work_rate", "W",
                "mean of normal force times sliding speed, of which wear is a multiple"),
      work_rate_error(friction_path(contact) + "work_rate_error", "W",
                      "standard error of the work rate, from the means of blocks of the window"),
      sliding_way(friction_path(contact) + "sliding_way", "m",
                  "way of the surfaces on each other in the recorded window"),
      stick_fraction(friction_path(contact) + "stick_fraction", "1",
                     "part of the recorded window in which the sides stick"),
      slip_fraction(friction_path(contact) + "slip_fraction", "1",
                    "part of the recorded window in which they slip"),
      sticks(friction_path(contact) + "sticks", "1",
             "times the sides come to stick in the recorded window"),
      slips(friction_path(contact) + "slips", "1",
            "times they begin to slip or turn back, or touch in slip") {}

FrictionRecorder::SectorLabels::SectorLabels(const std::string &contact)
    : energy(friction_path(contact) + "sector/energy", "J",
             "energy that friction takes in each sector of the circumference", {sector_dimension}),
      work_rate(friction_path(contact) + "sector/work_rate", "W", "work rate in each sector",
                {sector_dimension}),
      work_rate_error(friction_path(contact) + "sector/work_rate_error", "W", "its standard error",
                      {sector_dimension}),
      largest(friction_path(contact) + "sector/largest_work_rate", "W",
              "work rate of the sector that has most of it"),
      largest_error(friction_path(contact) + "sector/largest_work_rate_error", "W",
                    "its standard error"),
      largest_angle(friction_path(contact) + "sector/largest_angle", "rad",
                    "where that sector has its middle, from Direction") {}

FrictionRecorder::FrictionRecorder(const FrictionSettings &settings, const System &system)
    : contacts_(system.contacts), settings_(settings) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const contact::ContactPair &pair = contacts_.pairs()[c];
    if (pair.tangential.empty())
      continue;
    tracks_.push_back({.contact = c, .labels = Labels(pair.name)});
    if (settings.sectors > 0 && has_sectors(pair))
      tracks_.back().sectors.emplace(
          Sectors{.labels = SectorLabels(pair.name),
                  .work = SectorWork(c, static_cast<std::size_t>(settings.sectors))});
  }
}

void FrictionRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(friction_section, "The recorder of friction.");
  section.integer("Sectors", "0", Range{.lower = 0, .upper = 3600}, "",
                  "Equal sectors of the circumference of each circular gap with friction, along "
                  "which work rate and energy are given. The middle of the first lies along "
                  "Direction, the others follow about Axis. 0: none.");
  WindowBlocks::declare(section, "the standard errors of the work rates");
}

RecorderFactory FrictionRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(friction_section);
  const FrictionSettings settings{.sectors = values.integer("Sectors"),
                                  .blocks = values.integer("Blocks")};
  return [settings, values](const System &system) {
    const auto &pairs = system.contacts.pairs();
    if (settings.sectors > 0 && std::none_of(pairs.begin(), pairs.end(), has_sectors))
      values.reject("Sectors", "Sectors must be 0 where no contact has Gap = circle or beside "
                               "with friction.");
    return std::make_unique<FrictionRecorder>(settings, system);
  };
}

// Integrals of normal force times sliding speed: of all contacts, then of the sectors.
Vector FrictionRecorder::wear(const Vector &state) const {
  std::vector<double> totals;
  for (Index k = 0; k < layout_.n_sliding; ++k)
    totals.push_back(state[layout_.wear_work(k)]);
  for (const Track &track : tracks_)
    if (track.sectors) {
      const Vector work = track.sectors->work.wear();
      totals.insert(totals.end(), work.begin(), work.end());
    }
  return Vector::Map(totals.data(), static_cast<Index>(totals.size()));
}

void FrictionRecorder::begin(const Window &window, const motion::Trajectory &trajectory) {
  window_ = window;
  layout_ = trajectory.layout();
  first_ = trajectory.state();
  for (Track &track : tracks_) {
    track.stuck = track.slipped = 0;
    track.sticks = track.slips = 0;
    if (track.sectors)
      track.sectors->work.clear();
  }
  blocks_.begin(window, settings_.blocks, wear(first_));
}

bool FrictionRecorder::sees_steps(const motion::Equations &equations) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const Track &track) {
    return track.sectors && !equations.inactive(track.contact);
  });
}

void FrictionRecorder::step(const motion::StepView &view) {
  for (Track &track : tracks_)
    if (track.sectors)
      track.sectors->work.add(view);
  interval(view);
}

void FrictionRecorder::interval(const motion::Interval &part) {
  for (Track &track : tracks_) {
    const Friction friction = part.equations().mode(track.contact).friction;
    track.stuck += friction == Friction::stick ? part.length() : 0;
    track.slipped += friction == Friction::slip ? part.length() : 0;
  }
  if (blocks_.ends_with(part))
    blocks_.end_block(part.end(), wear(part.end_state()));
}

void FrictionRecorder::period_end(long cycle, const motion::Trajectory &trajectory) {
  if (blocks_.ends_with_period(cycle))
    blocks_.end_block(trajectory.time(), wear(trajectory.state()));
}

// The first event of a collision stands for contacts that have lasted, where they are; others tell
// their angle themselves.
void FrictionRecorder::add_impact(const motion::ContactEvent &event) {
  const auto lasts = [&](std::size_t contact, int mode) {
    return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].holds_gap;
  };
  for (Track &track : tracks_) {
    if (!track.sectors)
      continue;
    const std::size_t c = track.contact;
    const bool lasted = event.collision && lasts(c, event.collision->modes_before[c]);
    if (!lasted && (event.contact != c || lasts(c, event.from)))
      continue;
    const Index place = contacts_.pairs()[c].sliding_place;
    const Vector taken = *event.state - *event.before;
    SectorWork &work = track.sectors->work;
    work.add_impact(taken[layout_.friction_work(place)], taken[layout_.wear_work(place)],
                    lasted ? work.last_angle() : event.angle);
  }
}

void FrictionRecorder::event(const motion::ContactEvent &event) {
  if (event.guard->action == contact::GuardAction::impact)
    add_impact(event);
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
  blocks_.end_block(trajectory.time(), wear(trajectory.state()));
}

void FrictionRecorder::add_fields(const FieldWriter &result) const {
  const FieldWriter listed = result.listed();
  const Vector errors = blocks_.standard_errors();
  add_angles(result);
  Index behind = layout_.n_sliding;
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const Track &track = tracks_[k];
    const auto place = static_cast<Index>(k);
    result.number(track.labels.energy, change_[layout_.friction_work(place)]);
    listed.number(track.labels.work_rate, change_[layout_.wear_work(place)] / window_.length());
    listed.number(track.labels.work_rate_error, errors[place]);
    result.number(track.labels.sliding_way, change_[layout_.sliding_way(place)]);
    result.number(track.labels.stick_fraction, track.stuck / window_.length());
    result.number(track.labels.slip_fraction, track.slipped / window_.length());
    result.number(track.labels.sticks, static_cast<double>(track.sticks));
    result.number(track.labels.slips, static_cast<double>(track.slips));
    if (!track.sectors)
      continue;
    add_sectors(*track.sectors, errors.segment(behind, settings_.sectors), result);
    behind += settings_.sectors;
  }
}

// The coordinates of the sectors, which all contacts share.
void FrictionRecorder::add_angles(const FieldWriter &result) const {
  for (const Track &track : tracks_)
    if (track.sectors)
      return result.series(sector_dimension, sector_dimension, track.sectors->work.angles(), "rad",
                           "middle of a sector of a circular gap, from Direction about Axis");
}

void FrictionRecorder::add_sectors(const Sectors &sectors, const Vector &errors,
                                   const FieldWriter &result) const {
  const SectorWork &work = sectors.work;
  const Vector rates = work.wear() / window_.length();
  Index largest = 0;
  rates.maxCoeff(&largest);
  result.array(sectors.labels.energy, work.energy());
  result.array(sectors.labels.work_rate, rates);
  result.array(sectors.labels.work_rate_error, errors);
  const FieldWriter listed = result.listed();
  listed.number(sectors.labels.largest, rates[largest]);
  listed.number(sectors.labels.largest_error, errors[largest]);
  listed.number(sectors.labels.largest_angle, work.angles()[static_cast<std::size_t>(largest)]);
}

} // namespace vibroimpact::analyses
