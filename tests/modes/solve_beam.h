// Modes of a beam definition, and bending waves in closed form to compare them with.
#pragma once

#include "modes/normal_modes.h"
#include "structure/beam_examples.h"

#include <functional>

namespace vibroimpact::examples {

inline modes::EigenProblem eigen_problem(const structure::AssembledBody &body) {
  return {body.stiffness.get(), body.mass.get(), body.accurate_stiffness->matrix(),
          body.massive_dofs};
}

inline modes::NormalModes solve_beam(const BeamDefinition &beam, const modes::Selection &selection,
                                     MPI_Comm communicator = MPI_COMM_WORLD) {
  const structure::AssembledBody body =
      structure::assemble(structure::build_frame(beam), communicator);
  return modes::normal_modes(eigen_problem(body), selection);
}

inline double bisect(const std::function<double(double)> &f, double lower, double upper) {
  const bool rising = f(upper) > f(lower);
  for (int step = 0; step < 200; ++step) {
    const double middle = (lower + upper) / 2;
    ((f(middle) > 0) == rising ? upper : lower) = middle;
  }
  return (lower + upper) / 2;
}

/// The first zeros of f above 0, bracketed on a grid of the given step.
inline std::vector<double> zeros(const std::function<double(double)> &f, double step, int count) {
  std::vector<double> found;
  for (double x = step; static_cast<int>(found.size()) < count; x += step)
    if (f(x) * f(x + step) <= 0)
      found.push_back(bisect(f, x, x + step));
  return found;
}

/// beta L of a clamped-free beam: cos x cosh x = -1.
inline std::vector<double> clamped_free(int count) {
  return zeros([](double x) { return std::cos(x) + 1 / std::cosh(x); }, 0.1, count);
}
/// Of a free-free beam, without its rigid-body modes: cos x cosh x = 1.
inline std::vector<double> free_free(int count) {
  return zeros([](double x) { return x < 1 ? -1 : std::cos(x) - 1 / std::cosh(x); }, 0.1, count);
}
/// Of a clamped-pinned beam: tan x = tanh x.
inline std::vector<double> clamped_pinned(int count) {
  return zeros([](double x) { return x < 1 ? 1 : std::sin(x) - std::tanh(x) * std::cos(x); }, 0.1,
               count);
}

} // namespace vibroimpact::examples
