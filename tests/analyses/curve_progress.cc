// The share of curves that is done, from where their key is.
#include "analyses/curves/curve_progress.h"
#include "continuation/branch.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace curve_progress_tests {

using continuation::BranchPoint;

class CurveProgressTest : public ::testing::Test {
protected:
  static continuation::Point at(double key) {
    return {.state = {}, .keys = Vector::Constant(1, key)};
  }
  /// The shares at points of a part that begins at the first of these values.
  std::vector<double> shares(const std::vector<double> &keys, bool with_start, double left) {
    shares_.clear();
    auto listener = progress_.part(at(keys.front()), with_start, left,
                                   [&](const BranchPoint & /*point*/) { ++added_; });
    for (const double key : keys) {
      BranchPoint point;
      point.point = at(key);
      listener(point);
    }
    return shares_;
  }

  std::vector<double> shares_;
  int added_ = 0;
  CurveProgress progress_{
      {.lower = 0, .upper = 10}, 0, [this](double share) { shares_.push_back(share); }};
};

TEST_F(CurveProgressTest, GoesByTheKeyAndNeverBack) {
  const double behind_a_fold = 5;
  EXPECT_EQ(shares({4, 7, behind_a_fold, 10}, true, 2), (std::vector{0.0, 0.25, 0.25, 0.5}));
  progress_.finish();
  EXPECT_EQ(shares({4, 2, 0}, false, 1), (std::vector{0.5, 0.75, 1.0}));
  EXPECT_EQ(added_, 6); // the start once
}

TEST_F(CurveProgressTest, OfMoreCurvesThanWereKnown) {
  EXPECT_EQ(shares({0, 10}, true, 1), (std::vector{0.0, 1.0}));
  progress_.finish();
  EXPECT_EQ(shares({0, 5, 10}, true, 3), (std::vector{1.0, 1.0, 1.0}));
}

} // namespace curve_progress_tests
} // namespace vibroimpact::analyses
