#include "continuation/grazes.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

namespace {

/// Is a node on the branch before a graze or behind it?
enum class Place { before, behind };

/// Which side of the guard a node lies on.
struct Side {
  Side(const ScaledProblem &problem, const LocatedGraze &graze, const Node &node, Place place) {
    constexpr double rounding = 1e-13;
    depth = depth_at(problem, graze, node.u);
    at_graze = std::abs(depth) <= rounding;
    // There the sign is that of rounding; but the guard falls on the way to it from the open side.
    const bool falls = graze.at.gradient.dot(node.tangent) < 0;
    open = at_graze ? falls == (place == Place::before) : depth < 0;
  }
  double depth; ///< scaled
  bool open, at_graze;
};

// Derivatives at the graze itself, on the side where the guard is open or has just closed: there
// they jump by a matrix of rank one at corners, and have no limit at square roots.
std::optional<Linearisation> one_sided(const LocatedGraze &graze, bool open) {
  Linearisation at = graze.at.smooth;
  if (open || graze.at.touch == Touch::smooth)
    return at;
  if (graze.at.touch == Touch::corner && graze.at.jump.size() > 0) {
    at.slope += graze.at.jump * graze.at.gradient;
    return at;
  }
  return std::nullopt;
}

/// The part of the branch between a graze and a node, with its end at the graze.
class Part {
public:
  Part(const ScaledProblem &problem, const LocatedGraze &graze, const Node &far, Place place,
       const Settings &settings)
      : problem_{problem}, settings_{settings}, far_{far}, place_{place},
        side_{problem, graze, far, place}, at_graze_{far} {
    if (side_.at_graze)
      return;
    const bool falls = side_.open == (place == Place::before);
    auto at = one_sided(graze, side_.open);
    if (!side_.open)
      contact_.emplace(ContactSide(problem, graze, settings), far, std::sqrt(side_.depth),
                       falls ? Depth::grows : Depth::falls, at.has_value());
    at_graze_ = at ? make_node(problem, graze.u, graze.chart, std::move(*at),
                               (falls ? -1.0 : 1.0) * graze.at.gradient.transpose())
                   : contact_->at(contact_->first_share());
  }

  bool is_open() const { return side_.open; }
  Node &at_graze() { return at_graze_; }
  std::vector<SpecialPoint> special() const {
    if (side_.at_graze)
      return {};
    const bool leads = place_ == Place::before;
    const Node &begin = leads ? far_ : at_graze_, &end = leads ? at_graze_ : far_;
    return special_points(problem_,
                          contact_ ? Piece(problem_, settings_, begin, end, *contact_)
                                   : Piece(problem_, settings_, begin, end),
                          settings_);
  }

private:
  const ScaledProblem &problem_;
  const Settings &settings_;
  const Node &far_;
  Place place_;
  Side side_;
  std::optional<ContactPath> contact_;
  Node at_graze_;
};

// The tangents at a node behind the graze and of the way to it agree: nothing is hidden between
// them.
bool is_straight(const LocatedGraze &graze, const Node &node) {
  constexpr double agreement = 0.9; // cosine of the largest angle
  return node.tangent.dot((node.u - graze.u).normalized()) > agreement;
}

bool is_within(const ScaledProblem &problem, const Node &node, const Range &range) {
  const double key = problem.point(node.u, node.chart).keys[0];
  return range.lower <= key && key <= range.upper;
}

Node enter_contact(const ScaledProblem &problem, const LocatedGraze &graze, double y,
                   const Settings &settings) {
  return ContactSide(problem, graze, settings)
      .at(y, graze.u, 10 * settings.graze_step, Depth::grows);
}

Node enter_open(const ScaledProblem &problem, const LocatedGraze &graze, double y,
                const Settings &settings) {
  const double length = y * y;
  const Vector gradient = graze.at.gradient.transpose();
  const Vector tangent = tangent_of(graze.at.smooth.slope, gradient);
  Corrected corrected = correct(problem, graze.u + length * tangent, graze.chart, tangent,
                                settings.largest_correction * length, settings);
  return make_node(problem, corrected.u, graze.chart, std::move(corrected.at), gradient);
}

// Roots of the depths of trials behind a graze: within the smallest ones even stiff contacts are
// smooth.
std::vector<double> trial_roots() {
  std::vector<double> roots;
  constexpr int count = 12; // down to depths of 2e-10
  for (int i = 0; i < count; ++i)
    roots.push_back(std::ldexp(0.03, -i));
  return roots;
}

std::optional<Crossing> go_beyond(const ScaledProblem &problem, const LocatedGraze &graze,
                                  const Node &begin, const Settings &settings) {
  const auto enter = Side(problem, graze, begin, Place::before).open ? enter_contact : enter_open;
  for (const double y : trial_roots()) {
    try {
      Node node = enter(problem, graze, y, settings);
      if (node.at.pattern == begin.at.pattern || !is_straight(graze, node) ||
          !is_within(problem, node, settings.first_key))
        continue;
      const double length = (node.u - graze.u).norm();
      node.arclength = begin.arclength + (graze.u - begin.u).norm() + length;
      return Crossing{graze, std::move(node), length};
    } catch (const NumericalError &) {
    }
  }
  return std::nullopt;
}

// Where F jumps its solution is the limit of those on the side of a node; at the graze itself
// rounding would decide.
Node beside(const ScaledProblem &problem, const LocatedGraze &graze, const Node &node,
            const Settings &settings) {
  constexpr double root = 3e-7; // of the depth, which is more than rounding
  return Side(problem, graze, node, Place::before).open
             ? enter_open(problem, graze, root, settings)
             : ContactSide(problem, graze, settings)
                   .at(root, graze.u, settings.graze_step, Depth::falls);
}

bool is_known(const std::vector<LocatedGraze> &found, const LocatedGraze &graze) {
  constexpr double same = 1e-7;
  return std::any_of(found.begin(), found.end(),
                     [&](const LocatedGraze &other) { return (other.u - graze.u).norm() < same; });
}

} // namespace

