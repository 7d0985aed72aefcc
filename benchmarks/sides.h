// All general solvers beside each other for one system.
#pragma once

#include "odeint_side.h"
#include "vibroimpact_side.h"

#include "common/error.h"

#ifdef VIBROIMPACT_HAS_CVODE
#include "cvode_side.h"
#endif

#include <numbers>

namespace vibroimpact::benchmarks {

constexpr double event_tolerance = 1e-12; // [s], the program's default

template <class System>
void add_cvode_sides(const System &system, const typename System::State &start, double end,
                     Case &into) {
#ifdef VIBROIMPACT_HAS_CVODE
  into.sides.push_back(cvode_side("CVODE Adams", CvodeMotion<System>::adams, system, start, end));
  into.sides.push_back(cvode_side("CVODE BDF", CvodeMotion<System>::bdf, system, start, end));
#else
  (void)system, (void)start, (void)end;
  into.sides.push_back({.name = "CVODE Adams", .prepare = {}});
  into.sides.push_back({.name = "CVODE BDF", .prepare = {}});
#endif
}

/// `problem` and `system` are the same equations. The motions begin at time zero with the state
/// that `settling` periods from rest end with; there no contact may last.
template <class System>
Case case_of(const std::string &name, Problem problem, const System &system, double length,
             long settling, long periods) {
  const double period = 2 * std::numbers::pi / system.omega();
  const Vector state = settled(problem, period, settling);
  typename System::State start{};
  std::copy(state.begin(), state.end(), start.begin());
  for (std::size_t i = 0; i < System::contacts; ++i)
    if (!(system.guard(i, start) > 0))
      throw NumericalError(name + ": the motion would begin within a contact");
  problem.end = static_cast<double>(periods) * period;
  Case result{.name = name,
              .length = length,
              .periods = periods,
              .sides = {vibroimpact_side("exact", "exact", problem, state),
                        vibroimpact_side("rk (PETSc TS)", "rk", problem, state),
                        odeint_side(system, start, problem.end, event_tolerance)},
              .baseline = 2,
              .references = {0, 2}};
  add_cvode_sides(system, start, problem.end, result);
  return result;
}

} // namespace vibroimpact::benchmarks
