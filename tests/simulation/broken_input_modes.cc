// Bodies given by their modes that cannot be used: what the message says.
#include "common/hdf5_file.h"
#include "support/simulation_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vibroimpact {
namespace broken_input_modes_tests {

using testing::changed;
using testing::message_of;
using testing::TemporaryFolder;

class BrokenInputModesTest : public ::testing::Test {
protected:
  BrokenInputModesTest() {
    write("modes.csv",
          "mode,frequency,damping ratio,tip.z,middle.z\n1,10,0.01,2,1\n2,60,0.01,-2,1\n");
    write("empty.csv", "");
    Hdf5File file = Hdf5File::create(folder_.path() / "modes.h5");
    for (const std::string body : {"one", "two"}) {
      const std::string path = "/body/" + body + "/";
      file.write(path + "frequency", {2}, std::vector<double>{10, 60});
      file.set_attribute(path + "frequency", "unit", body == "one" ? "Hz" : "1");
      file.write(path + "damping_ratio", {2}, std::vector<double>{0.01, 0.01});
      file.write(path + "mass", {2}, std::vector<double>{1, 1});
      file.write(path + "point", {1}, std::vector<std::string>{"tip"});
    }
    file.write("/body/one/point_rows", {1, 3, 2}, std::vector<double>(6, 1));
    file.close();
    sound_ = "set File folder = " + folder_.path().string() + R"(
subsection Body plate
  set Type = modes
  subsection Modal data
    set File = modes.csv
    set Normalisation = unit modal mass
  end
  subsection Point tip
    set Position = 1 m, 0 m, 0 m
    set Static stiffness = 0 N/m, 0 N/m, 900 N/m
  end
end
subsection Contact stop
  set Between = plate.tip, stop
  set Direction = z
  set Clearance = 1 mm
  set Law = linear penalty
  subsection Linear penalty
    set Stiffness = 1e5 N/m
  end
end
subsection Analysis motion
  set Type = transient
  subsection Transient
    set Duration = 0.01 s
    set Sampling interval = 0.001 s
  end
end
)";
  }

  void write(const std::string &name, const std::string &text) {
    std::ofstream(folder_.path() / name) << text;
  }

  void expect(const std::string &from, const std::string &to,
              const std::vector<std::string> &parts) const {
    const std::string message = message_of(changed(sound_, from, to));
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n"
                                                       << message;
  }

  const TemporaryFolder folder_;
  std::string sound_;
};

const std::string file_line = "set File = modes.csv";
const std::string both_lines = "set File = modes.csv\n    set Normalisation = unit modal mass";

TEST_F(BrokenInputModesTest, TheSoundFileIsAccepted) { EXPECT_EQ(message_of(sound_), ""); }

TEST_F(BrokenInputModesTest, Files) {
  expect(file_line, "", {"Body plate / Modal data / File", "must be given when Type = modes"});
  expect(file_line, "set File = none.csv", {"none.csv", "must name a file that can be read"});
  expect(file_line, "set File = empty.csv", {"must name a file that can be read and is not empty"});
  expect(file_line, "set File = modes.csv\n set Separator = space",
         {"modes.csv", "is the separator right?"});
  expect(file_line, "set File = modes.csv\n set Body = one",
         {"Body", "must not be set when File is a table"});
}

TEST_F(BrokenInputModesTest, Hdf5Files) {
  const auto with = [](const std::string &keys) { return "set File = modes.h5\n" + keys; };
  expect(both_lines, with(""), {"must be set to one of the bodies in the file: one, two"});
  expect(both_lines, with("set Body = ones"), {"Body = ones", "did you mean 'one'?"});
  expect(both_lines, with("set Body = one"),
         {"/body/one/point_rows", "1 x 6 x 2", "but it has 1 x 3 x 2"});
  expect(both_lines, with("set Body = two"), {"frequencies in Hz", "'1'"});
  expect(both_lines, with("set Separator = comma"), {"must not be set when File is an HDF5 file"});
  write("modes.h5", "no HDF5");
  expect(both_lines, with(""), {"must be an HDF5 file that can be read"});
}

TEST_F(BrokenInputModesTest, Keys) {
  expect("Normalisation = unit modal mass", "Normalisation = modal mass",
         {"Normalisation = modal mass", "must be unit modal mass"});
  expect(file_line, file_line + "\n set Damping ratio = 0.01",
         {"Damping ratio", "must not be set when the file gives damping ratios"});
  expect(file_line, file_line + "\n set Number = 3", {"Number = 3", "modes in the file, 2"});
  expect(file_line, file_line + "\n set Residual frequency = 80 Hz",
         {"Residual frequency", "must not be set without Attachments"});
  expect(file_line, file_line + "\n set Attachments = tip.z\n set Residual frequency = 50 Hz",
         {"Residual frequency = 50 Hz", "must be greater", "60 Hz"});
  expect(file_line, file_line + "\n set Attachments = tip",
         {"POINT.x, POINT.y or POINT.z", "'tip'"});
  expect(file_line, file_line + "\n set Attachments = tip.x", {"that of tip.x is not"});
  expect(file_line, file_line + "\n set Attachments = top.z", {"it has no point top"});
  expect(file_line, file_line + "\n set Lines = tip", {"Lines = tip", "must be chains of points"});
  expect(file_line, file_line + "\n set Lines = tip -> medium",
         {"must run between points of the file: tip, middle"});
}

TEST_F(BrokenInputModesTest, Points) {
  expect("Point tip", "Point top", {"Point top", "must be one of the points in the file: tip"});
  expect("Position = 1 m, 0 m, 0 m", "At = end", {"At = end", "must not be set when Type = modes"});
  expect("900 N/m", "2 kN/m", {"Static stiffness", "must not be greater along z than"});
  expect("900 N/m", "900 N/m\n set Residual flexibility = 1e-5 m/N, 0 m/N, 0 m/N",
         {"Residual flexibility", "must not be set when Static stiffness is set"});
}

TEST_F(BrokenInputModesTest, Sections) {
  expect("set Type = modes", "set Type = modes\n subsection Modes\n set Number = 2\n end",
         {"Type = modes", "must not be modes when there is a subsection Modes"});
  expect("set Type = modes", "set Type = modes\n set Planar = xy",
         {"Planar", "must not be set when Type = modes"});
  expect("set Type = modes", "set Type = lumped",
         {"Type = lumped", "when there is a subsection Modal data"});
  expect("set Type = modes", "set Type = beam",
         {"Type = beam", "when there is a subsection Modal data"});
}

TEST_F(BrokenInputModesTest, TheBaseNeedsTheirParticipation) {
  const std::string shake = R"(subsection Excitation shake
  set Direction = z
  set Amplitude = 1 m/s^2
  set Frequency = 3 Hz
end
subsection Analysis)";
  expect("subsection Analysis", shake,
         {"Excitation shake", "Bodies", "modes of plate come without their participation"});
}

TEST_F(BrokenInputModesTest, AChangedFileIsRefused) {
  expect("set File folder", "set File checksums = modes.csv 0123456789abcdef\nset File folder",
         {"File = modes.csv", "its content is not what it was"});
}

} // namespace broken_input_modes_tests
} // namespace vibroimpact
