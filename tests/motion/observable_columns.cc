// Deviations of bodies with many modes that hit: those that the contact observes are integrated,
// the others go on in closed form, and both together are the same as all of them integrated.
#include "motion/variation/observable_columns.h"

#include "contact/laws/hunt_crossley.h"
#include "motion/path/trajectory.h"
#include "motion/variation/joint_integration.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace observable_columns_tests {

constexpr Index modes = 16;

// Frequencies as the squares of whole numbers, as those of a beam.
// Every second mode moves the head by `of_even` of what the others do.
std::shared_ptr<const reduction::ReducedBody> many_modes(double of_even) {
  auto body = std::make_shared<reduction::ReducedBody>(*testing::single_mass("block", 1, 1, 0));
  const Vector number = Vector::LinSpaced(modes, 1, static_cast<double>(modes));
  const Vector omega = 2 * number.cwiseAbs2();
  body->mass = Vector::Ones(modes);
  body->stiffness = omega.cwiseAbs2();
  body->damping = (0.04 * omega).asDiagonal();
  body->base_participation = Matrix::Zero(modes, 3);
  body->points[0].rows = Matrix::Zero(6, modes);
  body->points[0].rows.row(0) = (1.0 / number.array()).matrix().transpose();
  for (Index k = 1; k < modes; k += 2)
    body->points[0].rows(0, k) *= of_even;
  return body;
}

struct Hitting {
  double of_even = 1;
  model::Model model{{many_modes(of_even)}};
  contact::ContactSet contacts{
      {testing::contact_along_x(model, "block.head", "", 0.01,
                                contact::HuntCrossley::with_dimensionless_damping(
                                    {.stiffness = 1e6, .exponent = 1.5}, 0.4, 1e-6))}};
  Index size = 2 * modes + 1;

  MotionState start() const {
    Vector state = Vector::Zero(size);
    state[modes] = 1;
    state.tail(1) = contacts.initial_internal();
    return {.time = 0, .physical = state};
  }
  /// How far the head moves by each mode.
  Vector scale() const {
    Vector scale = Vector::Ones(size);
    for (Index k = 1; k < 2 * modes; k += 2)
      scale[k] = of_even;
    return scale;
  }
  /// The phase without contact.
  std::unique_ptr<ExactPhases> free_phases(Equations &equations) const {
    equations.set_mode(0, 0);
    return std::make_unique<ExactPhases>(equations, Settings());
  }
};

/// Integrates the steps in contact in both ways.
class Both : public Observer {
public:
  Both(const Hitting &of)
      : size_(of.size), scale_(of.scale()), equations_(of.model, of.contacts),
        phases_(of.free_phases(equations_)), free_(*phases_->find()) {}

  void step(const StepView &view) override {
    if (view.equations().mode(0).affine)
      return;
    const VariationAccuracy accuracy{.scale = scale_, .tolerance = 1e-11};
    Matrix all = Matrix::Identity(size_, size_), some = all;
    const SmoothPart part{.start = view.start(),
                          .end = view.end(),
                          .start_state = view.start_state(),
                          .end_state = view.end_state()};
    const double of_all = integrate_beside(part, view.equations(), {}, accuracy, nullptr, all);
    const double of_some = integrate_beside(part, view.equations(), {}, accuracy, &free_, some);
    largest = std::max(largest, (some - all).cwiseAbs().maxCoeff() / all.cwiseAbs().maxCoeff());
    EXPECT_NEAR(of_some, of_all, 1e-9 * std::max(1.0, std::abs(of_all)));
    if (const auto split =
            observable_columns(view.equations(), free_, accuracy.scale, view.length(), all))
      fewest = std::min(fewest, split->basis.cols());
    ++steps;
  }

  double largest = 0;
  Index fewest = 1000;
  int steps = 0;

private:
  Index size_;
  Vector scale_;
  Equations equations_;
  std::unique_ptr<ExactPhases> phases_;
  LinearFlow free_;
};

void expect_all_columns(const Hitting &hitting) {
  Trajectory trajectory(hitting.model, hitting.contacts, {.relative_tolerance = 1e-10});
  trajectory.start(hitting.start());
  Both both(hitting);
  trajectory.advance(0.2, both);
  EXPECT_GE(both.steps, 3);
  EXPECT_LT(both.largest, 1e-9);
  EXPECT_LE(both.fewest, hitting.size / 2);
}

TEST(ObservableColumnsTest, TheSameAsAllColumnsIntegrated) { expect_all_columns({}); }

// Modes with a node at the head move it by rounding: in the others nothing may be seen of theirs.
TEST(ObservableColumnsTest, ModesThatMoveTheHeadByRounding) {
  expect_all_columns({.of_even = 1e-17});
}

// The gap of what is left over stays zero all the way, without contact.
TEST(ObservableColumnsTest, WhatIsLeftIsNotSeen) {
  const Hitting hitting;
  Equations equations(hitting.model, hitting.contacts), in_contact = equations;
  const auto phases = hitting.free_phases(equations);
  LinearFlow free(*phases->find());
  in_contact.set_mode(0, 1);
  ASSERT_FALSE(in_contact.mode(0).affine);
  const Vector scale = Vector::Ones(hitting.size);
  const double h = 2e-3; // a period of the fastest mode is 12e-3
  for (const double share : {0.1, 0.5, 1.0}) {
    const auto split = observable_columns(in_contact, free, scale, h,
                                          Matrix::Identity(hitting.size, hitting.size));
    ASSERT_TRUE(split);
    Matrix left = Matrix::Identity(hitting.size, hitting.size) - split->basis * split->coefficients;
    free.propagate(share * h, left);
    const RowVector &row = hitting.contacts.pairs()[0].gap.row;
    EXPECT_LT((row * left.topRows(modes)).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((row * left.middleRows(modes, modes)).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT(left.bottomRows(1).cwiseAbs().maxCoeff(), 1e-14);
  }
}

} // namespace observable_columns_tests
} // namespace vibroimpact::motion
