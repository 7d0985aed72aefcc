#include "reduction/beam_outlines.h"

#include "reduction/parameter_files.h"

#include <gtest/gtest.h>

namespace beam_outlines_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

std::vector<Matrix> outlines_of(const std::string &text) {
  return beam_outlines(body_values(text), "left", ".", MPI_COMM_SELF);
}

} // namespace

// The beam runs along z; its width of 30 mm lies along y, its thickness of 0.75 mm along x.
TEST(BeamOutlines, StandAcrossTheirLines) {
  const std::vector<Matrix> outlines = outlines_of(head_beam());
  ASSERT_EQ(outlines.size(), 20U);
  for (const Matrix &outline : outlines) {
    ASSERT_EQ(outline.cols(), 4);
    EXPECT_TRUE(outline.row(0).cwiseAbs().isApproxToConstant(0.375e-3));
    EXPECT_TRUE(outline.row(1).cwiseAbs().isApproxToConstant(15e-3));
    EXPECT_TRUE(outline.row(2).isZero(1e-15));
  }
}

TEST(BeamOutlines, ABodyWithoutBeamsHasNone) {
  EXPECT_TRUE(outlines_of("subsection Body left\n  set Type = lumped\n" +
                          section("Mass a", "    set Mass = 1 kg\n") + "end\n")
                  .empty());
}

} // namespace beam_outlines_tests
