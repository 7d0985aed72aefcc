// Sections, members, hinges and masses of beam bodies from text.
#include "reduction/beam_parameters.h"

#include "reduction/parameter_files.h"

#include <gtest/gtest.h>

namespace beam_parameters_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

std::string in_section(const std::string &lines) { return inside(head_beam(), "Section", lines); }

std::string member(const std::string &lines) {
  return head_beam(section("Member root", "set Between = 0 mm, 150 mm\n" + lines));
}

std::string hinge(const std::string &lines) {
  return head_beam(section("Member root", "set Between = 0 mm, 150 mm\n") +
                   section("Hinge joint", "set Position = 0 m, 0 m, 150 mm\n" + lines));
}

std::string head(const std::string &lines) { return inside(head_beam(), "Point head", lines); }

} // namespace

TEST(BeamParameters, TheoryAndTaperAreRead) {
  const auto section = definition_of(in_section("set Theory = Timoshenko\n"
                                                "set Shear correction = 0.8, 0.9\n"
                                                "set End thickness = 0.5 mm\n"))
                           .beam.section;
  EXPECT_EQ(section.theory, structure::BeamTheory::timoshenko);
  EXPECT_EQ(section.shear_correction, (std::array<double, 2>{0.8, 0.9}));
  EXPECT_DOUBLE_EQ(section.end_thickness, 5e-4);
}

TEST(BeamParameters, AMemberHasTheBodysSectionUnlessItGivesItsOwn) {
  const auto plain = definition_of(member("set Axial force = -3 N\n")).beam.members.at(0);
  EXPECT_DOUBLE_EQ(plain.section.width, 0.03);
  EXPECT_DOUBLE_EQ(plain.material.young_modulus, 206e9);
  EXPECT_DOUBLE_EQ(plain.axial_force.start, -3);
  EXPECT_DOUBLE_EQ(plain.axial_force.end, -3);
  EXPECT_DOUBLE_EQ((*plain.between)[1], 0.15);
  const auto own = definition_of(member("set Shape = circle\nset Diameter = 2 mm\n"
                                        "set Young modulus = 70 GPa\nset Offset = 1 mm, 2 mm\n"))
                       .beam.members.at(0);
  EXPECT_EQ(own.section.kind, structure::SectionShape::Kind::circle);
  EXPECT_DOUBLE_EQ(own.material.young_modulus, 70e9);
  EXPECT_DOUBLE_EQ(own.material.density, 7850);
  EXPECT_EQ(own.offset, (std::array<double, 2>{0.001, 0.002}));
}

TEST(BeamParameters, HingesPlanesAndInertiaAreRead) {
  const BodyDefinition hinged = definition_of(hinge("set Member = root\nset Free = x, ry\n"));
  EXPECT_EQ(hinged.beam.hinges.at(0).free,
            (std::array<bool, 6>{true, false, false, false, true, false}));
  EXPECT_EQ(definition_of(head_beam("set Planar = zx\n")).beam.plane_normal, 1);
  EXPECT_FALSE(definition_of(head_beam()).beam.plane_normal);
  const auto point = definition_of(head("set Rotary inertia = 1 kg m^2, 2 kg m^2, 2 kg m^2\n"
                                        "set Products of inertia = 0 kg m^2, 1 kg m^2, 0 kg m^2\n"
                                        "set Offset = 1 cm, 2 cm, 3 cm\n"))
                         .beam.points.at(0);
  EXPECT_EQ(point.offset, Vector3(0.01, 0.02, 0.03));
  EXPECT_EQ(point.products_of_inertia, Vector3(0, 1, 0));
}

TEST(BeamParameters, SectionErrorsAreClear) {
  expect_message(in_section("set Shear correction = 0.8\n"),
                 {"Section", "Shear correction", "when Theory = Euler-Bernoulli"});
  expect_message(in_section("set End diameter = 1 mm\n"),
                 {"End diameter", "must not be set when Shape = rectangle"});
  expect_message(in_section("set Theory = Timoshenko\nset Shear correction = 1.2\n"),
                 {"Shear correction", "1.2"});
  expect_message(member("set Shape = given\nset Area = 1 mm^2\nset Second moment y = 1 mm^4\n"
                        "set Second moment z = 1 mm^4\nset Torsion constant = 1 mm^4\n"
                        "set Theory = Timoshenko\n"),
                 {"Member root", "Shear correction", "Shape = given"});
}

