// Restitution against damping: the relations at known values, their limits, and what two bodies
// then show.
#include "contact/restitution_relation.h"
#include "contact/laws/hunt_crossley.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace vibroimpact::contact {
namespace restitution_relation_tests {

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

// The published formulas at e = 1/2, worked out by hand.
TEST(RestitutionRelationTest, PublishedFormulasAtOneHalf) {
  const std::map<std::string, double> expected = {
      {"exact", 1.432751}, {"hunt-crossley", 0.75},         {"herbert-mcwhannell", 1.0},
      {"lee-wang", 0.375}, {"lankarani-nikravesh", 0.5625}, {"gonthier", 1.5},
      {"flores", 1.6}};
  ASSERT_EQ(restitution_relations().size(), expected.size());
  for (const std::string &relation : restitution_relations())
    EXPECT_NEAR(dimensionless_damping(relation, 0.5), expected.at(relation), 1e-6) << relation;
}

// d_c / (1 - e) for e -> 1 is 3/2 for the motion itself, and for those relations that were derived
// for small losses.
TEST(RestitutionRelationTest, SlopesForSmallLosses) {
  const std::map<std::string, double> slopes = {
      {"exact", 1.5},     {"hunt-crossley", 1.5},       {"herbert-mcwhannell", 1.5},
      {"lee-wang", 0.75}, {"lankarani-nikravesh", 1.5}, {"gonthier", 2},
      {"flores", 1.6}};
  const double e = 1 - 1e-5;
  for (const std::string &relation : restitution_relations()) {
    EXPECT_NEAR(dimensionless_damping(relation, e) / (1 - e), slopes.at(relation), 1e-4)
        << relation;
    EXPECT_EQ(dimensionless_damping(relation, 1), 0) << relation;
  }
}

// Two free bodies that meet show the exact restitution for whatever damping a relation asks for.
TEST(RestitutionRelationTest, TwoFreeBodiesShowTheExactRestitution) {
  const model::Model model(
      {testing::single_mass("a", 0.05, 0, 0), testing::single_mass("b", 0.12, 0, 0)});
  for (const std::string &relation : restitution_relations())
    for (const double e : {0.15, 0.5, 0.85}) {
      const double damping = dimensionless_damping(relation, e);
      const ContactSet contacts(
          {testing::contact_along_x(model, "a.head", "b.head", 1e-4,
                                    HuntCrossley::with_dimensionless_damping(
                                        {.stiffness = 1.3e10, .exponent = 1.5}, damping, 1e-6))});
      motion::Trajectory trajectory(model, contacts, motion::Settings{});
      motion::ImpactLog log(contacts, 0);
      Vector velocity(2);
      velocity << 0.2, -0.1;
      trajectory.start(0, Vector::Zero(2), velocity);
      trajectory.advance(0.02, log);
      ASSERT_EQ(log.impacts(0).size(), 1u);
      const double shown = log.impacts(0)[0].restitution_coefficient();
      EXPECT_NEAR(shown, exact_restitution(damping), 1e-7) << relation << ' ' << e;
      if (relation == "exact") {
        EXPECT_NEAR(shown, e, 1e-7);
      }
    }
}

TEST(RestitutionRelationTest, RefusesWhatIsNoRestitution) {
  EXPECT_THROW(dimensionless_damping("exact", 0), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("exact", 1.01), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("exact", std::nan("")), std::invalid_argument);
  EXPECT_THROW(dimensionless_damping("guess", 0.5), std::invalid_argument);
}

} // namespace restitution_relation_tests
} // namespace vibroimpact::contact
