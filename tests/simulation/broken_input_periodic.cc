// Periodic orbits that cannot be looked for: what the message says.
#include "common/hdf5_file.h"
#include "support/simulation_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact {
namespace broken_input_periodic_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a block before a stop
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Stiffness = 1 kN/m
    set Damping = 3 N s/m
  end
end
subsection Contact stop
  set Between = block.head
  set Clearance = 5 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 100 kN/m
  end
end
subsection Excitation shaker
  set Type = force
  set At = block.head
  set Amplitude = 1 N
  set Frequency = 3 Hz
end
subsection Analysis orbit
  set Type = periodic orbit
  subsection Periodic orbit
    set State = 0.001, 0.02
  end
end
)";

void expect_message_of(const std::string &file, const std::string &from, const std::string &to,
                       const std::vector<std::string> &parts) {
  const std::string message = message_of(changed(file, from, to));
  EXPECT_FALSE(message.empty());
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

void expect_message(const std::string &from, const std::string &to,
                    const std::vector<std::string> &parts) {
  expect_message_of(sound, from, to, parts);
}

/// The sound file with an analysis of another type in place of the periodic orbit.
std::string file_with(const std::string &type, const std::string &section) {
  return changed(
      changed(sound, "set Type = periodic orbit", "set Type = " + type + "\n  " + section),
      "  subsection Periodic orbit\n    set State = 0.001, 0.02\n  end\n", "");
}

TEST(BrokenInputPeriodicTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputPeriodicTest, State) {
  expect_message("0.001, 0.02", "0.001", {"test.prm:27", "State = 0.001", "2 numbers"});
  expect_message("0.001, 0.02", "0.001, 0.02, 0", {"State", "2 numbers"});
  expect_message("set State = 0.001, 0.02", "set State = 0.001, 0.02\n    set Settling cycles = 3",
                 {"Settling cycles = 3", "when State or State run is set"});
  expect_message("0.001, 0.02", "0.001, fast", {"State", "fast"});
}

TEST(BrokenInputPeriodicTest, KeysOfDerivatives) {
  const auto with = [](const std::string &path) {
    return "0.001, 0.02\nsubsection Derivative one\nset Path = " + path + "\nend";
  };
  expect_message("0.001, 0.02", with("Analysis/orbit/Record"),
                 {"Derivative one / Path", "a key outside the analyses"});
  expect_message("0.001, 0.02", with("Title"),
                 {"Derivative one / Path", "one number as its value"});
  expect_message("0.001, 0.02", with("Variables/nothing"), {"Derivative one / Path", "nothing"});
}

TEST(BrokenInputPeriodicTest, StoredState) {
  const testing::TemporaryFolder folder;
  Hdf5File file = Hdf5File::create(folder.path() / "results.h5");
  file.write("/analysis/sweep/state", {3, 2}, std::vector<double>{1, 2, 3, 4, std::nan(""), 6});
  file.write("/analysis/one/state", {2}, std::vector<double>{1, 2});
  file.write("/analysis/other/state", {3}, std::vector<double>{1, 2, 3});
  file.close();
  const auto keys = [&](const std::string &analysis, const std::string &point) {
    return "set State run = " + folder.path().string() + "\n    set State analysis = " + analysis +
           (point.empty() ? "" : "\n    set State point = " + point);
  };
  const std::string given = "set State = 0.001, 0.02";
  EXPECT_EQ(message_of(changed(sound, given, keys("sweep", "2"))), "");
  EXPECT_EQ(message_of(changed(sound, given, keys("one", ""))), "");
  expect_message(given, keys("sweep", "4"), {"State point = 4", "from 1 up to 3"});
  expect_message(given, keys("sweep", "0"), {"State point = 0", "1"});
  expect_message(given, keys("sweep", "1, 1"), {"State point", "from 1 up to 3"});
  expect_message(given, keys("sweep", "1.5"), {"State point = 1.5", "from 1 up to 3"});
  expect_message(given, keys("sweep", "3"), {"State point = 3", "missing or has failed"});
  expect_message(given, keys("one", "1"), {"State point = 1", "single point"});
  expect_message(given, keys("swep", "1"), {"State analysis = swep", "whose points have a state"});
  expect_message(given, keys("other", ""), {"State run", "2 numbers"});
  expect_message(given, "set State run = /nowhere", {"State run = /nowhere", "earlier run"});
  expect_message(given, "set State analysis = sweep",
                 {"State analysis", "when State run is not set"});
  expect_message(given, given + "\n    " + keys("one", ""), {"State run", "when State is set"});
}

TEST(BrokenInputPeriodicTest, Multiple) {
  expect_message("set State = 0.001, 0.02", "set Period multiple = -1", {"Period multiple", "-1"});
  expect_message("set State = 0.001, 0.02", "set Period multiple = 1.5", {"Period multiple"});
}

TEST(BrokenInputPeriodicTest, Excitation) {
  expect_message("set Type = periodic orbit", "set Type = periodic orbit\n  set Excitations = none",
                 {"A periodic orbit must have one periodic excitation"});
  expect_message("set State = 0.001, 0.02", "set Excitation = shakr", {"shakr", "active"});
  const std::string second =
      "subsection Excitation hum\n  set Type = force\n  set At = block.head\n"
      "  set Amplitude = 1 N\n  set Frequency = 4 Hz\nend\n"
      "subsection Analysis orbit";
  const std::string both = changed(sound, "subsection Analysis orbit", second);
  EXPECT_NE(message_of(both).find("the key Excitation"), std::string::npos);
  const std::string message =
      message_of(changed(both, "set State", "set Excitation = shaker\n    set State"));
  EXPECT_NE(message.find("hum does not repeat itself after the period of shaker"),
            std::string::npos)
      << message;
}

TEST(BrokenInputPeriodicTest, Ramp) {
  expect_message("set Frequency = 3 Hz",
                 "set Frequency = 3 Hz\n  set History = ramped harmonic\n"
                 "  subsection Ramp\n    set Rate = 1/s\n  end",
                 {"shaker does not repeat itself"});
}

const std::string branch = R"(subsection Branch
    set First frequency = 1 Hz
    set Last frequency = 9 Hz
  end
)";

