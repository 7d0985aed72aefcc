// Contact sections that stand for many contacts, on bodies made by hand.
#include "contact/contact_set.h"
#include "contact/truncation.h"

#include <gtest/gtest.h>

namespace vibroimpact::contact {
namespace contact_group_tests {

using model::Model;
using reduction::ReducedBody;

/// A body with one coordinate that moves its points along x; they stand in an interface.
std::shared_ptr<const ReducedBody> wall(const std::string &name,
                                        const std::vector<Vector3> &positions,
                                        double stiffness = 1e4, double flexibility = 2e-4) {
  auto body = std::make_shared<ReducedBody>();
  body->name = name;
  body->type = "shell";
  body->mass = Vector::Ones(1);
  body->stiffness = Vector::Constant(1, stiffness);
  body->damping = Matrix::Zero(1, 1);
  body->base_participation = Matrix::Zero(1, 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Matrix rows = Matrix::Zero(6, 1);
    rows(0, 0) = 1;
    body->points.push_back({.name = "face." + std::to_string(i + 1),
                            .position = positions[i],
                            .rows = rows,
                            .flexibility = flexibility * Matrix::Identity(3, 3),
                            .interface = "face",
                            .node = static_cast<int>(i)});
  }
  return body;
}

const std::vector<Vector3> left_face = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 5}};
const std::vector<Vector3> right_face = {{0.5, 0, 1.05}, {0.4, 0, 2}, {0.3, 0.02, 0}};

ContactSet contacts_of(const std::string &keys, double stiffness = 1e4) {
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_contacts(*root);
  const std::string text = "subsection Contact gap\n" + keys + "end\n";
  const auto set = parameters::ParameterSet::parse(root, text, "test.prm", false);
  const Model model({wall("left", left_face, stiffness), wall("right", right_face, stiffness)});
  return read_contacts(set->root(), {"gap"}, model);
}

const std::string penalty = "subsection Linear penalty\nset Stiffness = 3 kN/m\nend\n";

TEST(ContactGroupTest, ProximityTakesTheClearanceFromTheGeometry) {
  const ContactSet set =
      contacts_of("set Between = left.face, right.face\nset Pairing = proximity\n"
                  "set Search radius = 0.1 m\nset Offset = 50 mm\n" +
                  penalty);
  ASSERT_EQ(set.size(), 3U);
  const std::vector<std::string> partners = {"right.face.3", "right.face.1", "right.face.2"};
  const std::vector<double> clearances = {0.25, 0.45, 0.35};
  for (std::size_t c = 0; c < 3; ++c) {
    const ContactPair &pair = set.pairs()[c];
    EXPECT_EQ(pair.name, "gap." + std::to_string(c + 1));
    EXPECT_EQ(pair.side_a, "left.face." + std::to_string(c + 1));
    EXPECT_EQ(pair.side_b, partners[c]);
    EXPECT_NEAR(pair.clearance, clearances[c], 1e-15);
    EXPECT_EQ(pair.normal, Vector3::UnitX());
    EXPECT_EQ(pair.gap.row, RowVector(Eigen::RowVector2d(-1, 1)));
    EXPECT_EQ(pair.group, "gap");
  }
  ASSERT_EQ(set.groups().size(), 1U);
  EXPECT_EQ(set.groups()[0].count, 3U);
  EXPECT_EQ(set.groups()[0].unpaired, 1U) << "the node at 5 m faces nothing";
}

TEST(ContactGroupTest, PairsByTheirNumbers) {
  const ContactSet set = contacts_of("set Between = left.face, right.face\nset Pairing = list\n"
                                     "set Pairs = 3, 2, 1, 3, 1, 1\n" +
                                     penalty);
  ASSERT_EQ(set.size(), 3U);
  const std::vector<std::array<std::string, 2>> sides = {{"left.face.3", "right.face.2"},
                                                         {"left.face.1", "right.face.3"},
                                                         {"left.face.1", "right.face.1"}};
  const std::vector<double> clearances = {0.4, 0.3, 0.5};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(set.pairs()[c].side_a, sides[c][0]);
    EXPECT_EQ(set.pairs()[c].side_b, sides[c][1]);
    EXPECT_NEAR(set.pairs()[c].clearance, clearances[c], 1e-15);
  }
  EXPECT_EQ(set.groups()[0].unpaired, 2U) << "the nodes left.face.2 and left.face.4";
}

