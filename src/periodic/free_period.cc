#include "periodic/free_period.h"

#include "common/error.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::periodic {

Plane plane_across(const Vector &state, const Vector &rates, const Vector &scale) {
  const Vector scaled = scale.cwiseProduct(rates);
  const double speed = scaled.norm();
  if (!(speed > 0))
    throw NumericalError("the motion is at rest, so that there is no period to be found");
  return {.point = state, .normal = scale.cwiseProduct(scaled) / speed};
}

std::vector<Passage> passages(const Plane &plane, const Vector &scale, double from, double to,
                              int looks, const std::function<Vector(double time)> &state_at,
                              const std::function<bool(const Passage &)> &enough) {
  std::vector<Passage> list;
  const double step = (to - from) / looks;
  double before = 0, farthest = 0;
  for (int i = 0; i <= looks; ++i) {
    const Vector now = state_at(from + i * step);
    const double distance = plane.distance(now);
    const double away = (now - plane.point).cwiseProduct(scale).norm();
    farthest = std::max(farthest, away);
    if (i > 0 && before < 0 && distance >= 0) {
      list.push_back({.time = from + (i - distance / (distance - before)) * step,
                      .away = away,
                      .farthest = farthest});
      if (enough && enough(list.back()))
        break;
    }
    before = distance;
  }
  return list;
}

namespace {
constexpr std::size_t most_noted = 32;
} // namespace

const Plane &FreePeriod::plane(double phase, const std::function<Plane()> &make) {
  auto found = planes_.find(phase);
  if (found == planes_.end())
    found = planes_.emplace(phase, make()).first;
  return found->second;
}

void FreePeriod::set_plane(double phase, Plane plane) {
  planes_.insert_or_assign(phase, std::move(plane));
}

void FreePeriod::set_key_sizes(Vector sizes) {
  key_sizes_ = std::move(sizes);
  noted_.clear();
}

void FreePeriod::note(const Vector &keys) {
  if (noted_.size() == most_noted)
    noted_.erase(noted_.begin());
  noted_.push_back({keys.cwiseQuotient(key_sizes_), period_});
}

void FreePeriod::recall(const Vector &keys) {
  const Vector here = keys.cwiseQuotient(key_sizes_);
  double least = std::numeric_limits<double>::infinity();
  for (const Noted &noted : noted_)
    if (const double distance = (noted.keys - here).norm(); distance <= least) {
      least = distance; // of equal ones the last
      period_ = noted.period;
    }
}

std::vector<double> FreePeriod::numbers() const {
  std::vector<double> list{period_, static_cast<double>(planes_.size())};
  const auto append = [&](const Vector &entries) {
    list.push_back(static_cast<double>(entries.size()));
    list.insert(list.end(), entries.begin(), entries.end());
  };
  for (const auto &[phase, plane] : planes_) {
    list.push_back(phase);
    append(plane.point);
    append(plane.normal);
  }
  for (const Noted &noted : noted_) {
    list.push_back(noted.period);
    append(noted.keys);
  }
  return list;
}

void FreePeriod::restore(const std::vector<double> &numbers) {
  std::size_t at = 0;
  const auto entries = [&] {
    const auto size = static_cast<Index>(numbers.at(at));
    const Vector list = ConstVectorView(&numbers[at] + 1, size);
    at += 1 + static_cast<std::size_t>(size);
    return list;
  };
  period_ = numbers.at(at++);
  const auto count = static_cast<std::size_t>(numbers.at(at++));
  planes_.clear();
  while (planes_.size() < count) {
    const double phase = numbers.at(at++);
    Plane plane{.point = entries(), .normal = {}};
    plane.normal = entries();
    planes_.emplace(phase, std::move(plane));
  }
  noted_.clear();
  while (at < numbers.size()) {
    const double period = numbers[at++];
    noted_.push_back({entries(), period});
  }
}

} // namespace vibroimpact::periodic
