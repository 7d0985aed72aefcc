// Keys that searches change: coordinates between bounds, starts, units.
#include "analyses/design/design_keys.h"
#include "simulation.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace design_keys_tests {

std::vector<DesignKey> read(const std::string &keys) {
  const std::string text = R"(set Variables = a = 4, b = 2 mm
subsection Analysis other
end
subsection Analysis search
  set Type = optimise
  subsection Optimise
)" + keys + "end\nend\n";
  const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
  std::vector<std::string> taken;
  return read_design_keys(set->root().instance("Analysis", "search").subsection("Optimise"),
                          "other", taken);
}

DesignKey one(const std::string &lines) {
  return read("subsection Key k\n" + lines + "\nend\n").at(0);
}

TEST(DesignKeysTest, CoordinatesRunFromBoundToBound) {
  const DesignKey key = one("set Path = Variables/b\nset Lower = 1 mm\nset Upper = 0.5 cm");
  EXPECT_EQ(key.parameter.unit, "m");
  EXPECT_DOUBLE_EQ(key.start, 3e-3); // the middle
  EXPECT_DOUBLE_EQ(key.coordinate(2e-3), 0.25);
  EXPECT_DOUBLE_EQ(key.value(0.25), 2e-3);
  EXPECT_EQ(key.value(-1), key.lower);
  EXPECT_EQ(key.value(1.5), key.upper);
  EXPECT_DOUBLE_EQ(key.step, 0.1);
}

TEST(DesignKeysTest, LogarithmicCoordinatesMultiply) {
  const DesignKey key =
      one("set Path = Variables/a\nset Lower = 1\nset Upper = 100\nset Scale = logarithmic");
  EXPECT_NEAR(key.start, 10, 1e-12);
  EXPECT_NEAR(key.value(0.25), std::sqrt(10), 1e-12);
  EXPECT_NEAR(key.coordinate(std::sqrt(10)), 0.25, 1e-14);
  EXPECT_EQ(key.value(0), 1);
  EXPECT_EQ(key.value(1), 100);
}

TEST(DesignKeysTest, WithoutABoundTheStartIsTheMeasure) {
  const DesignKey free = one("set Path = Variables/a\nset Start = 4\nset Lower = 1");
  EXPECT_EQ(free.coordinate(4), 0);
  EXPECT_DOUBLE_EQ(free.value(1), 8);
  EXPECT_EQ(free.value(-1), 1); // 0 lies below the bound
  const DesignKey stepped = one("set Path = Variables/a\nset Start = 0\nset Step = 2");
  EXPECT_DOUBLE_EQ(stepped.value(stepped.step), 2);
}

TEST(DesignKeysTest, OverridesCarryUnits) {
  const std::vector<DesignKey> keys =
      read("subsection Key k\nset Path = Variables/b\nset Lower = 0 mm\nset Upper = 1 mm\nend\n");
  const auto overrides = overrides_at(keys, Vector::Constant(1, 0.5));
  EXPECT_EQ(overrides.at(0).path, "Variables/b");
  EXPECT_EQ(overrides.at(0).value, "5e-04 m");
}

TEST(DesignKeysTest, StartsAreDrawnFromTheSeed) {
  const auto keys = read("subsection Key k\nset Path = Variables/a\nset Lower = 0\nset Upper = 8\n"
                         "set Start = 2\nend\n"
                         "subsection Key l\nset Path = Variables/b\nset Lower = 0 m\n"
                         "set Upper = 1 m\nend\n");
  EXPECT_EQ(start_of_search(keys, 1, 0), Vector(Eigen::Vector2d(0.25, 0.5)));
  EXPECT_EQ(start_of_search(keys, 1, 3), start_of_search(keys, 1, 3));
  EXPECT_NE(start_of_search(keys, 1, 3), start_of_search(keys, 1, 2));
  EXPECT_NE(start_of_search(keys, 1, 3), start_of_search(keys, 2, 3));
  Vector sum = Vector::Zero(2); // uniform in the box: mean 1/2, standard error 1 / sqrt(12 n)
  constexpr int n = 3000;
  for (int i = 1; i <= n; ++i) {
    const Vector start = start_of_search(keys, 1, static_cast<std::size_t>(i));
    EXPECT_GE(start.minCoeff(), 0);
    EXPECT_LT(start.maxCoeff(), 1);
    sum += start;
  }
  EXPECT_NEAR(sum[0] / n, 0.5, 5 / std::sqrt(12.0 * n));
  EXPECT_NEAR(sum[1] / n, 0.5, 5 / std::sqrt(12.0 * n));
}

} // namespace design_keys_tests
} // namespace vibroimpact::analyses