TEST(BeamParameters, MemberErrorsAreClear) {
  expect_message(member("set On = start\n"), {"Member root", "On", "when Between is set"});
  expect_message(head_beam(section("Member root", "set On = legs\n")),
                 {"Member root", "On", "must be one of: all"});
  expect_message(member("set Diameter = 1 mm\n"),
                 {"Member root", "Diameter", "must not be set when Shape = rectangle"});
  expect_message(member("set Width = 1 mm\n"), {"Member root", "Thickness"});
  expect_message(head_beam(section("Member root", "set Between = 0.2 m, 0.1 m\n")),
                 {"Member root", "Between", "ascending"});
}

TEST(BeamParameters, HingeErrorsAreClear) {
  expect_message(hinge("set Free = ry\n"), {"Hinge joint", "Member"});
  expect_message(hinge("set Member = leg\nset Free = ry\n"), {"Hinge joint", "Member", "root"});
  expect_message(hinge("set Member = root\n"), {"Hinge joint", "Free"});
  expect_message(hinge("set Member = root\nset Free = turn\n"), {"Hinge joint", "Free", "turn"});
}

TEST(BeamParameters, PointAndPlaneErrorsAreClear) {
  expect_message(head("set Rotary inertia = 1 kg m^2, 1 kg m^2, 1 kg m^2\n"
                      "set Products of inertia = 2 kg m^2, 0 kg m^2, 0 kg m^2\n"),
                 {"Point head", "Products of inertia", "principal moment"});
  expect_message(head_beam(section("Point odd", "set At = end\nset Offset = 1 m, 0 m, 0 m\n")),
                 {"Point odd", "Offset", "when Mass is 0 kg"});
  expect_message("subsection Body left\nset Type = lumped\nset Planar = xy\n" +
                     section("Mass ball", "set Mass = 1 kg\n") + "end\n",
                 {"Planar", "Type = lumped"});
}

TEST(BeamParameters, RigidLinksAreReadAndTheirErrorsAreClear) {
  const auto link = [](const std::string &lines) {
    return head_beam(section("Member tip", "set Between = 200 mm, 300 mm\n") +
                     section("Rigid link bar", lines));
  };
  const auto read = definition_of(link("set At = end\nset Points = head\nset Members = tip\n"));
  EXPECT_EQ(read.beam.links.at(0).groups, std::vector<std::string>{"end"});
  EXPECT_EQ(read.beam.links.at(0).points, std::vector<std::string>{"head"});
  EXPECT_EQ(read.beam.links.at(0).members, std::vector<std::string>{"tip"});
  expect_message(link(""), {"Rigid link bar", "At, Points or Members"});
  expect_message(link("set At = end\nset Points = head\n"), {"Rigid link bar", "two nodes"});
  expect_message(link("set At = side\n"), {"Rigid link bar", "At", "end, start"});
  expect_message(link("set Points = tail\n"), {"Rigid link bar", "Points", "'tail'", "head"});
  expect_message(link("set Members = tail\n"), {"Rigid link bar", "Members", "'tail'"});
  expect_message(head_beam(section("Member tip", "set Between = 200 mm, 300 mm\n"
                                                 "set Axial force = 1 N\n") +
                           section("Rigid link bar", "set Members = tip\n")),
                 {"Member tip", "Axial force", "within a Rigid link"});
  expect_message(link("set Members = tip\n"), {"accepted"});
  expect_message("subsection Body left\nset Type = lumped\n" +
                     section("Mass ball", "set Mass = 1 kg\n") + section("Rigid link bar", "") +
                     "end\n",
                 {"Type", "lumped", "Rigid link"});
}

TEST(BeamParameters, AttachmentsAtRigidLinksNeedTheFreeInterface) {
  const auto held = [](const std::string &reduction) {
    return head_beam(
        section("Member tip", "set Between = 200 mm, 300 mm\n") +
        section("Rigid link bar", "set Members = tip\n") +
        section("Modes", "set Attachments = head.x\nset Reduction = " + reduction + "\n"));
  };
  expect_message(held("fixed interface"), {"Attachments", "Rigid link"});
  expect_message(held("free interface"), {"accepted"});
}

// Euler: pi^2 EI / 4 L^2 = 5.956 N for the cantilever of these files, the next loads 9 and 25 times
// as large.
TEST(BeamParameters, CompressionBeyondTheBucklingLoadIsRefused) {
  const auto compressed = [](const std::string &force) {
    return head_beam(section("Member all", "set Axial force = " + force + "\n"));
  };
  expect_message(compressed("-30 N"), {"Body left", "Axial force", "first buckling load"});
  expect_message(compressed("-100 N"), {"2 buckling loads"});
  const double unloaded = reduced_text(head_beam(), ".", MPI_COMM_SELF).omega()[0];
  const double loaded = reduced_text(compressed("-5 N"), ".", MPI_COMM_SELF).omega()[0];
  EXPECT_LT(loaded, unloaded);
}

} // namespace beam_parameters_tests
