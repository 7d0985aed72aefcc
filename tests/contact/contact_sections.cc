// Which contacts sections make, of bodies made by hand: mirror images, and the effective mass of
// lumped sides.
#include "contact/contact_sections.h"
#include "contact/contact_set.h"

#include <gtest/gtest.h>

namespace vibroimpact::contact {
namespace contact_sections_tests {

using model::Model;
using reduction::ReducedBody;

/// A mass [kg] with the point "head", which moves along x and z.
std::shared_ptr<const ReducedBody> block(const std::string &name, double mass,
                                         const std::string &type = "lumped") {
  auto body = std::make_shared<ReducedBody>();
  body->name = name;
  body->type = type;
  body->mass = Vector::Constant(2, mass);
  body->stiffness = Vector::Constant(2, 1e4);
  body->damping = Matrix::Zero(2, 2);
  body->base_participation = Matrix::Zero(2, 3);
  Matrix rows = Matrix::Zero(6, 2);
  rows(0, 0) = 1;
  rows(2, 1) = 1;
  body->points.push_back({.name = "head", .rows = rows});
  return body;
}

std::shared_ptr<const parameters::ParameterSet> parsed(const std::string &text) {
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_contacts(*root);
  return parameters::ParameterSet::parse(root, text, "test.prm", false);
}

ContactSet contacts_of(const std::string &text, const std::vector<std::string> &names,
                       const std::string &type_of_second = "lumped") {
  const Model model({block("one", 2), block("two", 3, type_of_second)});
  return read_contacts(parsed(text)->root(), names, model);
}

const std::string penalty = "subsection Linear penalty\nset Stiffness = 3 kN/m\nend\n";

TEST(ContactSectionsTest, AMirrorImageFollowsItsContact) {
  const auto set =
      parsed("subsection Contact a\nset Mirrored as = b\nend\nsubsection Contact c\nend\n"
             "subsection Contact d\nset Mirrored as = e\nend\n");
  EXPECT_EQ(contact_names(set->root(), {"a", "c", "d"}),
            (std::vector<std::string>{"a", "b", "c", "d", "e"}));
  EXPECT_TRUE(contact_section(set->root(), "e").mirrored);
  EXPECT_FALSE(contact_section(set->root(), "d").mirrored);
  EXPECT_THROW(contact_section(set->root(), "f"), std::logic_error);
}

TEST(ContactSectionsTest, AMirrorImageHasTheOppositeNormalAndNothingElse) {
  const ContactSet set = contacts_of("subsection Contact a\nset Between = one.head, stop\n"
                                     "set Mirrored as = b\nset Clearance = 2 mm\n" +
                                         penalty + "end\n",
                                     {"b", "a"});
  ASSERT_EQ(set.size(), 2U);
  const ContactPair &mirrored = set.pairs()[0], &first = set.pairs()[1];
  EXPECT_EQ(mirrored.name, "b");
  EXPECT_EQ(mirrored.normal, -first.normal);
  EXPECT_EQ(mirrored.gap.row, -first.gap.row);
  EXPECT_EQ(mirrored.clearance, first.clearance);
  EXPECT_EQ(mirrored.side_b, first.side_b);
  for (const double component : mirrored.normal)
    EXPECT_FALSE(component == 0 && std::signbit(component)) << "as of a direction -x in the file";
}

double tsuji_resistance(const ContactSet &set) {
  LawResponse response;
  set.pairs().at(0).law->evaluate(1, {.gap = -1e-4, .gap_rate = -1}, response);
  return -response.force_by_gap_rate;
}

std::string tsuji(const std::string &between, const std::string &keys = "") {
  return "subsection Contact a\nset Between = " + between +
         "\nset Clearance = 0 m\nset Law = tsuji\nsubsection Tsuji\nset Stiffness = 1e10 N/m^1.5\n"
         "set Damping coefficient = 0.3\n" +
         keys + "end\nend\n";
}

// alpha sqrt(m k) u^(1/4), with m = 2 * 3 / 5 of two masses and m = 2 at a stop.
TEST(ContactSectionsTest, TheEffectiveMassOfLumpedSidesFollowsFromTheModel) {
  const double scale = 0.3 * std::sqrt(1e10) * std::sqrt(std::sqrt(1e-4));
  EXPECT_NEAR(tsuji_resistance(contacts_of(tsuji("one.head, two.head"), {"a"})),
              scale * std::sqrt(1.2), 1e-9 * scale);
  EXPECT_NEAR(tsuji_resistance(contacts_of(tsuji("one.head, stop"), {"a"})), scale * std::sqrt(2.0),
              1e-9 * scale);
}

TEST(ContactSectionsTest, AGivenEffectiveMassCounts) {
  const double scale = 0.3 * std::sqrt(1e10) * std::sqrt(std::sqrt(1e-4));
  const std::string text = tsuji("one.head, two.head", "set Effective mass = 7 kg\n");
  EXPECT_NEAR(tsuji_resistance(contacts_of(text, {"a"})), scale * std::sqrt(7.0), 1e-9 * scale);
}

TEST(ContactSectionsTest, TheEffectiveMassOfAFlexibleSideMustBeGiven) {
  EXPECT_THROW(contacts_of(tsuji("one.head, two.head"), {"a"}, "beam"), InputError);
  EXPECT_NO_THROW(contacts_of(tsuji("one.head, stop"), {"a"}, "beam"));
}

} // namespace contact_sections_tests
} // namespace vibroimpact::contact
