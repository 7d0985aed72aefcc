#include "analyses/run/cost.h"

#include "common/work_limit.h"
#include "reduction/known_flexibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

namespace vibroimpact::analyses {

namespace {

constexpr std::size_t points_at_a_place = 5; // measured, behind the one that begins
constexpr std::size_t most_places = 60;
constexpr std::size_t least_places = 8;
constexpr double good_enough = 0.05;    // relative standard error
constexpr double least_reported = 0.01; // [s]

/// Of a point, in the journal and in the arrays over all points, both of which are held when the
/// results are put together [B].
double stored_size(const PointResult &point) {
  double numbers = 0;
  for (const Field &field : point.fields)
    numbers += static_cast<double>(field.values.size());
  return 2 * sizeof(double) * numbers + sizeof(std::int64_t) + sizeof(std::string);
}

/// The steps first ... last of a line, the others being left out, and the time each takes.
class TriedSteps : public LineContext {
public:
  TriedSteps(std::size_t first, std::size_t last, const Case &work)
      : first_(first), last_(last), work_(work), begun_(processor_seconds()) {
    left_out_.status = Status::failed; // no state to go on from
  }

  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    const std::size_t step = asked_++;
    return step >= first_ && step <= last_ ? nullptr : &left_out_;
  }
  void store(PointResult result) override {
    const double now = processor_seconds();
    times_.push_back(now - begun_);
    begun_ = now;
    share_ = 0;
    memory_ = std::max(memory_, stored_size(result));
    if (result.status == Status::failed && failed_++ == 0)
      reason_ = result.reason;
    if (first_ + times_.size() > last_)
      throw Interrupted{}; // the rest of the line is not needed
  }
  void note_progress(double share) override {
    share_ = share;
    leave_if_stopped();
  }
  void skip() override {}
  System build(const std::vector<parameters::Override> &overrides) const override {
    return work_.source(overrides);
  }
  const Outcomes &outcomes() const override { return *work_.outcomes; }

  const std::vector<double> &times() const { return times_; } ///< of the finished steps [s]
  std::size_t failed() const { return failed_; }
  const std::string &reason() const { return reason_; }
  /// Of the step at which the limit was reached.
  double share() const { return share_; }
  double memory() const { return memory_; }                          ///< of the largest point [B]
  double since_last() const { return processor_seconds() - begun_; } ///< [s]

private:
  std::size_t first_, last_;
  const Case &work_;
  double begun_;
  mutable std::size_t asked_ = 0;
  PointResult left_out_;
  std::vector<double> times_;
  std::size_t failed_ = 0;
  std::string reason_;
  double share_ = 0;
  double memory_ = 0;
};

/// Times of tried parts that have the same meaning.
class Sample {
public:
  void add(double value) {
    sum_ += value;
    squares_ += value * value;
    ++count_;
  }
  std::size_t count() const { return count_; }
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }
  /// Standard error of the mean; 0 for less than two.
  double error() const {
    if (count_ < 2)
      return 0;
    const auto n = static_cast<double>(count_);
    return std::sqrt(std::max(0.0, squares_ / n - mean() * mean()) / (n - 1));
  }

private:
  double sum_ = 0, squares_ = 0;
  std::size_t count_ = 0;
};

// Every place once, neighbours far apart in time: steps of about the golden section, coprime with
// the number of places.
std::size_t stride_over(std::size_t places) {
  auto stride = std::max<std::size_t>(
      1, static_cast<std::size_t>(static_cast<double>(places) / std::numbers::phi));
  while (std::gcd(stride, places) != 1)
    ++stride;
  return stride;
}

class CostEstimate {
public:
  CostEstimate(const std::vector<GridKey> &keys, const CaseFactory &factory)
      : keys_(keys), factory_(factory), first_(factory(grid_overrides(keys, 0))),
        lines_(first_.analysis->lines()) {
    std::size_t points = 1;
    for (const Axis &axis : first_.analysis->axes())
      points *= axis.size();
    steps_ = points / lines_;
    tasks_ = grid_size(keys) * lines_;
    parts_ = (steps_ + points_at_a_place - 1) / points_at_a_place;
    cost_.points = steps_ * tasks_;
  }

  Cost within(double seconds) {
    const double end = processor_seconds() + seconds;
    const std::size_t places = tasks_ * parts_;
    const std::size_t stride = stride_over(places);
    std::size_t place = places / 2;
    for (std::size_t i = 0; i < std::min(places, most_places) && !sure(); ++i) {
      // Half of what is left, lest one slow place be all that is tried.
      const double left = end - processor_seconds();
      if (!(left > 0.02 * seconds))
        break;
      try_place(place, places == 1 ? left : left / 2);
      place = (place + stride) % places;
    }
    finish();
    return cost_;
  }

private:
  bool sure() const {
    return following_.count() >= least_places &&
           following_.error() < good_enough * following_.mean();
  }