std::optional<LocatedGraze> locate_graze(const ScaledProblem &problem, const Vector &guess,
                                         double chart, const Graze &graze, double furthest,
                                         const Settings &settings) {
  LocatedGraze located{graze, guess, chart, {}};
  const Index n = problem.states();
  try {
    const auto system = [&](const Vector &u) {
      located.at = problem.extend(u, chart, graze);
      SquareSystem at{Vector(n + 1), Matrix(n + 1, n + 1)};
      at.residual << located.at.smooth.residual, located.at.value;
      at.slope << located.at.smooth.slope, located.at.gradient;
      return at;
    };
    located.u = newton(system, guess, furthest, settings, Until::rounding).u;
  } catch (const NumericalError &) {
    return std::nullopt;
  }
  if ((located.u - guess).norm() > furthest)
    return std::nullopt;
  return located;
}

std::vector<LocatedGraze> grazes_between(const ScaledProblem &problem, const Node &begin,
                                         const Node &end, const Settings &settings) {
  const Vector chord = end.u - begin.u;
  const double length = chord.norm();
  std::vector<LocatedGraze> found;
  for (const Node *node : {&begin, &end})
    for (const Graze &graze : problem.problem().grazes_near(problem.point(node->u, node->chart))) {
      auto located = locate_graze(problem, node->u, node->chart, graze, length, settings);
      if (!located || located->at.touch == Touch::one_sided || is_known(found, *located))
        continue;
      const double way = chord.dot(located->u - begin.u) / (length * length);
      if (way >= 0 && way <= 1)
        found.push_back(std::move(*located));
    }
  std::sort(found.begin(), found.end(), [&](const LocatedGraze &a, const LocatedGraze &b) {
    return chord.dot(a.u) < chord.dot(b.u);
  });
  return found;
}

std::optional<Crossing> cross_graze(const ScaledProblem &problem, const Node &begin,
                                    const Settings &settings) {
  std::vector<LocatedGraze> ahead;
  for (const Graze &graze : problem.problem().grazes_near(problem.point(begin.u, begin.chart))) {
    auto located =
        locate_graze(problem, begin.u, begin.chart, graze, 10 * settings.graze_step, settings);
    if (located && located->at.touch != Touch::one_sided &&
        begin.tangent.dot(located->u - begin.u) > 0)
      ahead.push_back(std::move(*located));
  }
  std::sort(ahead.begin(), ahead.end(), [&](const LocatedGraze &a, const LocatedGraze &b) {
    return (a.u - begin.u).norm() < (b.u - begin.u).norm();
  });
  for (const LocatedGraze &graze : ahead)
    if (auto crossing = go_beyond(problem, graze, begin, settings))
      return crossing;
  return std::nullopt;
}

std::optional<SpecialPoint> graze_that_ends(const ScaledProblem &problem, const Node &last,
                                            const Settings &settings) {
  std::optional<SpecialPoint> nearest;
  double least = settings.graze_step;
  for (const Graze &graze : problem.problem().grazes_near(problem.point(last.u, last.chart))) {
    auto located = locate_graze(problem, last.u, last.chart, graze, least, settings);
    if (!located || located->at.touch != Touch::one_sided)
      continue;
    least = (located->u - last.u).norm();
    Node node = beside(problem, *located, last, settings);
    node.arclength = last.arclength + least;
    nearest = make_special(problem, Special::graze, node, last, last);
    nearest->graze = graze;
    nearest->graze->kind = located->at.kind;
  }
  return nearest;
}

std::vector<SpecialPoint> special_points_across(const ScaledProblem &problem, const Node &begin,
                                                const LocatedGraze &graze, const Node &end,
                                                const Settings &settings) {
  Part before(problem, graze, begin, Place::before, settings);
  Part after(problem, graze, end, Place::behind, settings);
  if (before.is_open() == after.is_open())
    throw NumericalError("the guard of " + graze.graze.name + " does not change its sign");
  Node &first = before.at_graze(), &second = after.at_graze();
  first.arclength = second.arclength = begin.arclength + (graze.u - begin.u).norm();
  auto found = before.special();
  const bool turns = (first.tests.fold < 0) != (second.tests.fold < 0);
  const Special kind = turns ? Special::grazing_fold : Special::graze;
  // The solution is that of the graze, whichever side its derivatives are of.
  found.push_back(make_special(problem, kind, before.is_open() ? first : second, first, second));
  found.back().graze = graze.graze;
  found.back().graze->kind = graze.at.kind;
  const auto behind = after.special();
  found.insert(found.end(), behind.begin(), behind.end());
  return found;
}

} // namespace vibroimpact::continuation
