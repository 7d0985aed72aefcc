// Restitution against damping: the exact law at known values, and the small-damping limits.
#include "contact/restitution_relation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact {
namespace {

TEST(RestitutionRelationTest, ExactAtKnownValues) {
  EXPECT_NEAR(dimensionless_damping("exact", 0.2), 4.919167, 1e-6);
  EXPECT_NEAR(dimensionless_damping("exact", 0.33377), 2.690447, 1e-6);
  EXPECT_NEAR(dimensionless_damping("exact", 0.5), 1.432751, 1e-6);
  EXPECT_NEAR(dimensionless_damping("exact", 0.7), 0.634828, 1e-6);
  EXPECT_NEAR(dimensionless_damping("exact", 0.9), 0.166482, 1e-6);
  EXPECT_EQ(dimensionless_damping("exact", 1), 0);
}

TEST(RestitutionRelationTest, ExactInBothDirections) {
  for (double e = 0.001; e <= 1; e += 0.0371)
    EXPECT_NEAR(exact_restitution(dimensionless_damping("exact", e)), e, 1e-10);
  for (const double e : {0.999, 0.99999, 1 - 1e-7})
    EXPECT_NEAR(1 - exact_restitution(dimensionless_damping("exact", e)), 1 - e, 1e-4 * (1 - e));
}

TEST(RestitutionRelationTest, AllRelationsAgreeForSmallDamping) {
  const double e = 1 - 1e-5;
  for (const std::string &relation : restitution_relations())
    EXPECT_NEAR(dimensionless_damping(relation, e) / (1.5 * (1 - e)), 1, 1e-4) << relation;
}

TEST(RestitutionRelationTest, RefusesWhatIsNoRestitution) {
  EXPECT_THROW(dimensionless_damping("exact", 0), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("exact", 1.01), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("exact", std::nan("")), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("guess", 0.5), std::invalid_argument);
}

} // namespace
} // namespace vibroimpact
