// What a parameter file says about a shell body, and what it may not say.
#include "reduction/shell_parameters.h"

#include "reduction/parameter_files.h"

#include <gtest/gtest.h>

namespace shell_parameters_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

const std::string plate = R"(subsection Body left
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m -> 0 m, 1 m, 0 m
    set Divisions = 4, 2
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 8000 kg/m^3
  end
  subsection Shell deck
    set Thickness = 10 mm
  end
  subsection Stiffener rib
    set On = bottom
    set Width = 5 mm
    set Thickness = 40 mm
    set Offset = 0 mm, -25 mm
    set Young modulus = 70 GPa
  end
  subsection Support left
    set At = left
    set Fix = symmetric x, z
  end
  subsection Support right
    set At = right
    set Fix = all
  end
  subsection Point middle
    set Near = 1.1 m, 0.45 m, 0 m
  end
  subsection Load wind
    set Pressure = 2 kPa
  end
  subsection Load push
    set At = top
    set Force = 1 N, 2 N, 3 N
    set Moment = 4 N m, 5 N m, 6 N m
    set Acceleration = 0 m/s^2, 0 m/s^2, -9.81 m/s^2
  end
  subsection Modes
    set Number = 4
    set Attachments = middle.z
    set Attachment damping ratio = 0.5
  end
end
)";

std::string changed(const std::string &from, const std::string &to) {
  const std::size_t at = plate.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return plate.substr(0, at) + to + plate.substr(at + from.size());
}

} // namespace

TEST(ShellParameters, APlateIsRead) {
  const BodyDefinition body = definition_of(plate);
  const structure::ShellDefinition &shell = body.shell;
  EXPECT_EQ(body.type, BodyDefinition::Type::shell);
  ASSERT_TRUE(shell.plate);
  EXPECT_EQ(shell.plate->first_end, Vector3(2, 0, 0));
  EXPECT_EQ(shell.plate->elements, (std::array<int, 2>{4, 2}));
  ASSERT_EQ(shell.parts.size(), 1U);
  EXPECT_EQ(shell.parts[0].on, "all");
  EXPECT_DOUBLE_EQ(shell.parts[0].thickness, 0.01);
  EXPECT_DOUBLE_EQ(shell.parts[0].material.young_modulus, 200e9);
  EXPECT_DOUBLE_EQ(shell.parts[0].material.poisson_ratio, 0.3);
  ASSERT_EQ(shell.stiffeners.size(), 1U);
  EXPECT_DOUBLE_EQ(shell.stiffeners[0].material.young_modulus, 70e9);
  EXPECT_DOUBLE_EQ(shell.stiffeners[0].material.density, 8000);
  EXPECT_DOUBLE_EQ(shell.stiffeners[0].offset[1], -0.025);
  EXPECT_EQ(shell.supports[0].fixed, (std::array<bool, 6>{true, false, true, false, true, true}));
  EXPECT_TRUE(shell.points[0].at.nearest);
  EXPECT_EQ(shell.loads[0].pressure, 2000);
  EXPECT_EQ(shell.loads[1].force, Vector3(1, 2, 3));
  EXPECT_EQ(shell.loads[1].moment, Vector3(4, 5, 6));
  EXPECT_EQ(shell.loads[1].acceleration, Vector3(0, 0, -9.81));
  ASSERT_EQ(body.attachments.size(), 1U);
  EXPECT_EQ(body.attachments[0].point, "middle");
  EXPECT_EQ(body.attachments[0].axis, 2);
  EXPECT_EQ(body.damping.attachment_ratio, 0.5);
}

TEST(ShellParameters, APlateIsReduced) {
  const ReducedBody body = reduced_text(plate);
  EXPECT_EQ(body.size(), 5);
  EXPECT_EQ(body.recovery.cells.size(), 8U);
  EXPECT_EQ(body.recovery.lines.size(), 4U);
  EXPECT_EQ(body.points[0].position, Vector3(1, 0.5, 0));
  EXPECT_GT(body.points[0].static_displacement[2], 0);
}

