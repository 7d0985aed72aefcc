// The linear phases of a model: one for each combination of contact modes that came up, with all
// that was made for it, under one excitation.
//
// Many contacts come up in ever new combinations. Others may take over (moments/) where making
// phases costs more than it brings: where the phases made have cost, beyond a budget for those that
// come up again, twice what steps over all contact changes would have. That is counted in
// operations and for the phases that a motion meets, whoever made them, so that results depend on
// neither the machine nor the motions before.
//
// What is prepared has a bound (Settings), beyond
// which whole phases are dropped, those that the motion left longest ago first. What motions have
// taught about a phase stays until the next motion begins, so that results are the same to the
// byte.
#pragma once

#include "motion/interval/phase_forms.h"
#include "motion/path/exact_segment.h"
#include "motion/phase/exact_phase.h"
#include "motion/phase/work_integrals.h"
#include "motion/settings.h"

#include <limits>
#include <map>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

class LinearPhase;
struct TaughtContact;

/// What the motion so far has taught about a phase.
struct TaughtPhase {
  bool met = false; ///< by this motion
  TaughtLengths lengths{};
  std::map<std::size_t, std::shared_ptr<TaughtContact>> contacts{}; ///< by guards and modes
};

/// What others have made of a phase; it goes with it.
class PhasePart {
public:
  virtual ~PhasePart() = default;
  virtual std::size_t bytes() const = 0;
  /// Another phase is dropped.
  virtual void forget(const LinearPhase & /*other*/) {}
};

/// What depends on the excitation is renewed when it is asked for under another one.
class LinearPhase : public std::enable_shared_from_this<LinearPhase> {
public:
  /// For the present modes of the equations.
  LinearPhase(const Equations &equations, const Settings &settings, double longest_piece,
              std::shared_ptr<TaughtPhase> taught);

  const LinearSystem &system() const { return system_; }
  const PhaseForms &forms() const { return forms_; }
  ExactPhase &phase() { return phase_; }
  /// The modes of the equations must be those of the phase.
  WorkIntegrals &work(const Equations &equations);
  const PowerForms &powers(const Equations &equations);
  ExactSegment &segment(const Equations &equations);

  /// All phases of a model have parts of the same kind.
  template <class Part> Part &part() {
    if (!part_)
      part_ = std::make_unique<Part>(*this);
    return static_cast<Part &>(*part_);
  }
  /// Of contacts of one kind, which begin at one guard in one mode.
  std::shared_ptr<TaughtContact> &taught(std::size_t kind) { return taught_->contacts[kind]; }
  /// What is prepared, but for lists that do not grow with modes times contacts.
  std::size_t bytes() const;

private:
  friend class ExactPhases;
  std::shared_ptr<TaughtPhase> taught_;
  long entered_ = 0; ///< the last time, counted
  LinearSystem system_;
  PhaseForms forms_;
  ExactPhase phase_;
  double tolerance_, longest_step_;
  std::unique_ptr<PowerForms> powers_;
  std::unique_ptr<WorkIntegrals> work_;
  std::unique_ptr<ExactSegment> segment_;
  long work_excitation_ = -1, segment_excitation_ = -1; ///< that they are for
  std::unique_ptr<PhasePart> part_;
};

class ExactPhases {
public:
  /// Keeps a reference.
  ExactPhases(const Equations &equations, const Settings &settings);

  /// The sources from `time` to their next break. False: one has no closed form there.
  bool take_sources(double time);
  const Excitation &excitation() const { return excitation_; }
  /// Of the present modes of the equations, under the present excitation; nullptr: not linear.
  LinearPhase *present();
  /// The same, whatever excitation it is under.
  LinearPhase *find();
  /// True when the present modes are linear.
  bool linear();
  /// The motion goes on in a phase: where a phase was made since, or a motion began, the others are
  /// dropped that are too many.
  void enter(LinearPhase &phase) {
    phase.entered_ = ++entries_;
    ++changes_;
    if (!phase.taught_->met)
      meet(phase);
    if (check_)
      drop_oldest(phase);
  }
  /// New combinations come up so often that steps would cost less, since forget().
  bool crowded() const {
    return spent_ > budget_ + 2 * static_cast<double>(changes_) * change_cost_;
  }
  /// Forgets what earlier motions taught.
  void forget();
  /// What is prepared.
  std::size_t bytes() const;

  /// Somebody can take over from crowded phases.
  void allow_crowded() { budget_ = 1e9; }

private:
  struct Known {
    std::shared_ptr<TaughtPhase> taught{}; ///< none: not linear
    std::shared_ptr<LinearPhase> phase{};  ///< none: dropped
  };
  void meet(LinearPhase &phase);
  /// But for this one.
  void drop_oldest(const LinearPhase &phase);
  void drop(const LinearPhase &phase);

  const Equations &equations_;
  Settings settings_;
  double longest_piece_;
  std::map<std::vector<int>, Known> phases_;
  long entries_ = 0;
  double budget_ = std::numeric_limits<double>::infinity(); ///< nominal [ns]
  long changes_ = 0;                                        ///< of phases, since forget()
  double spent_ = 0, change_cost_ = 0;                      ///< nominal [ns]
  bool check_ = false;                                      ///< the bytes at the next entry
  std::vector<model::ExponentialForm> sources_;
  Excitation excitation_;
};

} // namespace vibroimpact::motion
