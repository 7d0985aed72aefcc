// Sections that say what another one says: what is taken over, what is their own, and what is
// refused.
#include "sample.h"

#include <gtest/gtest.h>

namespace vibroimpact::parameters {
namespace like_tests {

constexpr const char *bodies = R"(subsection Body left
  set Type = shell
  subsection Geometry
    set Elements = 7
    set Section  = wide
  end
  subsection Point head
    set Mass = 2 kg
  end
  subsection Point tail
    set Like = head
  end
end
subsection Body right
  set Like = left
  subsection Geometry
    set Elements = 9
  end
  subsection Point top
    set Like = tail
  end
end
)";

TEST(Like, takes_over_what_is_not_its_own) {
  const Values right = parse_prm(bodies)->root().instance("Body", "right");
  EXPECT_EQ(right.choice("Type"), "shell");
  EXPECT_EQ(right.subsection("Geometry").integer("Elements"), 9);
  EXPECT_EQ(right.subsection("Geometry").text("Section"), "wide");
  EXPECT_EQ(right.instances("Point"), (std::vector<std::string>{"head", "tail", "top"}));
  EXPECT_EQ(right.instance("Point", "top").quantity("Mass"), 2);
  EXPECT_TRUE(right.given("Type"));
}

TEST(Like, leaves_the_other_section_as_it_is) {
  const Values left = parse_prm(bodies)->root().instance("Body", "left");
  EXPECT_EQ(left.subsection("Geometry").integer("Elements"), 7);
  EXPECT_EQ(left.instances("Point"), (std::vector<std::string>{"head", "tail"}));
}

TEST(Like, goes_by_way_of_others_in_any_order) {
  const Values root = parse_prm("subsection Body c\n  set Like = b\nend\n"
                                "subsection Body b\n  set Like = a\n  set Type = lumped\nend\n"
                                "subsection Body a\n  set Type = shell\n  subsection Geometry\n    "
                                "set Elements = 3\n  end\nend\n")
                          ->root();
  EXPECT_EQ(root.instance("Body", "c").choice("Type"), "lumped");
  EXPECT_EQ(root.instance("Body", "c").subsection("Geometry").integer("Elements"), 3);
  EXPECT_EQ(root.instances("Body"), (std::vector<std::string>{"c", "b", "a"}));
}

TEST(Like, says_the_same_as_the_section_written_out) {
  const auto written = parse_prm(R"(subsection Body left
  set Type = shell
end
subsection Body right
  set Type = shell
end
)");
  const auto like = parse_prm(R"(subsection Body left
  set Type = shell
end
subsection Body right
  set Like = left
end
)");
  EXPECT_EQ(like->echo(), written->echo());
  EXPECT_EQ(like->root().fingerprint(), written->root().fingerprint());
  EXPECT_EQ(parse_prm(like->echo())->echo(), like->echo());
}

TEST(Like, is_read_in_json) {
  const Values root =
      parse_json(R"({"Body a": {"Type": "shell"}, "Body b": {"Like": "a"}})")->root();
  EXPECT_EQ(root.instance("Body", "b").choice("Type"), "shell");
}

TEST(Like, messages_name_the_line_that_was_taken_over) {
  EXPECT_EQ(error_of([] {
              parse_prm("subsection Contact a\n  set Clearance = 5 mm\n  set Stiffness = 1 kN/m\n"
                        "end\nsubsection Contact b\n  set Like = a\n  set Clearance = 5 kg\nend\n");
            }),
            "params/beams.prm:7: Contact b / Clearance = 5 kg\n  '5 kg' is a mass [kg]; a length "
            "[m] is expected (greater than or equal to 0), for example 0 m.");
  EXPECT_EQ(parse_prm(bodies)->root().instance("Body", "right").place("Type"),
            "params/beams.prm:2: Body right / Type");
}

struct Case {
  const char *name;
  const char *text;
  const char *message; ///< behind "params/beams.prm:"
};

void PrintTo(const Case &broken, std::ostream *out) { *out << broken.name; }

class LikeTable : public ::testing::TestWithParam<Case> {};

TEST_P(LikeTable, is_refused_with_place_and_reason) {
  EXPECT_EQ(error_of([] { parse_prm(GetParam().text); }),
            std::string("params/beams.prm:") + GetParam().message);
}

const std::vector<Case> refused{
    {"unknown", "subsection Body left\nend\nsubsection Body b\n  set Like = lefft\nend\n",
     "4: Body b / Like = lefft\n  there is no 'Body lefft' beside 'Body b'; did you mean 'left'?"},
    {"nothing_there", "subsection Body b\n  set Like = a\nend\n",
     "2: Body b / Like = a\n  there is no 'Body a' beside 'Body b'."},
    {"of_another_kind", "subsection Contact a\nend\nsubsection Body b\n  set Like = a\nend\n",
     "4: Body b / Like = a\n  there is no 'Body a' beside 'Body b'."},
    {"itself", "subsection Body a\n  set Like = a\nend\n",
     "2: Body a / Like = a\n  the section is like itself: Body a -> Body a."},
    {"circle", "subsection Body a\n  set Like = b\nend\nsubsection Body b\n  set Like = a\nend\n",
     "2: Body a / Like = b\n  the section is like itself: Body a -> Body b -> Body a."},
    {"twice", "subsection Body a\nend\nsubsection Body b\n  set Like = a\n  set Like = a\nend\n",
     "4: Body b / Like = a\n  this key is set twice."},
    {"in_a_section_without_a_name", "subsection Excitation\n  set Like = a\nend\n",
     "2: Excitation / Like = a\n  Like must only be set in the file, in a section with a name of "
     "its own: subsection KIND NAME."},
    {"a_key_twice_beside_it",
     "subsection Body a\nend\nsubsection Body b\n  set Like = a\n  set Type = shell\n  set Type = "
     "shell\nend\n",
     "6: Body b / Type = shell\n  this key is set twice; first at params/beams.prm:5."},
};
INSTANTIATE_TEST_SUITE_P(Refused, LikeTable, ::testing::ValuesIn(refused),
                         [](const auto &info) { return std::string(info.param.name); });

TEST(Like, is_no_key_that_an_override_could_change) {
  EXPECT_EQ(error_of([] {
              parse_prm(bodies, {{"Body/right/Like", "head", "--set"}});
            }),
            "--set Body/right/Like=head\n  Like must only be set in the file, in a section with a "
            "name of its own: subsection KIND NAME.");
}

} // namespace like_tests
} // namespace vibroimpact::parameters
