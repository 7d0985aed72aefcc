#include "analyses/curves/locus_follower.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using continuation::End;
using continuation::Locus;
using continuation::LocusKind;
using continuation::LocusPoint;
using continuation::LocusStart;
using continuation::Special;
using continuation::SpecialPoint;
using periodic::OrbitProblem;

namespace {

bool is_of(LocusOf wanted, const SpecialPoint &special, long halves) {
  switch (wanted) {
  case LocusOf::fold:
    return special.kind == Special::fold;
  case LocusOf::period_doubling:
    return special.kind == Special::flip && halves % 2 == 0;
  case LocusOf::loss_of_symmetry:
    return special.kind == Special::flip && halves % 2 != 0;
  case LocusOf::neimark_sacker:
    return special.kind == Special::neimark_sacker;
  case LocusOf::graze:
    return special.kind == Special::graze || special.kind == Special::grazing_fold;
  }
  return false;
}

LocusKind kind_of(const SpecialPoint &special) {
  switch (special.kind) {
  case Special::flip:
    return LocusKind::flip;
  case Special::neimark_sacker:
    return LocusKind::neimark_sacker;
  case Special::graze:
  case Special::grazing_fold:
    return LocusKind::graze;
  default:
    return LocusKind::fold;
  }
}

/// The keys between two points of a locus, by cubic interpolation along the arclength [their
/// sizes].
class Between {
public:
  Between(const LocusPoint &from, const LocusPoint &to, const Eigen::Vector2d &sizes)
      : length_(to.arclength - from.arclength), begin_(scaled(from, sizes)),
        end_(scaled(to, sizes)), begin_slope_(length_ * from.tangent.tail<2>()),
        end_slope_(length_ * to.tangent.tail<2>()) {}

  Eigen::Vector2d at(double way) const {
    const double rest = 1 - way;
    return rest * rest * (1 + 2 * way) * begin_ + way * way * (3 - 2 * way) * end_ +
           way * rest * rest * begin_slope_ - way * way * rest * end_slope_;
  }

  // Where the second key is that of the point, within the error of the interpolation.
  bool passes(const Eigen::Vector2d &point) const {
    constexpr double error = 0.01; // of the length
    double low = 0, high = 1;
    const bool rises = begin_[1] < end_[1];
    if ((begin_[1] - point[1]) * (end_[1] - point[1]) > 0)
      return false;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      ((at(middle)[1] < point[1]) == rises ? low : high) = middle;
    }
    return std::abs(at(low)[0] - point[0]) < error * length_;
  }

private:
  static Eigen::Vector2d scaled(const LocusPoint &point, const Eigen::Vector2d &sizes) {
    return point.point.keys.head<2>().cwiseQuotient(sizes);
  }
  double length_;
  Eigen::Vector2d begin_, end_, begin_slope_, end_slope_;
};

// The same graze among those that another problem sees there, or the nearest of all.
std::optional<continuation::Graze> graze_like(OrbitProblem &problem, const continuation::Point &at,
                                              const std::optional<continuation::Graze> &wanted) {
  std::optional<continuation::Graze> best;
  const auto distance = [&](const continuation::Graze &graze) {
    return std::abs(graze.position - wanted->position);
  };
  for (const continuation::Graze &graze : problem.grazes_near(at))
    if (!best || (wanted && graze.name == wanted->name &&
                  (best->name != wanted->name || distance(graze) < distance(*best))))
      best = graze;
  return best && wanted && best->name != wanted->name ? std::nullopt : best;
}

} // namespace

void LocusOrigins::begin(long number, long halves, double /*sign*/) {
  number_ = number;
  halves_ = halves;
}

void LocusOrigins::add(const SpecialPoint &special) {
  if (std::any_of(kinds_.begin(), kinds_.end(),
                  [&](LocusOf kind) { return is_of(kind, special, halves_); }))
    found_.push_back({.branch = number_, .halves = halves_, .special = special});
}

void LocusOrigins::end(const continuation::Branch &branch) {
  if (branch.end == continuation::End::least_step && !branch.points.empty())
    add(SpecialPoint{
        .kind = Special::graze, .at = branch.points.back(), .vector = {}, .graze = {}});
}

void LocusOrigins::drop(long number) {
  std::erase_if(found_, [number](const LocusOrigin &origin) { return origin.branch == number; });
}

std::vector<LocusOrigin> LocusOrigins::in_order() const {
  std::vector<LocusOrigin> origins = found_;
  const auto key = [](const LocusOrigin &origin) {
    return std::pair(origin.branch, origin.special.at.point.keys[0]);
  };
  std::stable_sort(origins.begin(), origins.end(),
                   [&](const LocusOrigin &a, const LocusOrigin &b) { return key(a) < key(b); });
  return origins;
}

LocusStart LocusFollower::start_at(const LocusOrigin &origin, OrbitProblem &problem) const {
  LocusStart start{.kind = kind_of(origin.special), .point = origin.special.at.point, .graze = {}};
  start.point.keys = Eigen::Vector2d(origin.special.at.point.keys[0], second_);
  if (start.kind == LocusKind::graze) {
    start.graze = graze_like(problem, start.point, origin.special.graze);
    if (!start.graze)
      throw NumericalError("no contact is near grazing there");
  }
  return start;
}

bool LocusFollower::passed(const LocusOrigin &origin, const LocusStart &start) const {
  const Eigen::Vector2d sizes = sizes_.tail<2>();
  const Eigen::Vector2d keys = start.point.keys.head<2>().cwiseQuotient(sizes);
  return std::any_of(done_.begin(), done_.end(), [&](const Done &done) {
    const std::vector<LocusPoint> &points = done.locus.points;
    if (done.kind != start.kind || done.halves != origin.halves)
      return false;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (Between(points[i - 1], points[i], sizes).passes(keys))
        return true;
    return false;
  });
}

void LocusFollower::follow(const LocusOrigin &origin) {
  const double left = left_ - 2;
  follow_both_ways(origin);
  left_ = left; // whether it had two parts or none
}

void LocusFollower::follow_both_ways(const LocusOrigin &origin) {
  OrbitProblem problem(maps_, origin.halves, sizes_);
  LocusStart start{.kind = {}, .point = origin.special.at.point, .graze = {}};
  try {
    start = start_at(origin, problem);
    if (passed(origin, start))
      return;
    table_.begin(loci_, start.kind, origin.halves, 1);
    if (follow(problem, start) != End::closed) {
      table_.begin(loci_, start.kind, origin.halves, -1);
      start.forward = false;
      follow(problem, start);
    }
  } catch (const NumericalError &) {
    table_.begin(loci_, kind_of(origin.special), origin.halves, start.forward ? 1 : -1);
    table_.end_at_start(Eigen::Vector2d(origin.special.at.point.keys[0], second_));
  }
  ++loci_;
}

End LocusFollower::follow(OrbitProblem &problem, const LocusStart &start) {
  Locus locus = continuation::follow_locus(
      problem, start, settings_,
      {.point = progress_.part(start.point, start.forward, left_,
                               [&](const LocusPoint &point) { table_.add(point); }),
       .special = {}},
      steps_);
  table_.end(locus);
  progress_.finish();
  --left_;
  const End end = locus.end;
  done_.push_back({.kind = start.kind, .halves = problem.halves(), .locus = std::move(locus)});
  return end;
}

} // namespace vibroimpact::analyses
