// Periodic motions that may graze, extended smoothly over one graze: what a curve of grazes is
// followed in.
//
// Along such a curve the instant of the graze moves through the period, a quarter of it and more
// where the curve passes a resonance. It counts as a contact change: the section phase is kept away
// from it, and the window in which it is looked for goes with it.
#pragma once

#include "periodic/orbit_problem.h"

namespace vibroimpact::periodic {

class GrazingOrbits : public continuation::Problem {
public:
  /// As for OrbitProblem; `window`: of the graze, at the section phase of the first point.
  GrazingOrbits(MapAlongKeys &maps, long halves, Vector sizes, const GrazeWindow &window)
      : maps_(maps), halves_(halves), sizes_(std::move(sizes)), window_(window) {}

  Vector scales() const override { return sizes_; }
  continuation::Evaluation evaluate(const continuation::Point &point) override;
  /// Of the one graze.
  continuation::Extension extend(const continuation::Point &point,
                                 const continuation::Graze &graze) override;
  double best_chart(const continuation::Point &point) override;
  /// The window goes over to the new chart.
  continuation::Transfer transfer(const continuation::Point &point, double chart) override;
  /// The window.
  std::vector<double> remembered() const override;
  void remember(const std::vector<double> &numbers) override;

private:
  Section section_at(double chart) const { return {.phase = chart, .halves = halves_}; }
  double wrapped(double phase) const;
  /// The window follows its graze.
  GrazingFlow flow(const continuation::Point &point);
  GrazeWindow window_from(double phase, const Section &section, const GrazingFlow &flow,
                          const StroboscopicMap &map) const;

  MapAlongKeys &maps_;
  long halves_;
  Vector sizes_;
  GrazeWindow window_;
};

} // namespace vibroimpact::periodic
