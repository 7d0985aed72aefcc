// Interfaces and contacts of many pairs that cannot be used as given: what the message says.
#include "support/broken_files.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace broken_input_contacts_tests {

using testing::changed;
using testing::expect_messages;
using testing::message_of;

std::string beam(const std::string &name, const std::string &x) {
  return "subsection Body " + name +
         R"(
  subsection Geometry
    set Line = )" +
         x + ", 0 m, 0 m -> " + x + R"(, 0 m, 1 m
    set Elements = 4
  end
  subsection Section
    set Width = 30 mm
    set Thickness = 5 mm
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 8000 kg/m^3
  end
  subsection Support root
    set At = start
    set Fix = all
  end
  subsection Point tip
    set At = end
  end
  subsection Interface face
    set Near = )" +
         x + ", 0 m, 0.5 m, " + x + ", 0 m, 1 m\n" + R"(  end
  subsection Modes
    set Number = 3
    set Attachments = face.x
  end
end
)";
}

const std::string sound =
    "set Analyses = shapes\n" + beam("left", "0 m") + beam("right", "0.1 m") + R"(
subsection Contact gap
  set Between = left.face, right.face
  set Pairing = proximity
  set Search radius = 10 mm
  set Offset = 5 mm
  set Stiffness fraction = 2
end
subsection Analysis shapes
  set Type = modal
end
)";

TEST(BrokenInputContactsTest, Interfaces) {
  const std::string near = "set Near = 0 m, 0 m, 0.5 m, 0 m, 0 m, 1 m";
  const std::string grid = "set Grid = 0 m, 0 m, 0 m -> 0 m, 0 m, 1 m\n    ";
  expect_messages(
      sound,
      {{"unknown group", near, "set At = roof", {"Interface face", "At", "start", "end"}},
       {"two coordinates", near, "set Near = 0 m, 0 m, 0.5 m, 0 m", {"Near", "three coordinates"}},
       {"one node twice",
        near,
        "set Near = 0 m, 0 m, 0.5 m, 0 m, 0 m, 0.55 m",
        {"Interface face", "Near", "positions 1 and 2"}},
       {"too fine a grid", near, grid + "set Grid points = 9", {"Grid", "nearest to positions"}},
       {"no number of points", near, grid, {"Interface face", "Grid points"}},
       {"two numbers for a line", near, grid + "set Grid points = 2, 3", {"Grid points", "a line"}},
       {"half a point", near, grid + "set Grid points = 2.5", {"Grid points", "whole"}},
       {"both ways", near, near + "\n    " + grid + "set Grid points = 2", {"Grid", "Near"}},
       {"name of a point",
        "subsection Interface face",
        "subsection Interface tip",
        {"Interface tip", "share its name", "Point tip"}},
       {"unknown attachment", "face.x", "faces.x", {"Attachments", "faces.x", "did you mean"}},
       {"rotation of an attachment", "face.x", "face.rx", {"Attachments", "face.rx"}}});
}

TEST(BrokenInputContactsTest, Proximity) {
  const std::string radius = "  set Search radius = 10 mm\n";
  expect_messages(
      sound,
      {{"unknown interface",
        "left.face, right",
        "left.fare, right",
        {"Contact gap", "Between", "left.fare", "did you mean"}},
       {"point instead of interface", "left.face, right", "left.tip, right", {"left.tip"}},
       {"one side only", "left.face, right.face", "left.face", {"Between", "BODY.INTERFACE"}},
       {"against a stop", "left.face, right.face", "left.face, stop", {"Between", "stop"}},
       {"with itself", "left.face, right.face", "left.face, left.face", {"Between", "different"}},
       {"no radius", radius, "", {"Search radius", "must be given"}},
       {"negative radius", "radius = 10 mm", "radius = -1 mm", {"Search radius", "-1 mm"}},
       {"no pair",
        radius,
        radius + "  set Direction = z\n",
        {"Search radius", "left.face", "right.face", "0.1 m", "across the direction"}},
       {"out of reach", radius, radius + "  set Reach = 50 mm\n", {"find a pair", "0.1 m along"}},
       {"wrong way round",
        radius,
        radius + "  set Direction = -x\n",
        {"overlap", "-0.105 m", "Prestressed"}},
       {"too thick", "Offset = 5 mm", "Offset = 120 mm", {"overlap", "-0.02 m", "Offset"}},
       {"clearance twice", radius, radius + "  set Clearance = 1 mm\n", {"Offset", "Clearance"}},
       {"negative clearance",
        "  set Offset = 5 mm\n",
        "  set Clearance = -1 mm\n",
        {"Clearance", "Prestressed"}},
       {"direction and line",
        radius,
        radius + "  set Normal = joining line\n  set Direction = x\n",
        {"Direction", "joining line"}},
       {"reach of a line",
        radius,
        radius + "  set Normal = joining line\n  set Reach = 1 m\n",
        {"Reach", "joining line"}}});
}

