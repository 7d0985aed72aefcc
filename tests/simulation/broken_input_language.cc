// Tables of cases, values of one analysis, mirrored contacts and effective masses that cannot be
// used as given: the whole message.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_language_tests {

using testing::changed;
using testing::message_of;

const std::string file = R"(set Variables = k = 2 kN/m, gap = 1 mm
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 1 kN/m
  end
end
subsection Contact right
  set Between = block.head, stop
  set Mirrored as = left
  set Clearance = gap
  subsection Linear penalty
    set Stiffness = k
  end
end
subsection Contact top
  set Between = block.head, stop
  set Clearance = 1 m
  subsection Linear penalty
    set Stiffness = k
  end
end
subsection Analysis motion
  set Type = transient
  set With = Variables/gap = 2 mm
  subsection Transient
    set Duration = 1 s
  end
end
subsection Analysis cases
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = motion
    set Cases = Variables/k [kN/m], Contact/top/Clearance; 1, 2 m; 3, 4 m
  end
end
)";

struct Broken {
  const char *from, *to;
  const char *message; ///< behind "test.prm:"
};

class BrokenInputLanguageTable : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenInputLanguageTable, IsRefusedWithPlaceAndReason) {
  EXPECT_EQ(message_of(changed(file, GetParam().from, GetParam().to)),
            std::string("test.prm:") + GetParam().message);
}

constexpr const char *with = "Variables/gap = 2 mm";
constexpr const char *cases = "Variables/k [kN/m], Contact/top/Clearance; 1, 2 m; 3, 4 m";

const std::vector<Broken> refused{
    {"set Variables = k = 2 kN/m, gap = 1 mm",
     "set Units = dimensionless\nset Variables = k = 2 kN/m, gap = 1 mm",
     "2: Variables = k = 2 kN/m\n  '2 kN/m' must not have a unit when Units = dimensionless."},
    {"set Variables = k = 2 kN/m, gap = 1 mm",
     "set Units = plain\nset Variables = k = 2 kN/m, gap = 1 mm",
     "1: Units = plain\n  'plain' is not possible; one of these is expected: SI, dimensionless."},
    {"set With = Variables/gap = 2 mm", "set With = Units = dimensionless",
     "26: Analysis motion / With = Units = dimensionless\n  With must not set Units."},
    {with, "gap",
     "26: Analysis motion / With = gap\n  With must be PATH = VALUE, separated by "
     "commas: Variables/gap = 0.7 mm, Integration/Relative tolerance = 1e-10."},
    {with, "Variables/gip = 2",
     "26: Analysis motion / With = Variables/gip = 2\n  Variables/gip: there is no variable 'gip'; "
     "did you mean 'gap'?."},
    {with, "Analysis/motion/Type = modal",
     "26: Analysis motion / With = Analysis/motion/Type = modal\n  With must not set Analysis "
     "motion/Type."},
    {with, "Variables/gap = 1 mm, Variables/gap = 2 mm",
     "26: Analysis motion / With = Variables/gap = 1 mm, Variables/gap = 2 mm\n  With must not set "
     "Variables/gap twice."},
    {with, "Contact/top/Clearance = 2 kg",
     "26: Analysis motion / With: Contact top/Clearance=2 kg\n  '2 kg' is a mass [kg]; a length "
     "[m] is expected, for example 5 mm."},
    {cases, "Variables/gap; 1 mm",
     "35: Analysis cases / Parameter grid / Cases = Variables/gap; 1 mm\n  Cases must not name a "
     "key that another Key of this grid or the key With of an analysis changes."},
    {cases, "Variables/k [N/m]",
     "35: Analysis cases / Parameter grid / Cases = Variables/k [N/m]\n  Cases must have a row of "
     "keys and at least one row of values, separated by ';', or be the name of a .csv file."},
    {cases, "Variables/k, Contact/top/Clearance; 1, 2; 3",
     "35: Analysis cases / Parameter grid / Cases = Variables/k, Contact/top/Clearance; 1, 2; 3\n  "
     "row 2 must have 2 values, one for each key, but has 1 value."},
    {cases, "Variables/k, Contact/top/Clearance; 1, ; 3, 4",
     "35: Analysis cases / Parameter grid / Cases = Variables/k, Contact/top/Clearance; 1, ; 3, "
     "4\n  row 1 must have a value for Contact/top/Clearance, but has none."},
    {cases, "Variables/k [N/m; 1",
     "35: Analysis cases / Parameter grid / Cases = Variables/k [N/m; 1\n  the head of a column "
     "must be PATH or PATH [UNIT], but is 'Variables/k [N/m'."},
    {cases, "Variables/c; 1",
     "35: Analysis cases / Parameter grid / Cases = Variables/c; 1\n  Variables/c: there is no "
     "variable 'c'; defined are: k, gap."},
    {cases, "Variables/k, Variables/k; 1, 2",
     "35: Analysis cases / Parameter grid / Cases = Variables/k, Variables/k; 1, 2\n  Cases must "
     "not name a key that another Key of this grid or the key With of an analysis changes."},
    {cases, "Analysis/cases/Type; modal",
     "35: Analysis cases / Parameter grid / Cases = Analysis/cases/Type; modal\n  Cases must name "
     "a key that changes the model or the analysis 'motion', which the grid repeats, other than "
     "its Type."},
    {cases, "nowhere.csv",
     "35: Analysis cases / Parameter grid / Cases = nowhere.csv\n  the file './nowhere.csv' cannot "
     "be read."},
    {cases, "Variables/k; 1\n    subsection Key k\n      set Path = Variables/gap\n    end",
     "35: Analysis cases / Parameter grid / Cases = Variables/k; 1\n  Cases must not be set when "
     "there are sections Key."},
    {"Mirrored as = left", "Mirrored as = top",
     "11: Contact right / Mirrored as = top\n  Mirrored as must be a name that no other contact "
     "has."},
    {"Mirrored as = left", "Mirrored as = right",
     "11: Contact right / Mirrored as = right\n  Mirrored as must be a name that no other contact "
     "has."},
    {"Mirrored as = left", "Mirrored as = le/ft",
     "11: Contact right / Mirrored as = le/ft\n  Mirrored as must be a name of letters, digits, "
     "'_' and '-'."},
    {"Mirrored as = left", "Mirrored as = left\n  set Pairing = stops",
     "11: Contact right / Mirrored as = left\n  Mirrored as must not be set when Pairing = stops."},
};
INSTANTIATE_TEST_SUITE_P(Refused, BrokenInputLanguageTable, ::testing::ValuesIn(refused));

