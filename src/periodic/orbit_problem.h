// Periodic motions along one key or several as a continuation problem: F(x, p) = P(x; p) - x.
//
// A chart is the section phase at which the state is given, in periods from 0 up to the multiple of
// the motion. It is moved where a contact change comes near, with the tangents of the motion to
// the new phase.
#pragma once

#include "continuation/problem.h"
#include "periodic/graze_extension.h"
#include "periodic/orbit.h"

namespace vibroimpact::periodic {

/// The map of a forced system at any values of its keys.
class MapAlongKeys {
public:
  virtual ~MapAlongKeys() = default;
  /// The map at these values, with its derivatives by the keys; valid until the next call.
  /// NumericalError when there is no system at these values.
  virtual const StroboscopicMap &at(const Vector &keys) = 0;
  /// The same map overlooking guards; valid as long as at() of the same values.
  /// Null where an excitation gives the period.
  virtual FreePeriod *free_period() { return nullptr; }
  virtual const StroboscopicMap &overlooking(const Vector &keys, const Overlooked &overlooked) = 0;
  /// Those of a window; valid likewise.
  GrazingMaps grazing(const Vector &keys, const GrazeWindow &window);
};

class OrbitProblem : public continuation::Problem {
public:
  /// Keeps a reference to the maps. `halves` of the motions that are followed; `sizes`: what counts
  /// as one of each entry of the state and of each key, n + keys numbers.
  OrbitProblem(MapAlongKeys &maps, long halves, Vector sizes)
      : maps_(maps), halves_(halves), sizes_(std::move(sizes)) {}

  long halves() const { return halves_; }
  /// Of motions of twice the length.
  OrbitProblem doubled_orbits() const { return {maps_, 2 * halves_, sizes_}; }

  Vector scales() const override { return sizes_; }
  continuation::Evaluation evaluate(const continuation::Point &point) override;
  std::vector<continuation::ShorterReturn>
  shorter_returns(const continuation::Point &point) override;
  std::unique_ptr<continuation::Problem> doubled() override;
  double best_chart(const continuation::Point &point) override;
  continuation::Transfer transfer(const continuation::Point &point, double chart) override;
  std::vector<continuation::Graze> grazes_near(const continuation::Point &point) override;
  continuation::Extension extend(const continuation::Point &point,
                                 const continuation::Graze &graze) override;
  std::unique_ptr<continuation::Problem> extended(const continuation::Graze &graze) override;
  /// Of a free period, which is found from the last one.
  std::vector<double> remembered() const override;
  void remember(const std::vector<double> &numbers) override;

private:
  Section section_at(double chart) const { return {.phase = chart, .halves = halves_}; }
  double periods() const { return static_cast<double>(section_at(0).multiple()); }
  double wrapped(double phase) const;

  MapAlongKeys &maps_;
  long halves_;
  Vector sizes_;
  std::vector<GrazeWindow> windows_; ///< that a Graze::guard counts
};

/// Sizes for OrbitProblem: the largest scaled entry that the motion reaches, over the scale, for
/// each entry of the state; `keys` for the keys.
Vector problem_sizes(const StroboscopicMap &map, const Orbit &orbit, const Vector &keys);

} // namespace vibroimpact::periodic
