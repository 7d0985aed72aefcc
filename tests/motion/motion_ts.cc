// Motions as PETSc sees them: its monitors and views, its options for the steps within phases.
#include "motion/steps/motion_ts.h"
#include "common/error.h"
#include "contact/laws/linear_penalty.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>
#include <petscsys.h>

namespace vibroimpact::motion {
namespace motion_ts_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

/// An option of PETSc for the life of the object.
class Option {
public:
  explicit Option(const char *name, const char *value = nullptr) : name_(name) {
    PetscOptionsSetValue(nullptr, name, value);
  }
  ~Option() { PetscOptionsClearValue(nullptr, name_); }
  Option(const Option &) = delete;
  Option &operator=(const Option &) = delete;

private:
  const char *name_;
};

struct Seen {
  Vector state;
  Accuracy accuracy;
  std::string output;
};

// A block that hits a stop, over two intervals.
Seen moved(const std::string &method) {
  const Model model({single_mass("block", 1, 100, 0.5)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.05, std::make_shared<LinearPenalty>(1e3))});
  ::testing::internal::CaptureStdout();
  Trajectory trajectory(model, contacts, {.method = method});
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 1));
  trajectory.advance(0.25);
  trajectory.advance(0.5);
  return {trajectory.state(), trajectory.accuracy(), ::testing::internal::GetCapturedStdout()};
}

TEST(MotionTsTest, IsSeenByMonitorsAndDoesNotChange) {
  const Seen plain = moved("exact");
  EXPECT_EQ(plain.output, "");
  const Option monitor("-ts_monitor");
  const Option view("-ts_view");
  const Seen seen = moved("exact");
  EXPECT_EQ(seen.state, plain.state);
  EXPECT_EQ(seen.accuracy.steps, plain.accuracy.steps);
  EXPECT_NE(seen.output.find("0 TS dt 0.25 time 0."), std::string::npos) << seen.output;
  EXPECT_NE(seen.output.find("1 TS dt 0.25 time 0.25"), std::string::npos) << seen.output;
  EXPECT_NE(seen.output.find("2 TS dt 0.25 time 0.5"), std::string::npos) << seen.output;
  EXPECT_NE(seen.output.find("type: motion"), std::string::npos) << seen.output;
  EXPECT_NE(seen.output.find("method within phases: exact"), std::string::npos) << seen.output;
}

TEST(MotionTsTest, StockIntegratorsHaveTheirPrefix) {
  const Seen plain = moved("rk");
  const Option kind("-sub_ts_rk_type", "8vr");
  const Seen higher = moved("rk");
  EXPECT_LT(higher.accuracy.steps, plain.accuracy.steps);
  EXPECT_LT((higher.state - plain.state).head(2).norm(), 1e-7);
}

TEST(MotionTsTest, AnotherTypeIsRefused) {
  const Option type("-ts_type", "bdf");
  EXPECT_THROW(moved("exact"), InputError);
  ::testing::internal::GetCapturedStdout();
}

TEST(MotionTsTest, FailuresComeOut) {
  const Option monitor("-ts_monitor");
  ::testing::internal::CaptureStdout();
  const std::unique_ptr<MotionTs> ts = MotionTs::create({}, 1);
  const Vector state = Vector::Zero(1);
  EXPECT_THROW(
      ts->step(0, state, 1,
               []() -> const Vector & { throw NumericalError("no step is short enough"); }),
      NumericalError);
  ts->step(0, state, 1, [&]() -> const Vector & { return state; });
  ::testing::internal::GetCapturedStdout();
}

} // namespace motion_ts_tests
} // namespace vibroimpact::motion