TEST(ContactGroupTest, TheJoiningLineIsTheNormal) {
  const ContactSet set =
      contacts_of("set Between = left.face, right.face\nset Pairing = proximity\n"
                  "set Normal = joining line\nset Search radius = 0.45 m\n" +
                  penalty);
  ASSERT_EQ(set.size(), 2U) << "0.5 m are too far";
  const Vector3 line = right_face[2] - left_face[0];
  EXPECT_NEAR((set.pairs()[0].normal - line / line.norm()).norm(), 0, 1e-15);
  EXPECT_NEAR(set.pairs()[0].clearance, line.norm(), 1e-15);
  EXPECT_NEAR(set.pairs()[0].gap.row[0], -0.3 / line.norm(), 1e-15);
}

TEST(ContactGroupTest, AGivenClearanceCountsForAll) {
  const ContactSet set =
      contacts_of("set Between = left.face, right.face\nset Pairing = proximity\n"
                  "set Search radius = 0.1 m\nset Clearance = 7 mm\n" +
                  penalty);
  for (const ContactPair &pair : set.pairs())
    EXPECT_EQ(pair.clearance, 0.007);
}

TEST(ContactGroupTest, EveryNodeHasItsStop) {
  const ContactSet set = contacts_of("set Between = right.face\nset Pairing = stops\n"
                                     "set Direction = -x\nset Clearance = 2 mm\n" +
                                     penalty);
  ASSERT_EQ(set.size(), 3U);
  for (const ContactPair &pair : set.pairs()) {
    EXPECT_EQ(pair.side_b, "stop");
    EXPECT_EQ(pair.clearance, 0.002);
    EXPECT_EQ(pair.gap.row, RowVector(Eigen::RowVector2d(0, 1)));
  }
}

TEST(ContactGroupTest, NodesThatCannotMoveAreLeftOut) {
  const std::string along_y = "set Between = right.face\nset Pairing = stops\nset Direction = y\n"
                              "set Clearance = 2 mm\n" +
                              penalty;
  EXPECT_THROW(contacts_of(along_y), InputError);
}

TEST(ContactGroupTest, StiffnessIsAMultipleOfTheLocalOne) {
  const std::string between = "set Between = left.face, right.face\nset Pairing = proximity\n"
                              "set Search radius = 0.1 m\n";
  const ContactSet set = contacts_of(between + "set Stiffness fraction = 3\n");
  LawResponse response;
  set.pairs()[0].law->evaluate(1, {.gap = -1}, response);
  // Both sides give way by 2e-4 m/N.
  EXPECT_NEAR(response.force, 3 / 4e-4, 1e-9);
}

TEST(ContactGroupTest, ShareOfTheFlexibility) {
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_contacts(*root);
  const auto set = parameters::ParameterSet::parse(
      root,
      "subsection Contact gap\nset Between = left.face, right.face\nset Pairing = proximity\n"
      "set Search radius = 0.1 m\n" +
          penalty + "end\n",
      "test.prm", false);
  // The kept coordinate gives way by 1e-4 of 2e-4 m/N on one side, by 2e-4 of 2e-4 on the other.
  const Model model({wall("left", left_face, 1e4), wall("right", right_face, 5e3)});
  const auto figures = contact_figures(read_contacts(set->root(), {"gap"}, model), model);
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_NEAR(figures[0].flexibility_share, 0.75, 1e-14);
  EXPECT_EQ(figures[0].least_share, 0.9);
  const std::string warning = flexibility_warning(figures);
  EXPECT_NE(warning.find("gap.1 (75 %)"), std::string::npos) << warning;
  EXPECT_NE(warning.find("gap.3 (75 %)"), std::string::npos) << warning;
}

TEST(ContactGroupTest, NoWarningAboveTheThreshold) {
  EXPECT_EQ(flexibility_warning({{"a", 0, 0.91, 0.9}, {"b", 0, std::nan(""), 0.9}}), "");
}

} // namespace contact_group_tests
} // namespace vibroimpact::contact
