// The linear phases of a model: one for each combination of contact modes that came up, with all
// that was made for it, under one excitation.
#pragma once

#include "motion/exact/exact_phase.h"
#include "motion/exact/exact_segment.h"
#include "motion/exact/work_integrals.h"
#include "motion/segment/phase_forms.h"
#include "motion/settings.h"

#include <map>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// What depends on the excitation is renewed when it is asked for under another one.
class LinearPhase {
public:
  /// For the present modes of the equations.
  LinearPhase(const Equations &equations, const Settings &settings, double longest_piece);

  const LinearSystem &system() const { return system_; }
  const PhaseForms &forms() const { return forms_; }
  ExactPhase &phase() { return phase_; }
  /// The modes of the equations must be those of the phase.
  WorkIntegrals &work(const Equations &equations);
  const PowerForms &powers(const Equations &equations);
  ExactSegment &segment(const Equations &equations);

private:
  LinearSystem system_;
  PhaseForms forms_;
  ExactPhase phase_;
  double tolerance_, longest_step_;
  std::unique_ptr<PowerForms> powers_;
  std::unique_ptr<WorkIntegrals> work_;
  std::unique_ptr<ExactSegment> segment_;
  long work_excitation_ = -1, segment_excitation_ = -1; ///< that they are for
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
  /// Forgets what earlier motions taught about lengths of pieces.
  void forget();

private:
  const Equations &equations_;
  Settings settings_;
  double longest_piece_;
  std::map<std::vector<int>, std::unique_ptr<LinearPhase>> phases_; ///< none: not linear
  std::vector<model::ExponentialForm> sources_;
  Excitation excitation_;
};

} // namespace vibroimpact::motion
