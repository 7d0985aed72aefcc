// Options of the recorders of a motion's character that cannot be used.
#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_character_tests {

using testing::changed;
using testing::message_of;

const std::string sound = R"(set Title = a block
subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
    set Axis = x
    set Stiffness = 1 kN/m
  end
end
subsection Contact heads
  set Between = block.head
  set Direction = x
  set Clearance = 5 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 1 MN/m
  end
end
subsection Excitation drive
  set Type = force
  set At = block.head
  set Direction = x
  set Amplitude = 3 N
  set Frequency = 3 Hz
end
subsection Analysis response
  set Type = stepped sweep
  set Record = section, regime, lyapunov, spectrum, wavelet, spectrogram
  subsection Stepped sweep
    set First frequency = 2 Hz
    set Last frequency = 5 Hz
  end
  subsection Section
    set Points = block.head
    set Contact onsets = heads
  end
  subsection Regime
    set Scales = 0.01, 0.2
  end
  subsection Lyapunov
    set Blocks = 5
  end
  subsection Spectrum
    set Contacts = heads
  end
  subsection Wavelet
    set Lowest frequency = 1 Hz
    set Highest frequency = 20 Hz
    set Sampling interval = 10 ms
  end
  subsection Spectrogram
    set Interval = 1 s
    set Highest frequency = 20 Hz
    set Sampling interval = 10 ms
  end
end
)";

void expect_message(const std::string &from, const std::string &to, const std::string &place,
                    const std::string &allowed) {
  const std::string message = message_of(changed(sound, from, to));
  EXPECT_NE(message.find(place), std::string::npos) << message;
  EXPECT_NE(message.find(allowed), std::string::npos) << message;
}

TEST(BrokenInputCharacterTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound), ""); }

TEST(BrokenInputCharacterTest, Sections) {
  expect_message("Points = block.head", "Points = block.foot", "Points", "block.head");
  expect_message("Points = block.head", "Points = none", "Points", "at least one point");
  expect_message("Contact onsets = heads", "Contact onsets = tails", "Contact onsets", "heads");
  expect_message("Contact onsets = heads", "Gap extrema = tails", "Gap extrema", "heads");
  expect_message("Contact onsets = heads", "Maximum samples = 0", "Maximum samples", "1");
}

TEST(BrokenInputCharacterTest, Regime) {
  expect_message("0.01, 0.2", "0.01", "Scales", "2 numbers");
  expect_message("0.01, 0.2", "0.01, -1", "Scales", "greater than 0");
  expect_message("Scales = 0.01, 0.2", "Repetition tolerance = 0", "Repetition tolerance",
                 "greater than 0");
  expect_message("Scales = 0.01, 0.2", "Longest repetition = 0", "Longest repetition", "1");
}

TEST(BrokenInputCharacterTest, Lyapunov) {
  expect_message("Blocks = 5", "Blocks = 1", "Blocks", "2");
  expect_message("Blocks = 5", "Discarded share = 1", "Discarded share", "1");
  expect_message("Blocks = 5", "Exponents = 3", "Exponents", "at most 2");
  expect_message("Blocks = 5", "Exponents = -1", "Exponents", "0");
}

TEST(BrokenInputCharacterTest, Spectrum) {
  expect_message("  set Contacts = heads", "  set Contacts = tails", "Contacts", "heads");
  expect_message("  set Contacts = heads", "  set Points = none", "Points", "Contacts");
  expect_message("  set Contacts = heads", "  set Window = triangle", "Window", "hann");
  expect_message("  set Contacts = heads", "  set Orders = 0", "Orders", "1");
}

TEST(BrokenInputCharacterTest, Wavelet) {
  expect_message("Highest frequency = 20 Hz", "Highest frequency = 1 Hz", "Highest frequency",
                 "greater than Lowest frequency");
  expect_message("Sampling interval = 10 ms", "Sampling interval = 30 ms", "Sampling interval",
                 "half a period");
  expect_message("    set Sampling interval = 10 ms\n", "", "Sampling interval", "must be given");
  expect_message("    set Lowest frequency = 1 Hz\n", "", "Lowest frequency", "must be given");
  expect_message("Sampling interval = 10 ms", "Sampling interval = 10 ms\n    set Bump width = 6",
                 "Bump width", "less than Bump centre");
}

TEST(BrokenInputCharacterTest, Spectrogram) {
  expect_message("Interval = 1 s", "Interval = 20 ms", "Interval", "four times Sampling interval");
  expect_message("    set Interval = 1 s\n", "", "Interval", "must be given");
}

} // namespace broken_input_character_tests
} // namespace vibroimpact