  void try_place(std::size_t place, double seconds) {
    const WorkLimit limit(seconds);
    const std::size_t task = place / parts_;
    const std::size_t measured = (place % parts_) * points_at_a_place;
    const std::size_t first = measured > 0 ? measured - 1 : 0;
    const std::size_t last = std::min(steps_ - 1, measured + points_at_a_place - 1);
    const double start = processor_seconds();
    try {
      Case work = factory_(grid_overrides(keys_, task / lines_));
      building_.add(processor_seconds() - start);
      TriedSteps steps(first, last, work);
      try {
        work.analysis->run_line(task % lines_, work.system, steps);
        note(steps, false);
      } catch (const Interrupted &) {
        note(steps, limit.reached());
      }
    } catch (const InputError &error) {
      building_.add(processor_seconds() - start);
      note_failure(1, error.what());
    }
  }

  void note(const TriedSteps &steps, bool cut) {
    const std::vector<double> &times = steps.times();
    cost_.tried += times.size();
    note_failure(steps.failed(), steps.reason());
    if (!times.empty())
      beginning_.add(times.front());
    if (times.size() > 1)
      following_.add(std::accumulate(times.begin() + 1, times.end(), 0.0) /
                     static_cast<double>(times.size() - 1));
    memory_ = std::max(memory_, steps.memory());
    if (!cut)
      return;
    // Left out, the slow ones would be missed. Without a share it is a lower bound.
    const bool known = steps.share() > 0;
    (times.empty() ? beginning_ : following_).add(steps.since_last() / (known ? steps.share() : 1));
    cost_.at_least = cost_.at_least || !known;
  }

  void note_failure(std::size_t failed, const std::string &reason) {
    if (failed > 0 && cost_.failed == 0)
      cost_.reason = reason;
    cost_.failed += failed;
  }

  // Each line has one point that begins it; the others go on from the one before.
  void finish() {
    const auto tasks = static_cast<double>(tasks_);
    const double others = static_cast<double>(cost_.points) - tasks;
    const Sample &following = following_.count() > 0 ? following_ : beginning_;
    cost_.by_parts = cost_.tried == 0 && beginning_.count() > 0 && !cost_.at_least;
    cost_.seconds = tasks * (building_.mean() + beginning_.mean()) + others * following.mean();
    cost_.memory = static_cast<double>(cost_.points) * memory_;
    cost_.memory_known = cost_.tried > cost_.failed;
    if (cost_.tried < cost_.points)
      cost_.error = std::hypot(tasks * beginning_.error(), others * following.error());
  }

  const std::vector<GridKey> &keys_;
  const CaseFactory &factory_;
  Case first_;
  std::size_t lines_;
  std::size_t steps_ = 1; ///< of a line
  std::size_t parts_ = 1; ///< of a line
  std::size_t tasks_ = 1; ///< lines of all grid points
  Sample building_, beginning_, following_;
  double memory_ = 0; ///< of the largest point [B]
  Cost cost_;
};

} // namespace

std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 60 * minute, day = 24 * hour;
  std::ostringstream text;
  text.precision(2);
  if (seconds >= 2 * day)
    text << std::llround(seconds / day) << " days";
  else if (seconds >= 100 * minute)
    text << seconds / hour << " h";
  else if (seconds >= 10 * minute)
    text << seconds / minute << " min";
  else if (seconds >= 100)
    text << std::llround(seconds) << " s";
  else
    text << seconds << " s";
  return text.str();
}

std::string Cost::sentence() const {
  std::ostringstream text;
  text << points << (points == 1 ? " point, " : " points, ");
  if (!at_least && seconds + 2 * error < least_reported)
    text << "less than " << duration_text(least_reported);
  else
    text << (at_least ? "more than " : "about ") << duration_text(seconds);
  text << " of computing on one core";
  const double twice = 2 * error;
  if (by_parts)
    text << " by a part of the motion; less if it settles early";
  else if (at_least)
    text << "; " << tried << " points tried, others came to no end within the check";
  else if (tried < points && error > 0) {
    text << " (" << duration_text(std::max(seconds - twice, seconds / 10)) << " to "
         << duration_text(seconds + twice) << "; " << tried << " points tried)";
  }
  if (failed > 0)
    text << "; " << failed << " of " << tried << " tried points failed: " << reason;
  return text.str();
}

Cost estimate_cost(const std::vector<GridKey> &keys, const CaseFactory &factory, double seconds) {
  return CostEstimate(keys, factory).within(seconds);
}

std::string body_sentence(const reduction::ReducedBody &body, bool dimensionless) {
  const Vector frequency = body.omega() / (dimensionless ? 1 : 2 * std::numbers::pi);
  const char *unit = dimensionless ? "" : " Hz";
  std::ostringstream text;
  text.precision(6);
  text << body.size() << (reduction::has_modes(body) ? " modes from " : " coordinates from ")
       << frequency.minCoeff() << unit << " to " << frequency.maxCoeff() << unit << ", "
       << body.points.size() << " points";
  return text.str();
}

} // namespace vibroimpact::analyses
