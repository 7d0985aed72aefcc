// Pseudo-arclength continuation of a curve: prediction, correction, length of steps, bounds, charts
// and closure. What is followed, and by which rule steps become longer, is the system's
// (curve_system.h).
#pragma once

#include "common/signals.h"
#include "continuation/curve_system.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

template <class System> class CurveContinuation {
public:
  using Curve = typename System::Curve;
  using Node = typename System::Node;
  using Special = typename Curve::Special;

  /// Keeps a reference to the system.
  CurveContinuation(System &system, const Settings &settings, const CurveListener<Curve> &listener)
      : system_{system}, settings_{settings}, listener_{listener}, step_{std::min(
                                                                       settings.first_step,
                                                                       settings.longest_step)} {}

  /// NumericalError where the first point is not found.
  Curve run() {
    begin();
    while (!ended_) {
      leave_if_stopped();
      if (static_cast<int>(curve_.points.size()) >= settings_.most_points)
        end(End::most_points,
            "the limit of " + std::to_string(settings_.most_points) + " points is reached");
      else
        step();
    }
    return std::move(curve_);
  }

private:
  void begin() {
    take(system_.first());
    move_chart(settings_.least_margin);
    first_ = here_;
    add(system_.curve_point(here_), {});
    if (const auto bound = passed(here_.u))
      end(system_.end_at(*bound), "the start lies outside the bounds of a key");
  }

  /// One accepted step or one that is shortened.
  void step() {
    Node next;
    std::vector<Special> special;
    try {
      take_chart_of_start();
      next = next_node();
      if (move_for(next))
        return;
      system_.check(here_, next);
      special = system_.special_points(here_, next, closes_);
    } catch (const NumericalError &error) {
      shorten(error.what());
      return;
    }
    step_ = std::min(step_ * system_.step_factor(here_, next), settings_.longest_step);
    accept(std::move(next), std::move(special));
  }

  void shorten(const std::string &why) {
    if (step_ < settings_.graze_step && cross())
      return;
    step_ /= 2;
    if (step_ < settings_.least_step)
      end(system_.end_at_steps(here_, why));
  }

  /// True if the curve goes on behind a graze, or ends there.
  bool cross() {
    constexpr double same = 1e-7;
    constexpr int most_returns = 3;
    auto behind = system_.behind_graze(here_);
    if (!behind)
      return false;
    const auto returns = std::count_if(crossed_.begin(), crossed_.end(), [&](const Vector &u) {
      return (u - behind->graze).norm() < same;
    });
    if (returns >= most_returns) {
      end(End::graze, "the branch returns repeatedly to the grazing contact of " + behind->guard);
      return true;
    }
    if (!behind->special)
      return false;
    crossed_.push_back(behind->graze);
    step_ = behind->step;
    bound_ = std::nullopt;
    closes_ = false;
    accept(std::move(behind->node), std::move(*behind->special));
    return true;
  }

  /// The point at the distance of a step, or the start or a bound where that lies before it.
  Node next_node() {
    Vector beyond = here_.u + step_ * here_.tangent;
    closes_ = false;
    Node next;
    if (!System::ends_at_predicted_bounds || !passed(beyond))
      next = attempt(beyond);
    bound_ = passed(beyond);
    if (closes_)
      next = first_;
    else if (bound_)
      next = at_bound(beyond);
    next.arclength = here_.arclength + (next.u - here_.u).norm();
    return next;
  }

  /// Beyond a bound there may be no solutions at all: a step that fails there ends at the bound.
  Node attempt(Vector &beyond) {
    try {
      Node next = system_.correct(here_, system_.predicted(here_, step_), here_.tangent,
                                  largest_correction());
      if (angle_between(here_.tangent, next.tangent) > settings_.largest_angle)
        throw NumericalError("the tangent turns too far");
      beyond = next.u;
      closes_ = passes_start(next);
      return next;
    } catch (const NumericalError &) {
      if (!passed(beyond))
        throw;
      return {};
    }
  }

  Node at_bound(const Vector &beyond) const {
    const Index key = bound_->unknown;
    Vector guess = here_.u + (bound_->value - here_.u(key)) / (beyond(key) - here_.u(key)) *
                                 (beyond - here_.u);
    guess(key) = bound_->value;
    return system_.correct(here_, guess, Vector::Unit(guess.size(), key), largest_correction());
  }

  double largest_correction() const { return settings_.largest_correction * step_; }

  void accept(Node next, std::vector<Special> special) {
    if (const auto before = system_.end_before(next, special)) {
      end(*before);
      return;
    }
    system_.accept(here_, next);
    here_ = std::move(next);
    add(system_.curve_point(here_), std::move(special));
    moved_ = false;
    const Index keys = here_.u.size() - system_.problem().states();
    turned_back_ = turned_back_ || here_.tangent.tail(keys).dot(first_.tangent.tail(keys)) <= 0;
    if (closes_)
      end(End::closed, "the curve closes on itself");
    else if (bound_)
      end(system_.end_at(*bound_),
          bound_->upper ? "a key reaches its upper bound" : "a key reaches its lower bound");
    else if (here_.u.head(system_.problem().states()).norm() > settings_.largest_state)
      end(End::far, "the state grows beyond all bounds");
    else
      move_chart(settings_.least_margin);
  }

  void end(Ending<Curve> ending) {
    if (ending.last)
      add(std::move(*ending.last), std::move(ending.special));
    end(ending.end, ending.reason);
  }
  void end(End end, const std::string &reason) {
    ended_ = true;
    curve_.end = end;
    curve_.reason = reason;
  }

  void add(typename Curve::Point point, std::vector<Special> special) {
    for (Special &found : special) {
      found.after = curve_.points.size() - 1;
      if (listener_.special)
        listener_.special(found);
      curve_.special.push_back(std::move(found));
    }
    if (listener_.point)
      listener_.point(point);
    curve_.points.push_back(std::move(point));
  }

  std::optional<Bound> passed(const Vector &u) const {
    return bound_passed(system_.problem(), settings_, u);
  }

  /// On a closed curve the keys come back, so that their direction turns somewhere.
  bool passes_start(const Node &next) const {
    constexpr double agreement = 0.8; // cosine of the largest angle between the tangents
    if (!turned_back_ || next.chart != first_.chart)
      return false;
    const auto ahead = [&](const Node &node) { return (node.u - first_.u).dot(first_.tangent); };
    return ahead(here_) < 0 && ahead(next) >= 0 && (next.u - first_.u).norm() < 1.5 * step_ &&
           next.tangent.dot(first_.tangent) > agreement;
  }

  /// Close to the start the curve must be in its chart to see it.
  void take_chart_of_start() {
    const Index keys = here_.u.size() - system_.problem().states();
    if (!turned_back_ || here_.chart == first_.chart ||
        (here_.u - first_.u).tail(keys).norm() > 2 * step_)
      return;
    Node moved = system_.in_chart(here_, first_.chart);
    if ((moved.u - first_.u).norm() < 2 * step_)
      take(std::move(moved));
  }

  bool move_for(const Node &next) {
    if (moved_ || next.at.chart_margin >= system_.least_margin(here_, next))
      return false;
    moved_ = true;
    return move_chart(system_.least_margin(here_, next));
  }

  bool move_chart(double least_margin) {
    if (here_.at.chart_margin >= least_margin)
      return false;
    const double chart = system_.best_chart(here_);
    if (chart == here_.chart)
      return false;
    take(system_.in_chart(here_, chart));
    return true;
  }

  void take(Node moved) {
    here_ = std::move(moved);
    system_.take_chart(here_);
  }

  System &system_;
  Settings settings_;
  CurveListener<Curve> listener_;
  Curve curve_;
  Node here_, first_;
  double step_;
  bool ended_ = false;
  bool turned_back_ = false;    ///< the keys have gone against their direction at the start
  bool moved_ = false;          ///< the chart was chosen for the step at hand
  std::optional<Bound> bound_;  ///< that ends the step at hand
  bool closes_ = false;         ///< the step at hand ends at the start
  std::vector<Vector> crossed_; ///< grazes
};

} // namespace vibroimpact::continuation