std::string branch_file() { return file_with("branch", branch); }

void expect_branch_message(const std::string &from, const std::string &to,
                           const std::vector<std::string> &parts) {
  expect_message_of(branch_file(), from, to, parts);
}

TEST(BrokenInputPeriodicTest, BranchEnds) {
  EXPECT_EQ(message_of(branch_file()), "");
  expect_branch_message("Last frequency = 9 Hz", "Last frequency = 1 Hz",
                        {"Last frequency", "greater than First frequency"});
  expect_branch_message("Last frequency = 9 Hz", "Last frequency = 2 Hz",
                        {"3.0", "must lie between its ends"});
  expect_branch_message("    set First frequency = 1 Hz\n", "", {"First frequency", "given"});
  expect_branch_message("set First frequency = 1 Hz", "set Points = 3", {"Points"});
  const std::string clearance = "set Parameter = Contact/stop/Clearance\n    set First = 1 mm\n";
  expect_branch_message("set First frequency = 1 Hz\n    set Last frequency = 9 Hz",
                        clearance + "    set Last = 0.5 mm", {"Last", "greater than First"});
  expect_branch_message("set First frequency = 1 Hz\n    set Last frequency = 9 Hz",
                        clearance + "    set Last = 2 mm", {"0.005", "must lie between its ends"});
  expect_branch_message("set First frequency = 1 Hz\n    set Last frequency = 9 Hz",
                        "set Parameter = Contact/stop/Between\n    set First = 1\n"
                        "    set Last = 2",
                        {"Parameter", "one number as its value"});
}

TEST(BrokenInputPeriodicTest, BranchSteps) {
  expect_branch_message("set First frequency", "set Longest step = 0\n    set First frequency",
                        {"Longest step", "0"});
  expect_branch_message("set First frequency",
                        "set Longest step = 1e-5\n    set Least step = 1e-4\n    set First "
                        "frequency",
                        {"Least step", "less than Longest step"});
  expect_branch_message("set First frequency", "set Most points = 1\n    set First frequency",
                        {"Most points", "1"});
  expect_branch_message("set First frequency", "set Switching levels = -1\n    set First frequency",
                        {"Switching levels", "-1"});
  expect_branch_message("set First frequency", "set Direction = up\n    set First frequency",
                        {"Direction", "up"});
}

const std::string balance = R"(subsection Harmonic balance
    set First frequency = 1 Hz
    set Last frequency = 9 Hz
    set Harmonics = 3
  end
)";

std::string balance_file() { return file_with("harmonic balance", balance); }

void expect_balance_message(const std::string &from, const std::string &to,
                            const std::vector<std::string> &parts) {
  expect_message_of(balance_file(), from, to, parts);
}

TEST(BrokenInputPeriodicTest, HarmonicBalance) {
  EXPECT_EQ(message_of(balance_file()), "");
  const std::string here = "set Harmonics = 3";
  expect_balance_message(here, "set Harmonics = 0", {"Harmonics = 0"});
  expect_balance_message(here, "set Harmonics = 1.5", {"Harmonics", "1.5"});
  expect_balance_message(here, here + "\n    set Samples per period = 13",
                         {"Samples per period = 13", "at least 14 for 3 Harmonics"});
  expect_balance_message(here, here + "\n    set Samples per period = -1", {"Samples per period"});
  expect_balance_message(here, here + "\n    set Guess = 0, 0.001",
                         {"test.prm", "Guess", "odd number of coefficients, 7 at most"});
  expect_balance_message(here, here + "\n    set Guess = 0, 0, 0, 0, 0, 0, 0, 0, 0", {"Guess"});
  EXPECT_EQ(message_of(changed(balance_file(), here, here + "\n    set Guess = 0, 1e-3, 0")), "");
  expect_balance_message(here, here + "\n    set Direction = up", {"Direction", "up"});
  expect_balance_message(here, here + "\n    set Least step = 0.02", {"Least step"});
  expect_balance_message("Last frequency = 9 Hz", "Last frequency = 2 Hz",
                         {"A harmonic balance begins", "must lie between its ends"});
  expect_balance_message("subsection Harmonic balance",
                         "set Record = impacts\n  subsection Harmonic balance",
                         {"Record", "no recorders"});
}

