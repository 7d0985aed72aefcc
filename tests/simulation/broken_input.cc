// Input that cannot be used: every message names the place, the key, its value and what is allowed.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace vibroimpact {
namespace broken_input_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a beam and a block
subsection Body beam
  set Type = beam
  subsection Geometry
    set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m
    set Elements = 4
    set Orientation = 0, 1, 0
  end
  subsection Section
    set Shape = rectangle
    set Width = 30 mm
    set Thickness = 0.75 mm
  end
  subsection Material
    set Young modulus = 206 GPa
    set Density = 7850 kg/m^3
  end
  subsection Support root
    set At = start
    set Fix = all
  end
  subsection Support plane
    set At = all
    set Fix = y, z, rx, rz
  end
  subsection Point head
    set At = end
    set Mass = 50 g
  end
  subsection Modes
    set Number = 3
  end
end
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Axis = x
    set Stiffness = 1 kN/m
  end
end
subsection Contact heads
  set Between = beam.head, block.head
  set Direction = x
  set Clearance = 5 mm
  set Law = hunt-crossley
  subsection Hunt-Crossley
    set Stiffness = 1e9
    set Restitution coefficient = 0.7
  end
end
subsection Excitation ground
  set Type = base acceleration
  set Amplitude = 2 m/s^2
  set Frequency = 3 Hz
end
subsection Initial condition pulled
  set At = beam.head
  set Displacement = 1 mm
end
subsection Analysis release
  set Type = transient
  subsection Transient
    set Duration = 1 s
  end
end
subsection Analysis response
  set Type = stepped sweep
  subsection Stepped sweep
    set First frequency = 1 Hz
    set Last frequency = 5 Hz
  end
end
subsection Analysis map
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = response
    subsection Key clearance
      set Path = Contact/heads/Clearance
      set Values = 1 mm, 2 mm
    end
  end
end
)";

struct Broken {
  const char *name;
  const char *from;
  const char *to;
  std::vector<std::string> expected; ///< parts of the message
  const char *also_from = "";
  const char *also_to = "";
};

void PrintTo(const Broken &broken, std::ostream *stream) { *stream << broken.name; }

class BrokenInputTest : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenInputTest, IsRefusedWithOneClearMessage) {
  const std::string message = message_of(changed(changed(sound, GetParam().from, GetParam().to),
                                                 GetParam().also_from, GetParam().also_to));
  ASSERT_FALSE(message.empty()) << "accepted";
  for (const std::string &part : GetParam().expected)
    EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in:\n" << message;
  EXPECT_EQ(message.find("Stacktrace"), std::string::npos);
  EXPECT_LT(message.size(), 1000U);
  EXPECT_LE(std::count(message.begin(), message.end(), '\n'), 2) << message;
}

