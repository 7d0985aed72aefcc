// What the lines of a basin have in common is made once.
#include "analyses/basins/basins.h"

#include "contact/laws/bilinear_stop.h"
#include "support/points.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace basins_tests {

// Of the isolator y'' + 0.02 y' + y + stops = 0.52 sin(1.3 t), which has two stable motions.
System isolator(const std::vector<parameters::Override> &overrides) {
  model::Model model({testing::single_mass("mass", 1, 1, 2 * 0.01)});
  model.add_force("push",
                  std::make_shared<model::Harmonic>(model::Given::displacement, 0.52, 1.3, 0), {},
                  Vector3::UnitX());
  const auto law = std::make_shared<contact::BilinearStop>(2, 2 * 0.2);
  contact::ContactPair right = testing::contact_along_x(model, "mass.head", "", 1, law);
  right.accept_initial_penetration = true;
  contact::ContactPair left = right;
  left.gap.row *= -1;
  System system = testing::system_of(std::move(model), contact::ContactSet({right, left}));
  for (const parameters::Override &change : overrides)
    (change.path == "Speed" ? system.initial.velocity : system.initial.displacement)[0] =
        std::stod(change.value);
  return system;
}

Basins::Settings settings() {
  return {.first = {.path = "Place", .unit = "m", .values = {-2, -1, 0, 1, 2}},
          .second = {.path = "Speed", .unit = "m/s", .values = {-2, -1, 0, 1, 2}},
          .search = {.attractors = {.most_periods = 2000, .longest_multiple = 4}, .excitation = ""},
          .coarse = 5,
          .exactly = true,
          .nodes = 0,
          .checked_every = 0};
}

struct Computed {
  testing::Points points;
  std::vector<long> systems; ///< built in each line
};

// Lines by one analysis, as those of a rank are, or by one each.
void compute(bool together, Computed &into) {
  long built = 0;
  into.points = testing::Points([&](const std::vector<parameters::Override> &overrides) {
    ++built;
    return isolator(overrides);
  });
  const Basins shared(settings());
  for (std::size_t line = 0; line < shared.lines(); ++line) {
    const Basins alone(settings());
    System system = isolator({});
    built = 0;
    (together ? shared : alone).run_line(line, system, into.points);
    into.systems.push_back(built);
  }
}

TEST(BasinsTest, TheLinesOfARankSearchTheCoarsePartOnce) {
  Computed together, alone;
  compute(true, together);
  compute(false, alone);
  ASSERT_EQ(together.systems.size(), 5u);
  for (std::size_t line = 1; line < together.systems.size(); ++line) {
    EXPECT_LT(2 * together.systems[line], together.systems[0]) << line;
    EXPECT_EQ(alone.systems[line], alone.systems[0]) << line;
  }
  for (const auto &[index, result] : alone.points.all()) {
    ASSERT_EQ(result.status, Status::finished) << result.reason;
    const PointResult &other = together.points.all().at(index);
    ASSERT_EQ(other.fields.size(), result.fields.size());
    for (std::size_t f = 0; f < result.fields.size(); ++f)
      EXPECT_EQ(other.fields[f].values, result.fields[f].values) << result.fields[f].name();
  }
  EXPECT_EQ(alone.points.values({2}, "attractors/period_multiple").size(), 2u);
}

} // namespace basins_tests
} // namespace vibroimpact::analyses
