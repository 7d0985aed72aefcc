// A motion with many contacts in steps that no contact change ends (moment_step.h).
//
// Lengths of steps are those of a ladder with four rungs to the octave, whose tables are kept; only
// the last step before a limit has another length.
#pragma once

#include "motion/moments/moment_ranges.h"
#include "motion/moments/moment_views.h"
#include "motion/path/accuracy.h"
#include "motion/phase/exact_phases.h"
#include "motion/settings.h"

#include <map>
#include <memory>

namespace vibroimpact::motion {

class MomentPath {
public:
  /// Keeps references.
  MomentPath(Equations &equations, ExactPhases &phases, const Settings &settings, Accuracy &counts);

  /// To whom the motion is shown, if to anybody: steps where one of the observers must see them or
  /// asks for what only these tell, else parts between contact changes; and these changes, each
  /// with the state just before it, in the modes before.
  struct Report {
    std::vector<Observer *> observers;
    std::function<void(const StepView &)> show;
    bool integrals = true; ///< of work and impulses are to be kept
    std::function<void(double time, std::size_t contact, std::size_t guard, Vector &state)> change;
  };

  /// Another motion begins, which must not depend on those before; the excitation may be another.
  void begin();
  /// The motion was moved on or changed by somebody else.
  void leave() { running_ = false; }

  /// Goes on from (time, state) in the present modes of the equations to `limit`, no later than the
  /// next break of the sources. True when that moved the motion on, as far as `time`; state() is
  /// where it stands. Short of the limit such steps cannot go on.
  bool advance(double &time, const Vector &state, double limit, const Report *report);
  const Vector &state() const { return state_; }

private:
  struct Change {
    double x = 0; ///< part of the step
    std::size_t contact = 0;
    std::size_t stretch = 0; ///< of its course, that ends there
    double slope = 0;        ///< of the guard by x
  };

  bool start(double time, const Vector &state);
  const MomentTables &tables_of(int rung);
  double length_of(int rung) const;
  bool refuse(std::optional<double> error, double h);
  void accept(double time, double error, bool on_ladder, const Report *report);
  void list_changes(bool observed);
  void correct_changes();
  void correct(Change &change) const;
  const contact::Guard &guard_of(const Change &change) const;
  void skip_changes();
  void show(double time, const Report &report);
  void show_whole(double time, const Report &report);
  void show_part(double end, const Report &report);
  double base_rate(Index row, double time) const;
  void add_integrals(double time, std::size_t contact, const CourseStretch &stretch);
  void add_power(double start, double end,
                 const std::function<MomentViews::Motion(double part)> &motion);
  void add_power(double time);
  void note_residual(double time, const Change &change);
  void pass(double time, const Change &change, const Report &report);

  Equations &equations_;
  ExactPhases &phases_;
  Accuracy &counts_;
  MomentStep step_;
  MomentViews views_;
  MomentRanges ranges_;
  double unit_, event_tolerance_, longest_;
  int rung_ = 0;
  bool running_ = false;
  std::map<int, MomentTables> tables_;
  std::vector<Change> changes_;
  Vector state_;
  EndPoint start_point_, end_point_;
  contact::LawResponse response_;
};

} // namespace vibroimpact::motion