TEST(BrokenInputContactsTest, OtherPairings) {
  const std::string list = changed(sound, "proximity\n  set Search radius = 10 mm", "list");
  expect_messages(list, {{"other number of nodes",
                          "set Near = 0 m, 0 m, 0.5 m, 0 m, 0 m, 1 m",
                          "set Near = 0 m, 0 m, 0.5 m",
                          {"Between", "left.face has 1", "right.face has 2"}},
                         {"radius of a list",
                          "Pairing = list\n",
                          "Pairing = list\n  set Search radius = 1 m\n",
                          {"Search radius", "Pairing = list"}},
                         {"half a pair",
                          "Pairing = list\n",
                          "Pairing = list\n  set Pairs = 1, 1, 2\n",
                          {"Pairs", "two numbers for each pair", "3 numbers"}},
                         {"no such node",
                          "Pairing = list\n",
                          "Pairing = list\n  set Pairs = 1, 7\n",
                          {"Pairs", "right.face has the nodes 1 to 2", "7"}},
                         {"part of a node",
                          "Pairing = list\n",
                          "Pairing = list\n  set Pairs = 1.5, 1\n",
                          {"Pairs", "whole numbers", "1.5"}},
                         {"a pair twice",
                          "Pairing = list\n",
                          "Pairing = list\n  set Pairs = 1, 2, 1, 2\n",
                          {"Pairs", "twice"}}});
  expect_messages(sound, {{"pairs by proximity",
                           "Pairing = proximity\n",
                           "Pairing = proximity\n  set Pairs = 1, 1\n",
                           {"Pairs", "Pairing = proximity"}}});
  const std::string stops =
      changed(changed(sound, "proximity\n  set Search radius = 10 mm\n  set Offset = 5 mm",
                      "stops\n  set Clearance = 1 mm"),
              "left.face, right.face", "left.face, stop");
  expect_messages(
      stops,
      {{"no clearance", "  set Clearance = 1 mm\n", "", {"Clearance", "must be given"}},
       {"two interfaces", "left.face, stop", "left.face, right.face", {"Between", "right.face"}},
       {"along the line",
        "Pairing = stops\n",
        "Pairing = stops\n  set Offset = 1 mm\n",
        {"Offset"}},
       {"radius without pairing",
        "left.face, stop\n  set Pairing = stops\n",
        "left.tip, stop\n  set Reach = 1 mm\n",
        {"Reach", "Pairing = points"}},
       {"interface without pairing", "  set Pairing = stops\n", "", {"Between", "left.face"}}});
}

TEST(BrokenInputContactsTest, StiffnessFraction) {
  expect_messages(
      sound, {{"zero", "fraction = 2", "fraction = 0", {"Stiffness fraction", "greater than 0"}},
              {"and a stiffness",
               "  set Stiffness fraction = 2\n",
               "  set Stiffness fraction = 2\n  subsection Linear penalty\n    set Stiffness = 1 "
               "N/m\n  end\n",
               {"Linear penalty", "Stiffness fraction"}},
              {"of a law without stiffness",
               "  set Stiffness fraction = 2\n",
               "  set Stiffness fraction = 2\n  set Law = hertz\n",
               {"Stiffness fraction", "hertz"}},
              {"share above one",
               "  set Stiffness fraction = 2\n",
               "  set Stiffness fraction = 2\n  set Least flexibility share = 1.5\n",
               {"Least flexibility share"}}});
}

TEST(BrokenInputContactsTest, AFreeBodyHasNoLocalStiffness) {
  const std::string free = changed(
      sound, "  subsection Support root\n    set At = start\n    set Fix = all\n  end\n", "");
  const std::string message = message_of(changed(free, "set Number = 3\n", "set Number = 8\n"));
  EXPECT_NE(message.find("Stiffness fraction"), std::string::npos) << message;
  EXPECT_NE(message.find("without supports"), std::string::npos) << message;
}

} // namespace broken_input_contacts_tests
} // namespace vibroimpact