const Broken cases[] = {
    {"misspelt key",
     "Clearance = 5 mm",
     "Claerance = 5 mm",
     {"test.prm:", "Contact heads", "Clearance"}},
    {"unknown section", "subsection Modes", "subsection Mode", {"test.prm:", "Modes"}},
    {"unknown top-level section",
     "subsection Excitation ground",
     "subsection Exitation ground",
     {"test.prm:", "Excitation"}},
    {"wrong unit",
     "Clearance = 5 mm",
     "Clearance = 5 kg",
     {"Contact heads / Clearance = 5 kg", "a mass", "a length"}},
    {"unknown unit", "Clearance = 5 mm", "Clearance = 5 furlong", {"Clearance", "furlong"}},
    {"bare frequency",
     "Frequency = 3 Hz",
     "Frequency = 3",
     {"Excitation ground / Frequency = 3", "Hz"}},
    {"not a number", "Clearance = 5 mm", "Clearance = nan", {"Clearance = nan"}},
    {"infinite", "Clearance = 5 mm", "Clearance = 1/0", {"Clearance = 1/0"}},
    {"no choice", "Law = hunt-crossley", "Law = hunt-crosley", {"Law", "hunt-crossley"}},
    {"duplicate key",
     "set Clearance = 5 mm",
     "set Clearance = 5 mm\n set Clearance = 6 mm",
     {"Clearance", "test.prm:"}},
    {"missing end", "    set Duration = 1 s\n  end", "    set Duration = 1 s", {"test.prm", "end"}},
    {"zero elements", "Elements = 4", "Elements = 0", {"Geometry / Elements = 0"}},
    {"fraction of elements", "Elements = 4", "Elements = 4.5", {"Geometry / Elements = 4.5"}},
    {"line without length",
     "0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m",
     "0 m, 0 m, 0 m -> 0 m, 0 m, 0 m",
     {"Geometry / Line"}},
    {"line of two numbers", "0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m", "0 m, 1 m", {"Geometry / Line"}},
    {"neither line nor mesh", "set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m", "", {"Geometry"}},
    {"missing mesh",
     "set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 0.3 m\n    set Elements = 4",
     "set Mesh = nowhere.msh",
     {"Geometry / Mesh = nowhere.msh"}},
    {"orientation along the beam",
     "Orientation = 0, 1, 0",
     "Orientation = 0, 0, 1",
     {"Geometry / Orientation"}},
    {"negative width",
     "Width = 30 mm",
     "Width = -30 mm",
     {"Section / Width = -30 mm", "greater than 0"}},
    {"width forgotten", "set Width = 30 mm", "", {"Section / Width"}},
    {"impossible Poisson ratio",
     "set Density",
     "set Poisson ratio = 0.7\n set Density",
     {"Material / Poisson ratio = 0.7"}},
    {"modulus forgotten", "set Young modulus = 206 GPa", "", {"Material / Young modulus"}},
    {"body without mass",
     "Density = 7850 kg/m^3",
     "Density = 0 kg/m^3",
     {"Body beam", "mass"},
     "set Mass = 50 g",
     ""},
    {"support nowhere", "At = start", "At = middle", {"Support root / At = middle"}},
    {"unknown degree of freedom",
     "Fix = y, z, rx, rz",
     "Fix = y, z, rw",
     {"Support plane / Fix", "rw"}},
    {"more modes than freedoms", "Number = 3", "Number = 300", {"Modes / Number = 300"}},
    {"negative damping ratio",
     "Number = 3",
     "Number = 3\n set Damping ratio = -0.1",
     {"Modes / Damping ratio = -0.1"}},
    {"lumped body without mass",
     "Mass = 2 kg",
     "Mass = 0 kg",
     {"Mass head / Mass = 0 kg", "greater than 0"}},
    {"unknown point",
     "beam.head, block.head",
     "beam.hed, block.head",
     {"Contact heads / Between", "beam.hed", "beam.head"}},
    {"contact with itself",
     "beam.head, block.head",
     "beam.head, beam.head",
     {"Contact heads / Between"}},
    {"three sides",
     "beam.head, block.head",
     "beam.head, block.head, stop",
     {"Contact heads / Between"}},
    {"no direction", "Direction = x", "Direction = up", {"Contact heads / Direction = up"}},
    {"direction nothing moves along",
     "Direction = x",
     "Direction = y",
     {"Contact heads / Direction = y"}},
    {"undeclared prestress",
     "Clearance = 5 mm",
     "Clearance = -5 mm",
     {"Contact heads / Clearance = -5 mm", "Prestressed"}},
    {"restitution above one",
     "Restitution coefficient = 0.7",
     "Restitution coefficient = 1.2",
     {"Restitution coefficient = 1.2"}},
    {"both damping factor and restitution",
     "set Restitution coefficient = 0.7",
     "set Restitution coefficient = 0.7\n set Damping factor = 3",
     {"Hunt-Crossley / Damping factor"}},
    {"neither stiffness nor radii", "set Stiffness = 1e9", "", {"Hunt-Crossley / Radius a"}},
    {"wrong unit of a stiffness with exponent",
     "Stiffness = 1e9",
     "Stiffness = 1e9 N/m",
     {"Hunt-Crossley / Stiffness = 1e9 N/m"}},
    {"starts penetrated",
     "Displacement = 1 mm",
     "Displacement = 6 mm",
     {"Contact heads / Clearance = 5 mm", "Initial penetration"}},
    {"amplitude of another type",
     "Amplitude = 2 m/s^2",
     "Amplitude = 2 mm",
     {"Excitation ground / Amplitude = 2 mm"}},
    {"amplitude forgotten", "set Amplitude = 2 m/s^2", "", {"Excitation ground / Amplitude"}},
    {"unknown body on the base",
     "set Amplitude",
     "set Bodies = beem\n set Amplitude",
     {"Excitation ground / Bodies", "beam"}},
    {"force without a point",
     "Type = base acceleration\n  set Amplitude = 2 m/s^2",
     "Type = force\n  set Amplitude = 2 N",
     {"Excitation ground / At"}},
    {"initial condition nowhere",
     "At = beam.head\n  set Displacement",
     "At = beam.tip\n  set Displacement",
     {"Initial condition pulled / At = beam.tip"}},
    {"mode the body has not",
     "set Displacement = 1 mm",
     "set Displacement = 1 mm\n set Shape = mode\n set Mode = 9",
     {"Initial condition pulled / Mode = 9"}},
    {"duration forgotten", "set Duration = 1 s", "", {"Transient / Duration"}},
    {"sweep backwards",
     "Last frequency = 5 Hz",
     "Last frequency = 0.5 Hz",
     {"Stepped sweep / Last frequency = 0.5 Hz"}},
    {"unknown analysis in the list",
     "set Title",
     "set Analyses = releas\nset Title",
     {"Analyses = releas", "release"}},
    {"unknown excitation",
     "set Type = transient",
     "set Type = transient\n set Excitations = grund",
     {"Analysis release / Excitations", "ground"}},
    {"grid of nothing",
     "Repeat = response",
     "Repeat = respons",
     {"Parameter grid / Repeat", "response"}},
    {"grid over an unknown key",
     "Path = Contact/heads/Clearance",
     "Path = Contact/heads/Claerance",
     {"Clearance"}},
    {"grid key without values", "set Values = 1 mm, 2 mm", "", {"Key clearance / First"}},
    {"the same key twice in a grid",
     "      set Values = 1 mm, 2 mm\n    end",
     "      set Values = 1 mm, 2 mm\n    end\n    subsection Key again\n"
     "      set Path = Contact heads/Clearance\n      set Values = 3 mm\n    end",
     {"test.prm:", "Key again / Path", "another Key"}},
    {"a follower of the key's own path",
     "      set Values = 1 mm, 2 mm\n    end",
     "      set Values = 1 mm, 2 mm\n    end\n    subsection Key again\n"
     "      set Path = Contact/heads/Clearance\n      set Tied to = clearance\n"
     "      set Values = 3 mm, 4 mm\n    end",
     {"test.prm:", "Key again / Path", "another Key"}},
    {"grid over the type",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analysis/response/Type\n      set Values = modal, response",
     {"test.prm:", "Key clearance / Path", "other than its Type"}},
    {"grid over its own keys",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analysis/map/Parameter grid/Repeat\n      set Values = response, release",
     {"test.prm:", "Key clearance / Path", "'response'"}},
    {"grid over another analysis",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analysis/release/Transient/Duration\n      set Values = 1 s, 2 s",
     {"test.prm:", "Key clearance / Path", "'response'"}},
    {"grid over the list of analyses",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analyses\n      set Values = response, release",
     {"test.prm:", "Key clearance / Path"}},
    {"grid over what its sweep sweeps",
     "    set First frequency = 1 Hz\n    set Last frequency = 5 Hz",
     "    set Parameter = Contact heads/Clearance\n    set First = 6 mm\n    set Last = 9 mm",
     {"test.prm:", "Key clearance / Path", "changes itself"}},
    {"grid of an empty value",
     "Values = 1 mm, 2 mm",
     "Values = 1 mm,, 2 mm",
     {"test.prm:", "Key clearance / Values", "empty"}},
    {"grid value of a wrong unit",
     "Values = 1 mm, 2 mm",
     "Values = 1 mm, 2 kg",
     {"test.prm:", "Key clearance / Values", "Contact/heads/Clearance", "'2 kg' is a mass"}},
    {"grid that gives an axis another length",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analysis/response/Stepped sweep/Points\n      set Values = 3, 4",
     {"number of points", "Points = 4", "grid map"}},
    {"grid with an impossible case",
     "Path = Contact/heads/Clearance\n      set Values = 1 mm, 2 mm",
     "Path = Analysis/response/Stepped sweep/Last frequency\n      set Values = 5 Hz, 0.5 Hz",
     {"greater than First frequency", "= 0.5 Hz of the parameter grid map"}},
    {"grid of too many cases",
     "      set Values = 1 mm, 2 mm\n    end",
     "      set First = 1 mm\n      set Last = 2 mm\n      set Points = 9999\n    end\n"
     "    subsection Key mass\n      set Path = Body/block/Mass/head/Mass\n"
     "      set First = 1 kg\n      set Last = 2 kg\n      set Points = 9999\n    end",
     {"test.prm:", "Parameter grid", "at most 1e6 cases"}},
    {"an analysis twice",
     "set Title",
     "set Analyses = release, release\nset Title",
     {"test.prm:1: Analyses", "'release' is listed twice"}},
    {"a motion in the place of the mode shapes",
     "Analysis release\n  set Type = transient\n  subsection Transient",
     "Analysis modes\n  set Type = transient\n  subsection Transient\n    set Frames = 5",
     {"test.prm:", "Analysis modes / Transient / Frames = 5", "name modes"}},
    {"a body twice",
     "set Title",
     "set Bodies = beam, block, beam\nset Title",
     {"test.prm:1: Bodies", "'beam' is listed twice"}},
    {"a contact twice",
     "set Title",
     "set Contacts = heads, heads\nset Title",
     {"test.prm:1: Contacts", "'heads' is listed twice"}},
    {"an excitation twice",
     "set Type = transient",
     "set Type = transient\n set Excitations = ground, ground",
     {"Analysis release / Excitations", "'ground' is listed twice"}},
    {"more elements than an integer holds",
     "Elements = 4",
     "Elements = 3000000000",
     {"Geometry / Elements = 3000000000", "from 1 to 10000"}},
    {"more modes than an integer holds",
     "Number = 3",
     "Number = 3000000000",
     {"Modes / Number = 3000000000", "100000"}},
    {"stiffness beyond computing",
     "Young modulus = 206 GPa",
     "Young modulus = 1e-300 Pa",
     {"test.prm:", "Body beam", "cannot be computed", "units"}},
    {"motion of many million years",
     "Duration = 1 s",
     "Duration = 1e15 s",
     {"test.prm:", "Analysis release", "Duration must be at most 1e12 periods", "frequency"}},
    {"steps too short to end",
     "subsection Excitation ground",
     "subsection Integration\n set Maximum step = 1e-15 s\nend\nsubsection Excitation ground",
     {"test.prm:", "Integration / Maximum step", "1e-12 of the Duration in Analysis release"}},
    {"samples beyond number",
     "Duration = 1 s",
     "Duration = 1 s\n set Sampling interval = 1e-15 s",
     {"Transient / Sampling interval = 1e-15 s", "at least Duration / 1e8"}},
    {"integration method",
     "subsection Excitation ground",
     "subsection Integration\n set Method = euler\nend\nsubsection Excitation ground",
     {"Integration / Method = euler", "rk"}},
    {"tolerance out of range",
     "subsection Excitation ground",
     "subsection Integration\n set Relative tolerance = 2\nend\nsubsection Excitation ground",
     {"Integration / Relative tolerance = 2"}},
};

INSTANTIATE_TEST_SUITE_P(All, BrokenInputTest, ::testing::ValuesIn(cases), [](const auto &info) {
  std::string name = info.param.name;
  for (char &c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)))
      c = '_';
  return name;
});

TEST(BrokenInputSoundTest, TheFileTheyAllStartFromIsSound) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputSoundTest, AcceptedPenetrationStarts) {
  EXPECT_EQ(message_of(changed(changed(sound, "Displacement = 1 mm", "Displacement = 6 mm"),
                               "Clearance = 5 mm",
                               "Clearance = 5 mm\n  set Initial penetration = accept")),
            "");
}

TEST(BrokenInputSoundTest, OverridesAreNamed) {
  const std::string message =
      message_of(sound, {{.path = "Contact/heads/Clearance", .value = "5 kg", .origin = "--set"}});
  EXPECT_NE(message.find("--set Contact/heads/Clearance=5 kg"), std::string::npos) << message;
}

} // namespace broken_input_tests
} // namespace vibroimpact
