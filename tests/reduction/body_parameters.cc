#include "reduction/body_parameters.h"

#include "reduction/parameter_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace body_parameters_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;
using vibroimpact::testing::TemporaryFolder;

namespace {

const std::string line = "    set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 30 cm\n";
const std::string elements = "    set Elements = 20\n";
const std::string density = "    set Density = 7850 kg/m^3\n";

std::string lumped(const std::string &lines) {
  return "subsection Body left\n  set Type = lumped\n" + lines + "end\n";
}

} // namespace

TEST(BodyParameters, ABeamIsRead) {
  const std::string more =
      section("Support spring", "set At = end\nset Stiffness = 1 N/m, 2 N/m, 3 kN/m\n"
                                "set Rotational stiffness = 4 N m/rad, 5 N m/rad, 6 N m/rad\n") +
      section("Modes", "set Number = 7\nset Damping ratio = 0.01, 0.02\n");
  const BodyDefinition body =
      definition_of(inside(head_beam(more), "Geometry", "set Orientation = 0, 1, 1\n"));
  EXPECT_EQ(body.type, BodyDefinition::Type::beam);
  EXPECT_EQ(body.beam.line.elements, 20);
  EXPECT_EQ(body.beam.line.end, Vector3(0, 0, 0.3));
  EXPECT_EQ(body.beam.local_y, Vector3(0, 1, 1));
  EXPECT_DOUBLE_EQ(body.beam.section.thickness, 0.00075);
  EXPECT_DOUBLE_EQ(body.beam.material.young_modulus, 206e9);
  ASSERT_EQ(body.beam.supports.size(), 3U);
  EXPECT_EQ(body.beam.supports[1].fixed,
            (std::array<bool, 6>{false, true, true, true, false, true}));
  EXPECT_EQ(body.beam.supports[2].stiffness, (std::array<double, 6>{1, 2, 3000, 4, 5, 6}));
  EXPECT_EQ(body.beam.points[0].name, "head");
  EXPECT_DOUBLE_EQ(body.beam.points[0].mass, 0.0577114);
  EXPECT_EQ(body.selection.number, 7);
  EXPECT_EQ(body.damping.ratios, (std::vector<double>{0.01, 0.02}));
}

TEST(BodyParameters, BandAndDampingModelsAreRead) {
  const BodyDefinition viscous = definition_of(
      head_beam(section("Modes", "set Band = 1 Hz, 100 Hz\nset Damping model = viscous\n"
                                 "set Viscous constant = 0.2 N s/m\n")));
  ASSERT_TRUE(viscous.selection.band);
  EXPECT_DOUBLE_EQ((*viscous.selection.band)[1], 200 * M_PI);
  EXPECT_EQ(viscous.damping.model, Damping::Model::viscous);
  EXPECT_DOUBLE_EQ(viscous.damping.viscous_constant, 0.2);
  const BodyDefinition rayleigh = definition_of(
      head_beam(section("Modes", "set Damping model = rayleigh\nset Rayleigh alpha = 2/s\n"
                                 "set Rayleigh beta = 3 ms\n")));
  EXPECT_DOUBLE_EQ(rayleigh.damping.alpha, 2);
  EXPECT_DOUBLE_EQ(rayleigh.damping.beta, 0.003);
}

TEST(BodyParameters, ALumpedBodyIsRead) {
  const BodyDefinition body = definition_of(
      lumped(section("Mass ball", "set Mass = 2 kg\nset Axis = z\nset Stiffness = 8 N/m\n"
                                  "set Damping = 1 N s/m\nset Position = 1 m, 2 m, 3 m\n")));
  ASSERT_EQ(body.masses.size(), 1U);
  EXPECT_EQ(body.masses[0].name, "ball");
  EXPECT_EQ(body.masses[0].axes, std::vector<int>{2});
  EXPECT_DOUBLE_EQ(body.masses[0].mount.stiffness, 8);
  EXPECT_EQ(body.masses[0].position, Vector3(1, 2, 3));
}

TEST(BodyParameters, ReducedFromTextIsCaseS) {
  const ReducedBody body = reduced_text(head_beam(), ".", MPI_COMM_SELF);
  EXPECT_EQ(body.size(), 5);
  EXPECT_NEAR(body.omega()[0] / (2 * M_PI), 2.95, 2e-6);
}

