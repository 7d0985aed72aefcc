// How often a quantity rises through given levels, when it first passes them, and for which part of
// the time it lies above: the tail of its distribution.
//
// Along a step a quantity is a polynomial p. Between neighbouring instants at which p - level
// changes its sign it lies on one side (signals/zeros.h): no passage is missed and none is counted
// twice. A jump between steps, as of a velocity at an impact, passes the levels that lie within it.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/recorders/window_blocks.h"

#include <optional>
#include <vector>

namespace vibroimpact::analyses {

struct LevelSettings {
  std::vector<double> levels; ///< increasing, in the unit of the observables
  long blocks = 10;           ///< of the standard errors
};

class LevelCrossings : public Recorder {
public:
  /// The observables have one unit and are polynomials along a step.
  LevelCrossings(LevelSettings settings, std::vector<Observable> observables);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void end(const motion::Trajectory &trajectory) override;
  /// Along crossing_level, for each quantity: /up_crossings, /up_crossing_rate [1/s],
  /// /fraction_above [1], the last two with their standard errors, and /first_passage [s], NaN of a
  /// level that is not passed.
  void add_fields(const FieldWriter &result) const override;

private:
  /// Of one quantity at one level.
  struct Level {
    std::optional<bool> above; ///< at the end of the last step
    long rises = 0;
    double time_above = 0;         ///< [s]
    std::optional<double> passage; ///< the first one, behind the start of the window [s]

    void add(bool is_above, double since_start, double length);
  };
  struct Labels {
    explicit Labels(const Observable &observed);
    Label rises, rate, rate_error, fraction, fraction_error, passage;
  };
  void add(Level &level, double value, const motion::Bernstein &distance,
           const motion::StepView &view) const;
  Vector totals() const;
  /// What `of` makes of each level of a quantity.
  template <typename Of> std::vector<double> of_levels(std::size_t observable, Of of) const;

  LevelSettings settings_;
  std::vector<Observable> observables_;
  std::vector<Labels> labels_;
  std::vector<Level> levels_; ///< of the first quantity, then of the next
  Window window_;
  WindowBlocks blocks_; ///< of what totals() gives
};

} // namespace vibroimpact::analyses
