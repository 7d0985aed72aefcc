// Excitations that cannot be used: every message names the place, the key, and what is allowed.
#include "support/simulation_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vibroimpact {
namespace broken_input_excitation_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Axis = x
    set Stiffness = 1 kN/m
  end
end
subsection Excitation shaker
  set Type = base acceleration
  set History = harmonic
  set Amplitude = 2 m/s^2
  set Frequency = 3 Hz
end
subsection Analysis release
  set Type = transient
  subsection Transient
    set Duration = 1 s
  end
end
)";

// The excitation's keys replaced.
std::string with(const std::string &keys) {
  const std::size_t begin = sound.find("  set Type = base acceleration");
  const std::size_t end = sound.find("end\nsubsection Analysis");
  return sound.substr(0, begin) + keys + sound.substr(end);
}

void expect_message(const std::string &text, const std::vector<std::string> &parts) {
  const std::string message = message_of(text);
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is missing in:\n"
                                                     << message << "\nof\n"
                                                     << text;
}

TEST(BrokenInputExcitationTest, SoundOnesAreAccepted) {
  EXPECT_EQ(message_of(sound), "");
  for (const char *keys :
       {"set Type = gravity\nset Direction = x\nset Amplitude = 1 g0\n",
        "set Type = base velocity\nset History = constant\nset Amplitude = 1 mm/s\n",
        "set History = ramped harmonic\nset Amplitude = 1\nset Frequency = 2 Hz\n"
        "subsection Ramp\nset Rate = 3/s\nend\n",
        "set Type = base displacement\nset History = sine sweep\nset Amplitude = 1 mm\n"
        "subsection Sine sweep\nset From = 1 Hz\nset To = 9 Hz\nset Duration = 2 s\n"
        "set Law = logarithmic\nset After = stop\nset Fade-out = 0.1 s\nend\n",
        "set Type = force\nset At = block.head\nset History = impulse\nsubsection Impulse\n"
        "set Duration = 1 ms\nset Impulse = 3 N s\nset Shape = rectangular\nend\n",
        "set History = impulse\nset Amplitude = 1 g0\nsubsection Impulse\nset Duration = 1 ms\n"
        "end\n"})
    EXPECT_EQ(message_of(with(keys)), "") << keys;
}

TEST(BrokenInputExcitationTest, KeysThatAreMissingOrUnused) {
  expect_message(changed(sound, "  set Frequency = 3 Hz\n", ""),
                 {"Excitation shaker", "Frequency", "must be given"});
  expect_message(changed(sound, "= harmonic", "= constant"),
                 {"Frequency", "Frequency must not be set when History = constant"});
  expect_message(changed(sound, "= harmonic", "= ramped harmonic"), {"Ramp", "Rate"});
  expect_message(changed(sound, "= harmonic", "= noise"), {"History", "noise", "sine sweep"});
  expect_message(changed(sound, "base acceleration", "gravity"),
                 {"History", "gravity is constant"});
  expect_message(with("set Type = gravity\nset Amplitude = 9.81 m/s\n"),
                 {"Amplitude", "acceleration"});
}

TEST(BrokenInputExcitationTest, SineSweeps) {
  const auto sweep = [](const std::string &type, const std::string &keys) {
    return with("set Type = base " + type +
                "\nset History = sine sweep\nset Amplitude = 1\nsubsection Sine sweep\n"
                "set From = 1 Hz\nset To = 2 Hz\n" +
                keys + "end\n");
  };
  expect_message(sweep("velocity", ""), {"Sine sweep", "Duration"});
  expect_message(sweep("velocity", "set Duration = 1 s\nset Fade-out = 1 s\n"),
                 {"Fade-out", "After = stop"});
  expect_message(sweep("velocity", "set Duration = 1 s\nset Fade-in = 2 s\n"),
                 {"Fade-in", "longer than Duration"});
  expect_message(sweep("velocity", "set Duration = 1 s\nset After = stop\n"),
                 {"After", "infinite acceleration"});
  EXPECT_EQ(message_of(sweep("acceleration", "set Duration = 1 s\nset After = stop\n")), "");
}

TEST(BrokenInputExcitationTest, Impulses) {
  const auto impulse = [](const std::string &top, const std::string &keys) {
    return with(top + "set History = impulse\nsubsection Impulse\nset Duration = 1 ms\n" + keys +
                "end\n");
  };
  expect_message(impulse("", ""), {"Impulse", "must be given, and not both"});
  expect_message(impulse("set Amplitude = 1\n", "set Impulse = 1 m/s\n"),
                 {"must be given, and not both"});
  expect_message(impulse("", "set Impulse = 1 N s\n"), {"Impulse / Impulse", "velocity"});
  expect_message(
      impulse("set Type = base velocity\nset Amplitude = 1\n", "set Shape = rectangular\n"),
      {"Shape", "infinite acceleration", "triangular"});
  expect_message(impulse("set Type = base displacement\nset Amplitude = 1\n", ""),
                 {"Shape", "infinite acceleration", "versed sine"});
}

TEST(BrokenInputExcitationTest, ASteppedSweepNeedsAFrequency) {
  const std::string text = changed(changed(with("set History = constant\nset Amplitude = 1\n"),
                                           "= transient", "= stepped sweep"),
                                   "  subsection Transient\n    set Duration = 1 s\n",
                                   "  subsection Stepped sweep\n    set First frequency = 1 Hz\n"
                                   "    set Last frequency = 2 Hz\n");
  expect_message(text, {"shaker", "has no frequency"});
}

class RecordTest {
public:
  explicit RecordTest(const std::string &content) {
    std::ofstream(folder_.path() / "quake.csv") << content;
  }
  std::string text(const std::string &keys, const std::string &top = "",
                   const std::string &file = "quake.csv") const {
    return "set File folder = " + folder_.path().string() + "\n" +
           with(top + "set History = recorded\nsubsection Recorded\nset File = " + file + "\n" +
                keys + "end\n");
  }

private:
  testing::TemporaryFolder folder_;
};

TEST(BrokenInputExcitationTest, Records) {
  const RecordTest record("t,a\n0,1\n1,2\n2,x\n");
  expect_message(record.text("", "", "none.csv"), {"Recorded", "File", "there is none at"});
  expect_message(record.text(""), {"Value column", "line 4 of the record has 'x'"});
  expect_message(record.text("set Value column = b\n"), {"Value column = b", "t, a"});
  expect_message(record.text("", "set Amplitude = 1\n"),
                 {"Amplitude", "must not be set when History"});
  const RecordTest good("t,a\n0,1\n1,2\n2,3\n");
  EXPECT_EQ(message_of(good.text("set Unit = g0\nset Time unit = ms\n")), "");
  expect_message(good.text("set Unit = mm/s\n"), {"Unit = mm/s", "acceleration"});
  expect_message(good.text("", "set Type = base displacement\n"),
                 {"Interpolation", "cubic spline"});
  EXPECT_EQ(
      message_of(good.text("set Interpolation = cubic spline\n", "set Type = base displacement\n")),
      "");
  expect_message("set File checksums = quake.csv 0123456789abcdef\n" + good.text(""),
                 {"File = quake.csv", "is not what it was", "0123456789abcdef"});
}

} // namespace broken_input_excitation_tests
} // namespace vibroimpact