TEST(BodyParameters, GeometryErrorsAreClear) {
  const std::string empty = without(without(head_beam(), line), elements);
  expect_message(empty,
                 {"Geometry / Line", "must be given when Type = beam and Mesh is not given"});
  expect_message(inside(head_beam(), "Geometry", "set Mesh = beam.msh\n"),
                 {"Line", "Line must not be set when Mesh is set"});
  expect_message(inside(without(head_beam(), line), "Geometry", "set Mesh = beam.msh\n"),
                 {"Elements", "Elements must not be set when Mesh is set"});
  expect_message(inside(empty, "Geometry", "set Mesh = none.msh\n"),
                 {"test.prm", "Mesh", "none.msh", "can be read"});
  expect_message(inside(empty, "Geometry", "set Line = 1 m, 0 m, 0 m -> 1 m, 0 m, 0 m\n"),
                 {"Line", "two different ends"});
  expect_message(inside(head_beam(), "Geometry", "set Orientation = 0, 0, 2\n"),
                 {"Orientation", "parallel"});
}

TEST(BodyParameters, SectionAndMaterialErrorsAreClear) {
  expect_message(without(head_beam(), "    set Width = 30 mm\n"), {"Width", "must be given"});
  expect_message(inside(head_beam(), "Section", "set Diameter = 1 mm\n"),
                 {"Diameter", "must not be set when Shape = rectangle"});
  expect_message(without(head_beam(), "    set Young modulus = 206 GPa\n"), {"Young modulus"});
  expect_message(without(head_beam(), density), {"Density"});
  const std::string massless = without(without(head_beam(), density), "    set Mass = 57.7114 g\n");
  expect_message(inside(massless, "Material", "set Density = 0 kg/m^3\n"),
                 {"Density", "without lumped masses"});
}

TEST(BodyParameters, SupportErrorsAreClear) {
  expect_message(head_beam(section("Support odd", "set At = end\nset Fix = x, phi\n")),
                 {"Support odd", "Fix", "phi"});
  expect_message(head_beam(section("Support odd", "set At = middle\nset Fix = x\n")),
                 {"Support odd", "At", "end, start, all"});
  expect_message(head_beam(section("Support odd", "set At = end\n")), {"Support odd", "Fix"});
  expect_message(head_beam(section("Support odd", "set Fix = all\n")),
                 {"Support odd / At", "must be given when Position, Near and Node are not given"});
  expect_message(
      head_beam(section("Support odd", "set At = end\nset Stiffness = -1 N/m, 0 N/m, 0 N/m\n")),
      {"Support odd", "Stiffness"});
}

TEST(BodyParameters, PointErrorsAreClear) {
  expect_message(head_beam(section("Point odd", "set Position = 0.001 m, 0 m, 0.15 m\n")),
                 {"Point odd", "Position", "nearest", "0.15) m"});
  expect_message(head_beam(section("Point odd", "set At = all\n")),
                 {"Point odd", "exactly one node", "21"});
}

TEST(BodyParameters, ModesErrorsAreClear) {
  expect_message(head_beam(section("Modes", "set Number = 41\n")),
                 {"Modes", "Number", "degrees of freedom with mass, 40"});
  expect_message(head_beam(section("Modes", "set Number = 3\nset Band = 1 Hz, 2 Hz\n")),
                 {"Number", "must not be set when Band is set"});
  expect_message(head_beam(section("Modes", "set Band = 2 Hz, 2 Hz\n")), {"Band", "greater upper"});
  expect_message(head_beam(section("Modes", "set Rayleigh alpha = 2/s\n")),
                 {"Rayleigh alpha", "must not be set when Damping model = ratio"});
  expect_message(head_beam(section("Modes", "set Damping model = viscous\n")),
                 {"Viscous constant"});
}

TEST(BodyParameters, LumpedErrorsAreClear) {
  expect_message(lumped(""), {"Body left", "Mass"});
  expect_message(lumped(section("Mass ball", "set Axis = x\n")), {"Mass ball", "Mass"});
  expect_message(lumped(section("Point tip", "set At = end\n")), {"Type", "Mass"});
  expect_message(head_beam(section("Mass ball", "set Mass = 1 kg\n")), {"Type", "Mass"});
}

TEST(BodyParameters, MeshFilesAreFoundBesideTheParameterFile) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "two.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                              "$Nodes\n2\n1 0 0 0\n2 0 0 1\n$EndNodes\n"
                                              "$Elements\n3\n1 15 2 4 4 1\n2 15 2 5 5 2\n"
                                              "3 1 2 6 6 1 2\n$EndElements\n";
  const std::string text =
      "subsection Body left\n" + section("Geometry", "set Mesh = two.msh\n") +
      section("Section", "set Shape = circle\nset Diameter = 1 cm\n") +
      section("Material", "set Young modulus = 1 GPa\nset Density = 1 kg/m^3\n") +
      section("Support root", "set At = 4\nset Fix = all\n") +
      section("Modes", "set Number = 6\n") + "end\n";
  const ReducedBody body = reduced_text(text, folder.path().string(), MPI_COMM_SELF);
  EXPECT_EQ(body.size(), 6);
  EXPECT_EQ(body.recovery.nodes.cols(), 2);
}

} // namespace body_parameters_tests
