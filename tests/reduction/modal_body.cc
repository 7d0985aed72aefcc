// Bodies that are given by their modes, against the closed form of a rod.
#include "reduction/modal_body.h"

#include "reduction/known_flexibility.h"
#include "structure/beam_definition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace modal_body_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;

namespace {

constexpr double pi = std::numbers::pi;

/// A rod of unit length, stiffness EA and mass, held at one end; its free end moves along x:
/// omega_j = (2 j - 1) pi / 2, and all shapes are sqrt(2) there.
ModalData rod(Index n) {
  ModalData data{.frequency = Vector(n)};
  for (Index j = 0; j < n; ++j)
    data.frequency[j] = (2.0 * static_cast<double>(j) + 1) * pi / 2;
  data.damping_ratio = Vector::Zero(n);
  BodyPoint end{.name = "end", .position = Vector3::Zero(), .rows = Matrix::Zero(6, n)};
  end.rows.row(0).setConstant(std::numbers::sqrt2);
  data.points.push_back(end);
  return data;
}

ModalDefinition unit_masses() {
  return {.file = "", .normalisation = ModalDefinition::Normalisation::unit_mass};
}

/// Displacement of the end per harmonic force there.
double receptance(const ReducedBody &body, double omega) {
  double sum = 0;
  for (Index j = 0; j < body.size(); ++j)
    sum += std::pow(body.points[0].rows(0, j), 2) / (body.stiffness[j] - omega * omega);
  return sum;
}

std::string message_of(const ModalDefinition &definition, ModalData data) {
  try {
    modal_body("rod", definition, std::move(data));
  } catch (const structure::DefinitionError &error) {
    return error.what();
  }
  return "";
}

void expect_in(const std::string &message, const std::string &part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

} // namespace

TEST(ModalBody, EveryNormalisationIsTheSameBody) {
  const ReducedBody body = modal_body("rod", unit_masses(), rod(3));
  ModalData scaled = rod(3);
  scaled.mass = Eigen::Vector3d(4, 0.25, 9);
  scaled.points[0].rows *= scaled.mass.cwiseSqrt().asDiagonal();
  const ReducedBody general = modal_body("rod", {.file = ""}, scaled);
  EXPECT_LT((general.points[0].rows - body.points[0].rows).norm(), 1e-15);
  ModalData largest = rod(3);
  largest.points[0].rows.row(0).setOnes();
  largest.mass = Vector::Constant(3, 0.5);
  ModalDefinition definition = unit_masses();
  definition.normalisation = ModalDefinition::Normalisation::largest_component;
  const ReducedBody unit = modal_body("rod", definition, largest);
  EXPECT_LT((unit.points[0].rows - body.points[0].rows).norm(), 1e-15);
  EXPECT_EQ(body.mass, Vector(Vector::Ones(3)));
  EXPECT_NEAR(body.omega()[2], 2.5 * pi, 1e-14);
}

TEST(ModalBody, ANormalisationThatTheDataContradictIsRefused) {
  ModalData data = rod(2);
  expect_in(message_of({.file = ""}, data), "must be unit modal mass when the file gives no");
  data.mass = Eigen::Vector2d(1, 2);
  expect_in(message_of(unit_masses(), data), "that of mode 2 is 2 kg");
  ModalDefinition definition = unit_masses();
  definition.normalisation = ModalDefinition::Normalisation::largest_component;
  expect_in(message_of(definition, data), "the largest displacement of mode 1 is 1.41421");
}

TEST(ModalBody, DampingAndFirstModesAreTaken) {
  ModalDefinition definition = unit_masses();
  definition.number = 2;
  ModalData data = rod(4);
  data.damping_ratio = Vector::Constant(4, 0.03);
  const ReducedBody body = modal_body("rod", definition, data);
  ASSERT_EQ(body.size(), 2);
  EXPECT_NEAR(body.damping_ratio()[1], 0.03, 1e-15);
  definition.number = 5;
  expect_in(message_of(definition, data), "must not exceed the number of modes in the file, 4");
  data.damping_ratio.resize(0);
  definition.number = 0;
  expect_in(message_of(definition, data), "Damping ratio must be set");
  definition.damping_ratios = {0.01, 0.02};
  EXPECT_NEAR(modal_body("rod", definition, data).damping_ratio()[3], 0.02, 1e-15);
}

// The static flexibility of the rod is 1, that of n modes 2 sum 1/omega_j^2.
TEST(ModalBody, AStaticTestTellsWhatTheModesLack) {
  ModalDefinition definition = unit_masses();
  definition.points = {{.name = "end", .static_stiffness = Vector3(1, 0, 0)}};
  const ReducedBody body = modal_body("rod", definition, rod(2));
  const double kept = 8 / (pi * pi) * (1 + 1.0 / 9);
  EXPECT_NEAR(body.flexibility_share(body.points[0], Vector3::UnitX()), kept, 1e-14);
  EXPECT_TRUE(std::isnan(flexibility_along(body.points[0], Vector3::UnitY())));
  EXPECT_TRUE(std::isnan(flexibility_along(body.points[0], Vector3(1, 1, 0))));
  definition.points[0].static_stiffness = Vector3(1.2, 0, 0);
  expect_in(message_of(definition, rod(2)), "must not be greater along x than 1.11");
}

// Against tan(omega) / omega. Without mass the residual would have an error of the order
// (omega / omega_N)^2; that of the second order is right but for the boundary of the sum.
TEST(ModalBody, ResidualModesMendTheRod) {
  const Index n = 6;
  ModalDefinition definition = unit_masses();
  definition.points = {{.name = "end", .static_stiffness = Vector3(1, 0, 0)}};
  definition.attachments = {{"end", 0}};
  const ReducedBody plain = modal_body("rod", unit_masses(), rod(n));
  const ReducedBody mended = modal_body("rod", definition, rod(n));
  ASSERT_EQ(mended.size(), n + 1);
  EXPECT_NEAR(mended.flexibility_share(mended.points[0], Vector3::UnitX()), 1, 1e-14);
  EXPECT_NEAR(mended.omega()[n], std::sqrt(3.0) * plain.omega()[n - 1], 1e-12);
  const double lacking = 1 - kept_flexibility(plain, plain.points[0].rows.row(0));
  for (const double share : {0.1, 0.3, 0.5}) {
    const double omega = share * plain.omega()[n - 1];
    const double exact = std::tan(omega) / omega;
    const double without_mass = std::abs(receptance(plain, omega) + lacking - exact);
    EXPECT_LT(std::abs(receptance(plain, omega) - exact), 2 * lacking);
    EXPECT_LT(std::abs(receptance(mended, omega) - exact), 0.3 * without_mass) << share;
  }
}

TEST(ModalBody, AGivenResidualFlexibilityAndFrequencyAreTaken) {
  ModalDefinition definition = unit_masses();
  definition.points = {{.name = "end", .residual_flexibility = Vector3(0.02, 0, 0.1)}};
  definition.attachments = {{"end", 0}, {"end", 2}, {"end", 1}};
  definition.residual_frequency = 100;
  definition.residual_damping_ratio = 0.25;
  const ReducedBody body = modal_body("rod", definition, rod(2));
  ASSERT_EQ(body.size(), 4); // nothing is lacking along y
  EXPECT_NEAR(body.damping_ratio()[3], 0.25, 1e-14);
  EXPECT_NEAR(body.omega()[3], 100, 1e-12);
  EXPECT_NEAR(flexibility_along(body.points[0], Vector3::UnitZ()), 0.1, 1e-15);
  EXPECT_NEAR(kept_flexibility(body, body.points[0].rows.row(2)), 0.1, 1e-15);
  definition.residual_frequency = 3;
  expect_in(message_of(definition, rod(2)), "must be greater than the highest frequency");
}

TEST(ModalBody, AttachmentsNeedAKnownFlexibility) {
  ModalDefinition definition = unit_masses();
  definition.attachments = {{"end", 0}};
  expect_in(message_of(definition, rod(2)), "that of end.x is not");
  definition.attachments = {{"tip", 0}};
  expect_in(message_of(definition, rod(2)), "it has no point tip");
}

TEST(ModalBody, LinesMakeNodesOfThePoints) {
  ModalData data = rod(2);
  data.points.push_back({.name = "root", .position = Vector3::Zero(), .rows = Matrix::Zero(6, 2)});
  ModalDefinition definition = unit_masses();
  definition.points = {{.name = "end", .position = Vector3(1, 0, 0)}};
  definition.lines = {{"root", "end"}};
  const ReducedBody body = modal_body("rod", definition, data);
  ASSERT_EQ(body.recovery.lines.size(), 1U);
  EXPECT_EQ(body.recovery.shapes.rows(), 12);
  EXPECT_EQ(body.points[0].node, 0);
  definition.lines = {{"root", "ende"}};
  expect_in(message_of(definition, data), "did you mean 'end'?");
  definition.lines = {{"root", "end"}};
  definition.points.clear();
  expect_in(message_of(definition, data), "have the same Position");
}

namespace {

std::string text_message(const std::string &text) {
  try {
    read_modal_text(text, unit_masses());
  } catch (const structure::DefinitionError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(ModalBody, ATableIsRead) {
  const ModalData data = read_modal_text("# a test\nmode;frequency;damping ratio;pad.2.z;pad.2.ry\n"
                                         "1; 10 ;0.01;2;3\n2;20;0.02;-1;4\n",
                                         {.file = "", .separator = "semicolon"});
  ASSERT_EQ(data.size(), 2);
  EXPECT_NEAR(data.frequency[1], 40 * pi, 1e-13);
  EXPECT_EQ(data.damping_ratio[0], 0.01);
  ASSERT_EQ(data.points.size(), 1U);
  EXPECT_EQ(data.points[0].name, "pad.2");
  EXPECT_EQ(data.points[0].interface, "pad");
  EXPECT_EQ(data.points[0].rows(2, 1), -1);
  EXPECT_EQ(data.points[0].rows(4, 0), 3);
  EXPECT_EQ(data.mass.size(), 0);
}

TEST(ModalBody, ATableThatIsNoneIsRefused) {
  expect_in(text_message("frequenzy,tip.x\n1,1\n"), "did you mean 'frequency'?");
  expect_in(text_message("mode,tip.x\n1,1\n"), "must have a column frequency");
  expect_in(text_message("frequency\n1\n"), "must have a column POINT.x");
  expect_in(text_message("frequency,tip.x,tip.x\n1,1,1\n"), "'tip.x' twice");
  expect_in(text_message("frequency,tip.x\n1\n"), "line 2 has 1");
  expect_in(text_message("frequency,tip.x\n1,a\n"), "column 2 of line 2 has 'a'");
  expect_in(text_message("frequency,tip.x\n1,nan\n"), "column 2 of line 2 has 'nan'");
  expect_in(text_message("frequency,tip.x\n"), "at least one mode");
  expect_in(text_message(std::string("a\0b", 3)), "NUL");
  ModalData data = rod(2);
  data.frequency[1] = -1;
  expect_in(message_of(unit_masses(), data), "that of mode 2 is -1");
}

} // namespace modal_body_tests