TEST(ShellParameters, ACylinderIsRead) {
  const std::string text =
      changed("    set Plate = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m -> 0 m, 1 m, 0 m\n",
              "    set Cylinder = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m\n    set Radius = 30 cm\n"
              "    set Angles = 0 deg, 90 deg\n    set Orientation = 0, 0, 1\n"
              "    set Cell shape = triangle\n");
  const structure::ShellDefinition shell = definition_of(text).shell;
  ASSERT_TRUE(shell.cylinder);
  EXPECT_DOUBLE_EQ(shell.cylinder->radius, 0.3);
  EXPECT_DOUBLE_EQ(shell.cylinder->angles[1], M_PI / 2);
  EXPECT_EQ(shell.cylinder->zero, Vector3(0, 0, 1));
  EXPECT_EQ(shell.cylinder->shape, structure::CellShape::triangle);
}

TEST(ShellParameters, KeysThatDoNotFitAreRefused) {
  const std::string geometry = "    set Plate = 0 m, 0 m, 0 m -> 2 m, 0 m, 0 m -> 0 m, 1 m, 0 m\n";
  expect_message(changed(geometry, ""),
                 {"test.prm", "Geometry / Plate", "Mesh and Cylinder are not given"});
  expect_message(changed(geometry, geometry + "    set Mesh = panel.msh\n"),
                 {"one of Mesh, Plate and Cylinder"});
  expect_message(changed(geometry, geometry + "    set Line = 0 m, 0 m, 0 m -> 1 m, 0 m, 0 m\n"),
                 {"Line", "Line must not be set when Type = shell"});
  expect_message(changed(geometry, geometry + "    set Radius = 1 m\n"),
                 {"Radius", "must not be set when Cylinder is not set"});
  expect_message(changed("Divisions = 4, 2", "Divisions = 4.5, 2"), {"Divisions", "whole numbers"});
  expect_message(changed("-> 0 m, 1 m, 0 m", "-> 4 m, 0 m, 0 m"), {"Plate", "not parallel"});
  expect_message(changed("set Type = shell", "set Type = beam"),
                 {"when there is a subsection Shell"});
  expect_message(changed("  subsection Shell deck\n    set Thickness = 10 mm\n  end\n", ""),
                 {"at least one subsection Shell"});
  expect_message(changed("    set Thickness = 10 mm\n", ""),
                 {"Shell deck", "Thickness", "must be given"});
  expect_message(changed("    set Young modulus = 200 GPa\n", ""),
                 {"Young modulus", "must be given"});
}

TEST(ShellParameters, PlacesThatDoNotExistAreNamed) {
  expect_message(changed("set On = bottom", "set On = middle"),
                 {"Stiffener rib", "bottom, edges, left, right, top, all"});
  expect_message(changed("    set On = bottom\n", ""), {"Stiffener rib", "On", "must be given"});
  expect_message(changed("At = top", "At = roof"), {"Load push", "At", "bottom, edges, left"});
  expect_message(
      changed("    set Thickness = 10 mm\n", "    set Thickness = 10 mm\n    set On = skin\n"),
      {"Shell deck", "On", "must be one of: all"});
  expect_message(changed("symmetric x, z", "symmetric w"), {"Fix", "symmetric w", "symmetric x"});
  expect_message(changed("set Near = 1.1 m", "set Position = 1.1 m"),
                 {"Position", "nearest one is at (1, 0.5, 0) m"});
  expect_message(changed("middle.z", "middle.w"), {"Attachments", "middle.w", "did you mean"});
}

TEST(ShellParameters, LoadsThatDoNothingAreRefused) {
  expect_message(changed("    set Pressure = 2 kPa\n", ""),
                 {"Load wind", "Acceleration or Pressure must be set"});
  expect_message(
      changed("    set Pressure = 2 kPa\n", "    set Pressure = 2 kPa\n    set At = top\n"),
      {"Load wind", "Force or Moment must be set"});
  expect_message(changed("    set At = top\n", ""),
                 {"Load push / At", "Position, Near and Node are not"});
}

TEST(ShellParameters, BeamsHaveNoPressureAndNoPlates) {
  expect_message(head_beam(section("Load wind", "set Pressure = 1 Pa\n")),
                 {"Load wind", "Pressure", "surfaces of a shell"});
  std::string text = head_beam();
  text.insert(text.find("    set Elements"), "    set Divisions = 3, 3\n");
  expect_message(text, {"Divisions", "must not be set when Type = beam"});
}

} // namespace shell_parameters_tests
