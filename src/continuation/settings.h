// Constants of continuation. Lengths and angles are those of the scaled unknowns
// (Problem::scales()).
#pragma once

#include <limits>

namespace vibroimpact::continuation {

struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

struct Settings {
  // What a run asks for.
  Range first_key;           ///< in which the branch or locus is wanted, in the key's unit
  Range second_key;          ///< of loci
  double longest_step = 0.1; ///< 0.03 to 0.05 for stiff contacts
  double least_step = 1e-9;  ///< shorter steps end the branch
  double first_step = 0.01;
  int most_points = 10000;
  double largest_state = 100; ///< scaled; branches to infinity end there

  // Newton's method on a hyperplane.
  double tolerance = 1e-12; ///< of a correction that is the last
  /// Corrections below this that do not become smaller are the error of the evaluations themselves.
  double noise = 1e-9;
  /// A correction below this is the last too if its successor, by quadratic convergence, is below
  /// rounding.
  double quadratic = 1e-7;
  int most_iterations = 7;         ///< three more where rounding is wanted
  double largest_correction = 0.5; ///< of the step; longer ones lead to other branches

  // Length of steps.
  double largest_angle =
      0.25; ///< between tangents of neighbouring points; a longer step is refused
  double wanted_angle = 0.125;
  int many_iterations = 5; ///< more of them shorten the next step
  int halvings = 4; ///< of a step in which a pair of folds, flips or other points is suspected

  // Charts: below the first margin a point is moved to another chart, below the second one if its
  // step has changed the pattern.
  double least_margin = 0.08;
  double margin_at_changes = 0.12;

  double graze_step = 4e-3;      ///< steps that fail and are shorter look for a graze
  double shorter_return = 1e-8;  ///< a return nearer than this is one of the lower multiple
  double switch_distance = 1e-3; ///< first amplitude of a branch that begins at a flip
};

} // namespace vibroimpact::continuation
