// Searches that cannot be done: what the message says.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_searches_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a block on a spring
set Variables = k = 1000
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = k * 1 N/m
    set Damping = 3 N s/m
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 1 N
  set Frequency = 3 Hz
end
subsection Analysis steady
  set Type = steady state
end
subsection Derived amplitude
  set From = steady
  set Operation = expression
  set Fields = x = point/block.head/displacement_x/peak_to_peak
  set Expression = x / 2
end
subsection Analysis search
  set Type = optimise
  subsection Optimise
    set Repeat = steady
    set Objective = amplitude
    subsection Key stiffness
      set Path = Variables/k
      set Lower = 500
      set Upper = 2000
      set Start = 700
    end
  end
end
)";

TEST(BrokenInputSearchesTest, TheFileIsSound) { EXPECT_EQ(message_of(sound), ""); }

struct Mistake {
  std::string from, to;
  std::vector<std::string> words;
};

class BrokenInputSearchesFile : public ::testing::TestWithParam<Mistake> {};

TEST_P(BrokenInputSearchesFile, IsRefusedWithAMessage) {
  const auto &[from, to, words] = GetParam();
  const std::string message = message_of(changed(sound, from, to));
  for (const std::string &word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

const std::string mass_key = R"(    subsection Key mass
      set Path = Body/block/Mass/head/Mass
      set Lower = -1 kg
      set Upper = 3 kg
    end
)";

const Mistake mistakes[] = {
    {"set Repeat = steady", "", {"Optimise / Repeat", "must be given"}},
    {"set Repeat = steady",
     "set Repeat = stady",
     {"test.prm:29", "Repeat", "did you mean 'steady'"}},
    {"set Repeat = steady", "set Repeat = search", {"Repeat", "does not evaluate another one"}},
    {"set Objective = amplitude", "", {"Optimise / Objective", "must be given"}},
    {"subsection Key stiffness",
     "subsection Worst over stiffness",
     {"Worst over stiffness / Lower", "there is no key"}},
    {"set Path = Variables/k", "", {"Key stiffness / Path", "must be given"}},
    {"set Path = Variables/k", "set Path = Variables/c", {"Key stiffness / Path"}},
    {"set Path = Variables/k", "set Path = Title", {"Path", "changes the model or the analysis"}},
    {"set Path = Variables/k", "set Path = Analysis/search/Optimise/Seed", {"Path", "'steady'"}},
    {"set Path = Variables/k", "set Path = Analysis/steady/Type", {"Path", "other than its Type"}},
    {"set Lower = 500", "set Lower = 2000", {"Key stiffness / Upper", "greater than Lower"}},
    {"set Lower = 500", "set Lower = 800", {"Key stiffness / Start", "from Lower to Upper"}},
    {"set Lower = 500\n", "set Step = 0\n", {"Key stiffness / Step", "greater than 0"}},
    {"set Lower = 500", "set Lower = 500\nset Step = 1600", {"Step", "less than Upper - Lower"}},
    {"set Lower = 500\n      set Upper = 2000\n      set Start = 700",
     "set Upper = 2000",
     {"Key stiffness / Start", "must be given"}},
    {"set Lower = 500\n      set Upper = 2000\n      set Start = 700",
     "set Start = 0",
     {"Key stiffness / Start", "when Step is not set"}},
    {"set Lower = 500", "set Lower = 0\nset Scale = logarithmic", {"Lower", "greater than 0"}},
    {"set Lower = 500",
     "set Lower = 500\nset Step = 1\nset Scale = logarithmic",
     {"Step", "when Scale"}},
    {"    subsection Key",
     mass_key + "    subsection Key",
     {"Key mass / Lower", "-1 kg", "greater than 0"}},
    {"    subsection Key",
     "subsection Key again\nset Path = Variables/k\nset Start = 700\nend\n    subsection Key",
     {"Path", "another Key of this analysis"}},
    {"    subsection Key",
     "subsection Worst over k\nset Path = Variables/k\nset Values = 1, 2\nend\n    subsection Key",
     {"Worst over k / Path", "another Key of this analysis"}},
    {"    subsection Key",
     "subsection Constraint c\nset Upper = 1 N\nend\n    subsection Key",
     {"Constraint c / Quantity", "must be given"}},
    {"    subsection Key",
     "subsection Constraint c\nset Quantity = force\nend\n    subsection Key",
     {"Constraint c / Upper", "must be given"}},
    {"    subsection Key",
     "subsection Constraint c\nset Quantity = force\nset Upper = 1 N\nend\n    subsection Key",
     {"Optimise / Method", "differential evolution, COBYLA or ISRES"}},
    {"set Objective = amplitude",
     "set Objective = amplitude\nset Population = 9",
     {"Population", "no population"}},
    {"  set Type = optimise",
     "  set Type = optimise\n  set Excitations = none",
     {"Analysis search / Excitations", "in the analysis steady"}},
    {"set Objective = amplitude",
     "set Objective = amplitude\nset Tolerance = 0",
     {"Tolerance", "greater than 0"}},
    {"set Objective = amplitude",
     "set Objective = amplitud",
     {"test.prm:30", "Optimise / Objective", "'amplitud' is no field", "did you mean 'amplitude'"}},
};

INSTANTIATE_TEST_SUITE_P(BrokenInputSearches, BrokenInputSearchesFile,
                         ::testing::ValuesIn(mistakes));

// The same keys as a front and as a sensitivity.
const std::string front =
    changed(changed(changed(changed(sound, "set Type = optimise", "set Type = pareto front"),
                            "subsection Optimise", "subsection Pareto front"),
                    "set Objective = amplitude",
                    "subsection Objective a\nset Quantity = amplitude\nend\n"
                    "subsection Objective b\nset Quantity = point/block.head/displacement_x/"
                    "peak_to_peak\nset Sense = maximise\nend"),
            "set Start = 700", "");
const std::string shares = changed(
    changed(changed(changed(sound, "set Type = optimise", "set Type = sensitivity"),
                    "subsection Optimise", "subsection Sensitivity"),
            "set Objective = amplitude", "subsection Quantity a\nset Quantity = amplitude\nend"),
    "set Start = 700", "");

TEST(BrokenInputSearchesTest, FrontsAndSensitivities) {
  const auto expect = [](const std::string &file, const std::string &from, const std::string &to,
                         const std::vector<std::string> &words) {
    const std::string message = message_of(changed(file, from, to));
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
  };
  EXPECT_EQ(message_of(front), "");
  EXPECT_EQ(message_of(shares), "");
  expect(front, "subsection Objective b", "subsection Worst over b",
         {"Worst over b / Quantity", "there is no key"});
  expect(front, "subsection Objective a\nset Quantity = amplitude\nend\n", "",
         {"Pareto front", "at least two subsections Objective NAME"});
  expect(front, "set Quantity = amplitude\n", "", {"Objective a / Quantity", "must be given"});
  expect(front, "set Quantity = amplitude\n", "set Quantity = amplitud\n",
         {"Objective a / Quantity", "did you mean 'amplitude'"});
  expect(front, "set Upper = 2000", "", {"Key stiffness / Start", "must be given"});
  expect(front, "set Upper = 2000", "set Start = 700", {"Key stiffness / Upper", "must be given"});
  expect(front, "set Repeat = steady", "set Repeat = search", {"does not evaluate another one"});
  expect(shares, "set Quantity = amplitude\n", "set Quantity = amplitud\n",
         {"Quantity a / Quantity", "did you mean 'amplitude'"});
  expect(shares, "subsection Quantity a\nset Quantity = amplitude\nend", "",
         {"Sensitivity", "at least one subsection Quantity NAME"});
  expect(shares, "set Lower = 500", "set Start = 700", {"Key stiffness / Lower", "must be given"});
  expect(shares, "subsection Quantity a", "set Samples = 1\nsubsection Quantity a",
         {"Sensitivity / Samples"});
}

TEST(BrokenInputSearchesTest, WithoutABoundSomeMethodsCannotSearch) {
  const std::string unbounded = changed(sound, "      set Lower = 500\n", "");
  EXPECT_EQ(message_of(unbounded), "");
  const auto with = [&](const std::string &line) {
    return message_of(changed(unbounded, "set Repeat = steady", "set Repeat = steady\n" + line));
  };
  EXPECT_NE(with("set Method = DIRECT").find("Optimise / Method"), std::string::npos);
  EXPECT_NE(with("set Method = ISRES").find("another method when"), std::string::npos);
  EXPECT_NE(with("set Method = differential evolution").find("another method when"),
            std::string::npos);
  EXPECT_NE(with("set Starts = 2").find("Optimise / Starts"), std::string::npos);
}

TEST(BrokenInputSearchesTest, AKeyIsChangedOnce) {
  const std::string grid = R"(subsection Analysis grid
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = search
    subsection Key k
      set Path = Variables/k
      set Values = 1, 2
    end
  end
end
)";
  const std::string message = message_of(sound + grid);
  EXPECT_NE(message.find("changes itself"), std::string::npos) << message;
  const std::string swept =
      changed(sound, "  set Type = steady state\n", R"(  set Type = stepped sweep
  subsection Stepped sweep
    set Parameter = Variables/k
    set First = 1
    set Last = 2
  end
)");
  EXPECT_NE(message_of(swept).find("changes it itself"), std::string::npos) << message_of(swept);
}

} // namespace broken_input_searches_tests
} // namespace vibroimpact
