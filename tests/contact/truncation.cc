// The error of an impact by the modes that are left out, known before any motion.
#include "contact/truncation.h"
#include "common/decompositions.h"
#include "contact/attachment_damping.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "contact/laws/tsuji.h"
#include "reduction/beam_bodies.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::contact {
namespace truncation_tests {

using namespace reduction;
using examples::BeamDefinition;
using examples::cantilever;
using examples::tuned_cantilever;
using model::Model;

std::shared_ptr<const ReducedBody> kept(const BeamDefinition &beam, int number,
                                        const std::string &name, bool attached = false) {
  BodyDefinition definition = examples::body_of(beam, number);
  definition.name = name;
  if (attached)
    definition.attachments = {{"head", 0}};
  return std::make_shared<ReducedBody>(reduce(definition, MPI_COMM_WORLD));
}

ContactFigures figures_of(const Model &model, std::shared_ptr<const ContactLaw> law,
                          const std::string &side_a, const std::string &side_b = "") {
  ContactPair pair = testing::contact_along_x(model, side_a, side_b, 0, std::move(law));
  pair.normal = Vector3::UnitX();
  pair.largest_impact_error = 0.05;
  pair.least_flexibility_share = 0.9;
  return contact_figures(ContactSet({pair}), model)[0];
}

double error_of(const Model &model, std::shared_ptr<const ContactLaw> law,
                const std::string &side_a, const std::string &side_b = "") {
  return figures_of(model, std::move(law), side_a, side_b).impact_error;
}

std::shared_ptr<const ContactLaw> hertz(double exponent = 1.5) {
  return std::make_shared<Hertz>(HertzConstants{.stiffness = 1.3e10, .exponent = exponent});
}

constexpr double very_stiff = 1e15; // a spring that no mode is fast against

/// Mass with which the end of a long row of Hermite elements of mass 1 and length 1 answers an
/// impulse: each element condenses what lies before it.
double end_of_row() {
  Eigen::Matrix4d mass;
  mass << 156, 22, 54, -13, 22, 4, 13, -3, 54, 13, 156, -22, -13, -3, -22, 4;
  mass /= 420;
  Eigen::Matrix2d end = Eigen::Matrix2d::Zero();
  for (int element = 0; element < 40; ++element)
    end = (mass.bottomRightCorner<2, 2>() - mass.bottomLeftCorner<2, 2>() *
                                                (mass.topLeftCorner<2, 2>() + end).inverse() *
                                                mass.topRightCorner<2, 2>())
              .eval();
  return 1 / end.inverse()(0, 0);
}

// Normal modes may be undamped, attachment modes not.
TEST(Truncation, UndampedAttachmentModesAreNamedWithTheirRatio) {
  const auto warning_of = [](bool attached, std::optional<double> ratio) {
    BodyDefinition definition = examples::body_of(cantilever(8, 0.02), 3);
    definition.name = "beam";
    if (attached)
      definition.attachments = {{"head", 0}};
    definition.damping = {.ratios = {0.01}, .attachment_ratio = ratio};
    const Model model({std::make_shared<ReducedBody>(reduce(definition, MPI_COMM_WORLD))});
    ContactPair pair = testing::contact_along_x(model, "beam.head", "", 0, hertz());
    pair.normal = Vector3::UnitX();
    std::set<std::string> known;
    return attachment_damping_warning(ContactSet({pair}), model, known);
  };
  EXPECT_NE(warning_of(true, {}).find("damping ratio of 0.01:"), std::string::npos);
  EXPECT_NE(warning_of(true, 0.0).find("damping ratio of 0:"), std::string::npos);
  EXPECT_EQ(warning_of(true, 0.05), "");
  EXPECT_EQ(warning_of(false, {}), "");
}

// What it cannot be compared with is said.
TEST(Truncation, WhyTheErrorIsNotKnown) {
  ReducedBody body = *kept(cantilever(8, 0.02), 3, "beam");
  EXPECT_EQ(figures_of(Model({std::make_shared<ReducedBody>(body)}), hertz(), "beam.head")
                .no_impact_error,
            "");
  for (BodyPoint &point : body.points)
    point.inverse_mass = Matrix();
  const ContactFigures singular =
      figures_of(Model({std::make_shared<ReducedBody>(body)}), hertz(), "beam.head");
  EXPECT_TRUE(std::isnan(singular.impact_error));
  EXPECT_TRUE(singular.no_impact_error.starts_with("the mass matrix is singular"));
  body.type = "modes";
  EXPECT_TRUE(figures_of(Model({std::make_shared<ReducedBody>(body)}), hertz(), "beam.head")
                  .no_impact_error.starts_with("the given modes do not say"));
}

// The two beams of case S: 1/m_N in units of 1/(rho A L), from the series over closed-form modes,
// and the limit, 1 over the tip mass and the little that the mesh adds to it.
TEST(Truncation, CaseSHasTheErrorOfTheClosedForm) {
  constexpr int elements = 200;
  const BeamDefinition beam = tuned_cantilever(elements);
  const double limit = 1 / (1.089150276093259 + end_of_row() / elements);
  EXPECT_NEAR(1 / (1 / limit - end_of_row() / elements), 0.9181469, 1e-7);
  for (const auto &[number, inverse] :
       std::vector<std::pair<int, double>>{{1, 0.7533998}, {5, 0.8834526}, {10, 0.9009090}}) {
    const Model model({kept(beam, number, "left"), kept(beam, number, "right")});
    const double ratio = limit / inverse;
    EXPECT_NEAR(error_of(model, hertz(), "left.head", "right.head"), std::pow(ratio, 0.6) - 1,
                1e-6);
    EXPECT_NEAR(
        error_of(model, std::make_shared<NewtonRestitution>(0.5), "left.head", "right.head"),
        ratio - 1, 1e-6);
    EXPECT_NEAR(
        error_of(model, std::make_shared<LinearPenalty>(very_stiff), "left.head", "right.head"),
        std::sqrt(ratio) - 1, 1e-6);
  }
}

TEST(Truncation, TheExponentIsThatOfTheLaw) {
  const Model model({kept(cantilever(8, 0.02), 2, "left")});
  const auto error = [&](std::shared_ptr<const ContactLaw> law) {
    return error_of(model, std::move(law), "left.head");
  };
  const double ratio = 1 + error(std::make_shared<NewtonRestitution>(1));
  EXPECT_GT(ratio, 1.05);
  const auto power = [&](double value) { return std::log(1 + value) / std::log(ratio); };
  EXPECT_NEAR(power(error(hertz(2.2))), 2.2 / 3.2, 1e-12);
  EXPECT_NEAR(power(error(HuntCrossley::with_dissipation({1e9, 1.5}, 0.3))), 0.6, 1e-12);
  EXPECT_NEAR(power(error(std::make_shared<Tsuji>(1e9, 3.0))), 0.6, 1e-12);
  EXPECT_NEAR(power(error(std::make_shared<KuwabaraKono>(1e9, 1e-6))), 0.6, 1e-12);
  EXPECT_NEAR(power(error(std::make_shared<LinearPenalty>(very_stiff))), 0.5, 1e-4);
  EXPECT_NEAR(power(error(std::make_shared<KelvinVoigt>(very_stiff, 3.0))), 0.5, 1e-4);
  EXPECT_NEAR(power(error(std::make_shared<KelvinVoigtBumper>(very_stiff, 3.0))), 0.5, 1e-4);
  EXPECT_NEAR(power(error(std::make_shared<BilinearStop>(very_stiff, 3.0))), 0.5, 1e-4);
  EXPECT_TRUE(std::isnan(error(std::make_shared<BilinearStop>(0, 3.0)))) << "no elastic force";
}

TEST(Truncation, LumpedBodiesLackNothing) {
  const Model model(
      {testing::single_mass("a", 0.05, 1e3, 0), testing::single_mass("b", 0.1, 0, 0)});
  for (const auto &law :
       {hertz(), std::shared_ptr<const ContactLaw>(std::make_shared<LinearPenalty>(1e5))}) {
    EXPECT_EQ(error_of(model, law, "a.head", "b.head"), 0);
    EXPECT_EQ(error_of(model, law, "a.head"), 0);
  }
  EXPECT_EQ(figures_of(model, hertz(), "a.head").shortest_period, 0);
}

// Against a mass that gives way as well a beam's part of the inverse mass counts less.
TEST(Truncation, BothSidesCount) {
  constexpr double mass = 0.01;
  const BeamDefinition beam = cantilever(6, 0.02);
  const Model model({kept(beam, 2, "left"), testing::single_mass("ball", mass, 0, 0)});
  const ReducedBody &body = *model.bodies()[0];
  const BodyPoint &head = body.point("head");
  const double kept_inverse = head.rows.row(0).squaredNorm();
  const double whole = head.inverse_mass(0, 0);
  const auto rigid = std::make_shared<NewtonRestitution>(0.3);
  EXPECT_NEAR(error_of(model, rigid, "left.head"), whole / kept_inverse - 1, 1e-12);
  EXPECT_NEAR(error_of(model, rigid, "left.head", "ball.head"),
              (whole + 1 / mass) / (kept_inverse + 1 / mass) - 1, 1e-12);
}

// A free beam has no static flexibility; the mass that it meets an impact with is known all the
// same. When all its modes are kept nothing is missing.
TEST(Truncation, FreeBodies) {
  BeamDefinition beam = cantilever(4);
  beam.supports.pop_back();
  const auto rigid = std::make_shared<NewtonRestitution>(0.3);
  const auto spring = std::make_shared<LinearPenalty>(1e4);
  double before = std::numeric_limits<double>::infinity();
  for (const int number : {2, 4, 7}) {
    const Model model({kept(beam, number, "left")});
    const ContactFigures figures = figures_of(model, spring, "left.head");
    EXPECT_TRUE(std::isnan(figures.flexibility_share));
    EXPECT_GT(figures.impact_error, 0);
    EXPECT_LT(figures.impact_error, std::min(before, error_of(model, rigid, "left.head")));
    before = figures.impact_error;
  }
  EXPECT_NEAR(error_of(Model({kept(beam, 10, "left")}), rigid, "left.head"), 0, 1e-8);
}

/// Peak force of the first contact with a spring, from the first mode at speed v, in the given
/// modes: while they touch the motion is linear, M q'' + (K + k w'w) q = 0.
double peak_force(const Vector &stiffness, const RowVector &row, double spring) {
  Matrix coupled = stiffness.asDiagonal();
  coupled += spring * row.transpose() * row;
  const SymmetricEigen solved = symmetric_eigen(coupled);
  const Vector omega = solved.values.cwiseMax(0.0).cwiseSqrt();
  Vector start = Vector::Zero(stiffness.size());
  start[0] = 1 / row[0];
  const Vector amplitude = (solved.vectors.transpose() * start)
                               .cwiseProduct(solved.vectors.transpose() * row.transpose())
                               .cwiseQuotient(omega);
  const double end = 10 / std::sqrt(spring * row[0] * row[0] + stiffness[0]);
  double peak = 0;
  constexpr int steps = 4000;
  for (int i = 1; i <= steps; ++i) {
    const double displacement = amplitude.dot((omega * (end * i / steps)).array().sin().matrix());
    if (displacement < 0)
      break;
    peak = std::max(peak, spring * displacement);
  }
  return peak;
}

// A cantilever meets a spring. Its stiffness goes from one that is soft against the modes that are
// left out, where only the static flexibility counts, to one that is stiff against all of them.
// The errors of the peak force in between are those of one oscillator in the place of many.
TEST(Truncation, SpringErrorIsThatOfTheImpact) {
  constexpr int elements = 12;
  int compared = 0;
  for (const double lumped : {0.0577, 0.0}) {
    const BeamDefinition beam = cantilever(elements, lumped);
    const auto all = kept(beam, 2 * elements, "left");
    for (const int number : {1, 2, 3, 5})
      for (const double spring : {1e2, 1e3, 1e4, 1e5, 1e7, 1e10}) {
        const Model model({kept(beam, number, "left")});
        const double expected =
            error_of(model, std::make_shared<LinearPenalty>(spring), "left.head");
        const double truth =
            peak_force(all->stiffness.head(number), all->point("head").rows.row(0).head(number),
                       spring) /
                peak_force(all->stiffness, all->point("head").rows.row(0), spring) -
            1;
        if (truth < 0.01)
          EXPECT_LT(expected, 0.02) << number << " " << spring << " " << truth;
        else if (truth < 0.15 || spring == 1e10) {
          EXPECT_LT(expected, 3 * truth) << number << " " << spring;
          EXPECT_GT(expected, 0.8 * truth) << number << " " << spring;
          ++compared;
        }
      }
  }
  EXPECT_GT(compared, 15);
}

// Without a lumped mass m_inf falls with the size of the elements; against a spring that is soft
// for the modes left out this does not matter.
TEST(Truncation, SoftSpringsDoNotSeeTheMesh) {
  std::vector<double> soft;
  std::vector<double> stiff;
  for (const int elements : {10, 40}) {
    const Model model({kept(cantilever(elements), 5, "left")});
    soft.push_back(error_of(model, std::make_shared<LinearPenalty>(1e3), "left.head"));
    stiff.push_back(error_of(model, std::make_shared<LinearPenalty>(very_stiff), "left.head"));
  }
  EXPECT_GT(soft[0], 1e-3);
  EXPECT_NEAR(soft[1] / soft[0], 1, 0.1);
  EXPECT_NEAR((stiff[1] + 1) / (stiff[0] + 1), 2, 0.01) << "m_inf is that of one element";
}

// With an attachment mode nothing of the flexibility is missing, but the inertia of the others is.
TEST(Truncation, AttachmentsAnswerSlowImpacts) {
  const BeamDefinition beam = cantilever(20, 0.02);
  const Model without({kept(beam, 3, "left")});
  const Model with({kept(beam, 3, "left", true)});
  const auto soft = std::make_shared<LinearPenalty>(3e3);
  EXPECT_NEAR(figures_of(with, soft, "left.head").flexibility_share, 1, 1e-9);
  EXPECT_LT(error_of(with, soft, "left.head"), 0.1 * error_of(without, soft, "left.head"));
  EXPECT_GT(error_of(with, soft, "left.head"), 0);
  const auto rigid = std::make_shared<NewtonRestitution>(0.3);
  EXPECT_LT(error_of(with, rigid, "left.head"), error_of(without, rigid, "left.head"));
  EXPECT_GT(error_of(with, rigid, "left.head"), 0.01);
}

TEST(Truncation, ShortestPeriodIsThatOfTheLastMode) {
  const auto body = kept(cantilever(8), 3, "left");
  const Model model({body, testing::single_mass("ball", 1, 1e9, 0)});
  EXPECT_NEAR(figures_of(model, hertz(), "left.head", "ball.head").shortest_period,
              2 * M_PI / body->omega()[2], 1e-12);
}

TEST(Truncation, WarningsNameTheContactsAndTheirErrors) {
  ContactFigures bad{.name = "heads", .impact_error = 0.12601, .largest_error = 0.05};
  ContactFigures good{.name = "tails", .impact_error = 0.049, .largest_error = 0.05};
  ContactFigures unknown{.name = "rest", .impact_error = std::nan(""), .largest_error = 0.05};
  const std::string warning = impact_warning({good, bad, unknown});
  EXPECT_NE(warning.find("heads (12.7 %)"), std::string::npos) << warning;
  EXPECT_EQ(warning.find("tails"), std::string::npos) << warning;
  EXPECT_EQ(warning.find("rest"), std::string::npos) << warning;
  EXPECT_EQ(impact_warning({good, unknown}), "");
}

} // namespace truncation_tests
} // namespace vibroimpact::contact