TEST(BrokenInputPeriodicTest, HarmonicBalanceOfWhatItCannotExpress) {
  expect_balance_message("set Law = linear penalty\n  subsection Linear penalty\n"
                         "    set Stiffness = 100 kN/m\n  end",
                         "set Law = newton restitution\n  subsection Newton restitution\n"
                         "    set Restitution coefficient = 0.8\n  end",
                         {"the contact stop is rigid", "Law = newton restitution"});
  expect_balance_message("    set Stiffness = 1 kN/m\n", "", {"no spring or support holds them"});
  expect_balance_message("set Type = harmonic balance",
                         "set Type = harmonic balance\n"
                         "  set Active contacts = none",
                         {"no contact and no cubic spring", "frequency response"});
  const std::string second = "subsection Excitation hum\n  set Type = force\n"
                             "  set At = block.head\n  set Amplitude = 1 N\n"
                             "  set Frequency = 12 Hz\nend\nsubsection Analysis orbit";
  expect_balance_message("subsection Analysis orbit", second, {"the key Excitation"});
}

const std::string locus = R"(subsection Locus
    set Most points = 20
    subsection First key
      set First frequency = 1 Hz
      set Last frequency = 9 Hz
    end
    subsection Second key
      set Parameter = Contact/stop/Clearance
      set First = 1 mm
      set Last = 9 mm
    end
  end
)";

std::string locus_file() { return file_with("locus", locus); }

void expect_locus_message(const std::string &from, const std::string &to,
                          const std::vector<std::string> &parts) {
  expect_message_of(locus_file(), from, to, parts);
}

TEST(BrokenInputPeriodicTest, LocusKinds) {
  EXPECT_EQ(message_of(locus_file()), "");
  const std::string before = "subsection First key";
  expect_locus_message(before, "set Kinds = folds\n    " + before, {"Kinds = folds", "fold"});
  expect_locus_message(before, "set Kinds =\n    " + before, {"Kinds", "at least one of fold"});
}

TEST(BrokenInputPeriodicTest, LocusKeys) {
  expect_locus_message("Last frequency = 9 Hz", "Last frequency = 1 Hz",
                       {"First key", "Last frequency", "greater than First frequency"});
  expect_locus_message("Last frequency = 9 Hz", "Last frequency = 2 Hz",
                       {"A locus begins", "3.0", "must lie between its ends"});
  expect_locus_message("set Last = 9 mm", "set Last = 3 mm",
                       {"A locus begins", "0.005", "must lie between its ends"});
  expect_locus_message("      set First frequency = 1 Hz\n", "", {"First frequency", "given"});
  expect_locus_message("set First = 1 mm", "set First = 1 N", {"Clearance"});
  expect_locus_message("Contact/stop/Clearance", "Contact/stop/Between", {"Between"});
  expect_locus_message("Contact/stop/Clearance", "Contact/stp/Clearance", {"stp"});
  expect_locus_message("set Parameter = Contact/stop/Clearance\n      set First = 1 mm\n"
                       "      set Last = 9 mm",
                       "set First frequency = 2 Hz\n      set Last frequency = 4 Hz",
                       {"Second key", "another key than that of First key"});
  expect_locus_message("set First frequency = 1 Hz\n      set Last frequency = 9 Hz",
                       "set Parameter = Contact stop/Clearance\n      set First = 1 mm\n"
                       "      set Last = 9 mm",
                       {"Second key", "another key than that of First key"});
}

TEST(BrokenInputPeriodicTest, LocusSteps) {
  const std::string before = "subsection First key";
  expect_locus_message(before, "set Longest step = 0\n    " + before, {"Longest step", "0"});
  expect_locus_message(before, "set Longest step = 1e-5\n    set Least step = 1e-4\n    " + before,
                       {"Least step", "less than Longest step"});
  expect_locus_message("Most points = 20", "Most points = 1", {"Most points", "1"});
  expect_locus_message(before, "set Switching levels = -1\n    " + before,
                       {"Switching levels", "-1"});
  expect_locus_message(before, "set State = 1, 2, 3\n    " + before, {"State", "2 numbers"});
}

const std::string rotor = R"(subsection Body wheel
  set Type = rotor
  subsection Rotor
    set At = block.head
    set Mass = 1 kg
    set Inertia = 0.01 kg m^2
    set Eccentricity = 1 mm
  end
  subsection Motor
    set Starting torque = 1 N m
    set Slope = 0.1 N m s
    set Time constant = 0.1 s
  end
end
)";

// The motion has no period then.
TEST(BrokenInputPeriodicTest, Rotors) {
  const std::string before = "subsection Contact stop";
  for (const std::string &file : {sound, branch_file(), balance_file(), locus_file()})
    expect_message_of(file, before, rotor + before,
                      {"the model has a rotor: its speed is a second frequency"});
}

} // namespace broken_input_periodic_tests
} // namespace vibroimpact
