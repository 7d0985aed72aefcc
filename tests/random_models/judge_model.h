// Is the motion that the default method finds the one that `rk` finds?
#pragma once

#include "random_models/random_model.h"
#include "random_models/run_model.h"

#include <string>

namespace vibroimpact::testing {

struct Verdict {
  /// agree, sensitive, converge, refused, failed (both, with reasons), failed-default, failed-rk,
  /// wrong
  std::string word;
  std::string detail{};
  double seconds = 0; ///< of the default method
  double energy_residual = 0;
};

/// Largest difference of the sampled histories of two runs, displacements and gaps relative to the
/// largest of all of them, forces likewise. The 2 % of samples that differ most are left out: a
/// quantity that jumps differs there by a sample.
double difference(const ModelRun &one, const ModelRun &other);

/// Runs the model by both methods; where they differ by more than 1e-6, also with a first mass that
/// is larger by 1e-9 and by `rk` with tighter tolerance and half the step: a difference within
/// 30 times what these change is the sensitivity of the motion. Where errors add up over many
/// contacts, two methods may differ by more, though the balance closes: they converge when a
/// hundredth of the tolerances takes a difference of up to 1e-3 to a tenth, or below 1e-6, but not
/// to nothing, as it does where a contact change was missed.
Verdict judge_model(std::uint64_t seed, const std::string &folder);
/// The same of a parameter file with an analysis "a" and a mass in it.
Verdict judge_text(const std::string &text, const std::string &folder);

} // namespace vibroimpact::testing
