// Static solutions keep their digits on meshes whose matrices lose them.
#include "modes/static_solution.h"

#include "modes/solve_beam.h"

#include <gtest/gtest.h>

namespace static_solutions_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

// F L^3 / (3 EI): a direct solution loses the fourth power of the number of elements, and one
// correction not all of that again.
TEST(StaticSolutions, OfFineMeshesAreAccurate) {
  BeamDefinition beam = cantilever(3000);
  beam.loads.push_back({.name = "pull", .at = {"end", {}}, .force = {7, 0, 0}});
  const structure::AssembledBody body =
      structure::assemble(structure::build_frame(beam), MPI_COMM_WORLD);
  const Matrix solution = modes::static_solution(eigen_problem(body), body.load);
  const int tip = body.free.number[body.model.points[0].node][0];
  const double exact = 7 * std::pow(beam_length(beam), 3) / (3 * bending_stiffness(beam));
  EXPECT_NEAR(solution(tip, 0) / exact, 1, 1e-9);
}

} // namespace static_solutions_tests
