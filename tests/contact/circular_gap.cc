// Gaps, slip rates and forces in circular gaps: derivatives against differences.
#include "contact/circular_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vibroimpact::contact {
namespace circular_gap_tests {

CircularGap gap_of(CircularGap::Kind kind) { return {kind, 0.7, Vector3::UnitZ(), {}, {}, 0.4}; }

constexpr RelativeMotion somewhere{.position = {0.5, -0.8}, .rate = {1.3, 0.6}};
constexpr AcrossAxis acceleration{-0.9, 2.1};

// A law that depends on all it sees.
LawResponse response_at(const CircularGap &circle, const RelativeMotion &motion) {
  LocalState state;
  circle.see(circle.frame(motion), state);
  const double g = state.gap, w = state.gap_rate, v = state.tangential[0].slip_rate;
  LawResponse response{
      .force = 2 * g * g + 3 * w + g * w, .force_by_gap = 4 * g + w, .force_by_gap_rate = 3 + g};
  response.tangential[0].force = v * g + w * w;
  response.tangential[0].by = {.gap = v, .gap_rate = 2 * w};
  response.tangential[0].by.tangential[0].rate = g;
  return response;
}

// By u_1, u_2, u_1', u_2' in the order of a form of two directions.
void expect_gradient(const AffineForm &form,
                     const std::function<double(const RelativeMotion &)> &f) {
  const double h = 1e-5;
  const auto difference = [&](auto member, std::size_t k) {
    RelativeMotion up = somewhere, down = somewhere;
    (up.*member)[k] += h;
    (down.*member)[k] -= h;
    return (f(up) - f(down)) / (2 * h);
  };
  EXPECT_NEAR(form.gap, difference(&RelativeMotion::position, 0), 1e-8);
  EXPECT_NEAR(form.tangential[0].position, difference(&RelativeMotion::position, 1), 1e-8);
  EXPECT_NEAR(form.gap_rate, difference(&RelativeMotion::rate, 0), 1e-8);
  EXPECT_NEAR(form.tangential[0].rate, difference(&RelativeMotion::rate, 1), 1e-8);
}

class CircularGapTest : public ::testing::TestWithParam<CircularGap::Kind> {
protected:
  CircularGap circle_ = gap_of(GetParam());
  LocalState at(const RelativeMotion &motion) const {
    LocalState state;
    circle_.see(circle_.frame(motion), state);
    return state;
  }
};
INSTANTIATE_TEST_SUITE_P(Kinds, CircularGapTest,
                         ::testing::Values(CircularGap::Kind::inside, CircularGap::Kind::beside));

TEST_P(CircularGapTest, GapAndSlipRate) {
  const double r = std::hypot(0.5, 0.8);
  const LocalState state = at(somewhere);
  EXPECT_NEAR(state.gap, circle_.sense() * (0.7 - r), 1e-15);
  EXPECT_NEAR(state.gap_rate, -circle_.sense() * (0.5 * 1.3 - 0.8 * 0.6) / r, 1e-15);
  const double turn = (0.5 * 0.6 + 0.8 * 1.3) / r; // of u about the axis, times r
  EXPECT_NEAR(state.tangential[0].slip_rate, -circle_.sense() * turn + 0.4, 1e-15);
}

TEST_P(CircularGapTest, GradientsAgainstDifferences) {
  const CircularFrame frame = circle_.frame(somewhere);
  AffineForm form{.constant = 1, .gap = 0.3, .gap_rate = -0.7};
  form.tangential[0].rate = 1.1;
  expect_gradient(circle_.gradient(frame, form),
                  [&](const RelativeMotion &motion) { return form(at(motion)); });
  const std::array<AffineForm, 2> force =
      circle_.force_gradient(frame, response_at(circle_, somewhere));
  for (std::size_t k = 0; k < 2; ++k)
    expect_gradient(force[k], [&](const RelativeMotion &motion) {
      return circle_.force(circle_.frame(motion), response_at(circle_, motion))[k];
    });
  for (const int direction : {0, 1})
    expect_gradient(circle_.acceleration_gradient(frame, acceleration, direction),
                    [&](const RelativeMotion &motion) {
                      return circle_.acceleration(circle_.frame(motion), acceleration, direction);
                    });
}

TEST_P(CircularGapTest, AccelerationsAgainstDifferences) {
  const auto moved = [](double h) {
    RelativeMotion motion = somewhere;
    for (std::size_t k = 0; k < 2; ++k) {
      motion.position[k] += h * somewhere.rate[k] + h * h / 2 * acceleration[k];
      motion.rate[k] += h * acceleration[k];
    }
    return motion;
  };
  const double h = 1e-5;
  const LocalState up = at(moved(h)), down = at(moved(-h));
  const CircularFrame frame = circle_.frame(somewhere);
  EXPECT_NEAR(circle_.acceleration(frame, acceleration, 0), (up.gap_rate - down.gap_rate) / (2 * h),
              1e-8);
  EXPECT_NEAR(circle_.acceleration(frame, acceleration, 1),
              (up.tangential[0].slip_rate - down.tangential[0].slip_rate) / (2 * h), 1e-8);
}

} // namespace circular_gap_tests
} // namespace vibroimpact::contact