TEST(BrokenInputLanguageTest, TheFileIsSound) { EXPECT_EQ(message_of(file), ""); }

TEST(BrokenInputLanguageTest, AGridTakesNoKeyThatTheAnalysisOfItsSearchKeepsConstant) {
  const std::string search = file + R"(subsection Analysis best
  set Type = optimise
  subsection Optimise
    set Repeat    = motion
    set Objective = contact/right/gap/minimum
    subsection Key k
      set Path  = Variables/k
      set Lower = 1 kN/m
      set Upper = 2 kN/m
    end
  end
end
subsection Analysis bests
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = best
    set Cases  = Variables/gap; 1 mm
  end
end
)";
  EXPECT_NE(message_of(search).find("Cases must not name a key that the analysis 'best' changes"),
            std::string::npos)
      << message_of(search);
}

TEST(BrokenInputLanguageTest, TheEffectiveMassIsAskedForWhereASideIsNotLumped) {
  const std::string tsuji = changed(file, R"(  set Clearance = 1 m
  subsection Linear penalty
    set Stiffness = k
  end)",
                                    R"(  set Clearance = 1 m
  set Law = tsuji
  subsection Tsuji
    set Stiffness = 1e10 N/m^1.5
    set Restitution coefficient = 0.8
  end)");
  EXPECT_EQ(message_of(tsuji), "");
  const std::string beam = changed(tsuji, "block.head, stop\n  set Clearance = 1 m",
                                   "beam.tip, stop\n  set Clearance = 1 m");
  EXPECT_EQ(
      message_of(beam + R"(subsection Body beam
  set Type = beam
  subsection Geometry
    set Line     = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m
    set Elements = 4
  end
  subsection Section
    set Shape     = rectangle
    set Width     = 30 mm
    set Thickness = 5 mm
  end
  subsection Material
    set Young modulus = 206 GPa
    set Poisson ratio = 0.3
    set Density       = 7850 kg/m^3
  end
  subsection Support root
    set At  = start
    set Fix = all
  end
  subsection Point tip
    set At = end
  end
end
)"),
      "test.prm:21: Contact top / Tsuji / Effective mass\n  a value must be given when a side "
      "belongs to a body that is not lumped, or there are rotors; a mass [kg] is expected "
      "(greater than 0), for example 50 g.");
}

} // namespace broken_input_language_tests
} // namespace vibroimpact
