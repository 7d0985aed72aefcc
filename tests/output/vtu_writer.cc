#include "output/vtu_writer.h"

#include "output/example_results.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>
#include <map>

namespace vibroimpact::output {
namespace vtu_writer_tests {

using reduction::ReducedBody;

namespace fs = std::filesystem;
using boost::property_tree::ptree;

ptree xml(const fs::path &file) {
  ptree tree;
  boost::property_tree::read_xml(file.string(), tree);
  return tree;
}

/// Numbers of components of the point data, by name.
std::map<std::string, int> point_arrays(const fs::path &file) {
  std::map<std::string, int> arrays;
  const ptree tree = xml(file);
  for (const auto &[tag, array] : tree.get_child("VTKFile.UnstructuredGrid.Piece.PointData"))
    if (tag == "DataArray")
      arrays[array.get<std::string>("<xmlattr>.Name")] =
          array.get("<xmlattr>.NumberOfComponents", 1);
  return arrays;
}

int attribute_of_piece(const fs::path &file, const std::string &name) {
  return xml(file).get<int>("VTKFile.UnstructuredGrid.Piece.<xmlattr>." + name);
}

struct Entry {
  double time;
  std::string file;
};

std::vector<Entry> pvd_entries(const fs::path &file) {
  std::vector<Entry> entries;
  const ptree tree = xml(file);
  for (const auto &[tag, entry] : tree.get_child("VTKFile.Collection"))
    if (tag == "DataSet")
      entries.push_back(
          {entry.get<double>("<xmlattr>.timestep"), entry.get<std::string>("<xmlattr>.file")});
  return entries;
}

const std::map<std::string, int> expected_arrays = {
    {"displacement", 3}, {"rotation", 3}, {"body", 1}};

class VtuWriter : public ::testing::Test {
protected:
  testing::TemporaryFolder temporary;
  fs::path path = temporary.path() / "run";
  RunFolder folder{MPI_COMM_SELF, path, ExistingFolder::refuse, ""};
};

TEST_F(VtuWriter, ModesHaveTheirFrequencyAsTime) {
  const std::vector<ReducedBody> bodies = testing::example_bodies();
  write_mode_files(folder, bodies);
  const std::vector<Entry> entries = pvd_entries(path / "modes.pvd");
  ASSERT_EQ(entries.size(), 6U); // the lumped body has no shapes
  EXPECT_EQ(entries[0].file, "modes/left-mode-001.vtu");
  EXPECT_NEAR(entries[0].time, 2.95, 1e-10);
  EXPECT_EQ(entries[1].file, "modes/right-mode-001.vtu");
  EXPECT_NEAR(entries[1].time, 3.1, 1e-10);
  for (const Entry &entry : entries) {
    EXPECT_EQ(point_arrays(path / entry.file), expected_arrays) << entry.file;
    EXPECT_EQ(attribute_of_piece(path / entry.file, "NumberOfPoints"), 12 * 5);
    EXPECT_EQ(attribute_of_piece(path / entry.file, "NumberOfCells"), 12 * 4);
  }
}

TEST_F(VtuWriter, MotionShowsMeshesAndLumpedPoints) {
  const PointResult release = testing::transient_example().points[0];
  write_motion_files(folder, "release", testing::example_bodies(), {}, release.motion[0]);
  const std::vector<Entry> entries = pvd_entries(path / "release.pvd");
  ASSERT_EQ(entries.size(), 9U);
  const std::vector<std::string> parts = {"frame", "lumped", "supports"};
  for (std::size_t part = 0; part < 3; ++part) {
    EXPECT_EQ(entries[3 + part].file, "release/" + parts[part] + "-00002.vtu");
    EXPECT_EQ(entries[3 + part].time, 0.01);
  }
  EXPECT_EQ(attribute_of_piece(path / entries[3].file, "NumberOfCells"), 2 * 12 * 4);
  EXPECT_EQ(attribute_of_piece(path / entries[4].file, "NumberOfPoints"), 1);
  EXPECT_EQ(attribute_of_piece(path / entries[5].file, "NumberOfPoints"), 2); // clamped ends
  for (const Entry &entry : entries)
    EXPECT_EQ(point_arrays(path / entry.file), expected_arrays) << entry.file;
}

TEST_F(VtuWriter, LumpedBodiesAloneHaveNoModes) {
  write_mode_files(folder, {testing::example_bodies()[2]});
  EXPECT_FALSE(fs::exists(path / "modes.pvd"));
}

/// A quadrilateral and a triangle with a stiffener between them, one mode and a static
/// displacement.
ReducedBody small_shell() {
  ReducedBody body;
  body.name = "panel";
  body.type = "shell";
  body.mass = Vector::Ones(1);
  body.stiffness = Vector::Constant(1, 100);
  body.damping = Matrix::Zero(1, 1);
  body.recovery.nodes.resize(3, 5);
  body.recovery.nodes << 0, 1, 1, 0, 2, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0;
  body.recovery.cells = {structure::cell_of(structure::CellShape::quadrilateral, {0, 1, 2, 3}),
                         structure::cell_of(structure::CellShape::triangle, {1, 4, 2})};
  body.recovery.lines = {{1, 2}};
  body.recovery.shapes = Matrix::Zero(30, 1);
  body.recovery.shapes(6 * 2 + 2, 0) = 4;
  body.recovery.static_displacement = Vector::Constant(30, 0.25);
  return body;
}

TEST_F(VtuWriter, ShellsAreSurfacesWithTheirStiffeners) {
  write_mode_files(folder, {small_shell()});
  const std::vector<Entry> entries = pvd_entries(path / "modes.pvd");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].file, "modes/panel-mode-001.vtu");
  EXPECT_EQ(entries[1].file, "modes/panel-mode-001-lines.vtu");
  EXPECT_EQ(attribute_of_piece(path / entries[0].file, "NumberOfCells"), 2);
  EXPECT_EQ(attribute_of_piece(path / entries[0].file, "NumberOfPoints"), 7);
  EXPECT_EQ(point_arrays(path / entries[0].file), expected_arrays);
  EXPECT_EQ(point_arrays(path / entries[1].file), expected_arrays);
  EXPECT_EQ(attribute_of_piece(path / "static/panel.vtu", "NumberOfCells"), 2);
  EXPECT_TRUE(fs::exists(path / "static/panel-lines.vtu"));
}

TEST_F(VtuWriter, ContactsAreFieldsOfTheMotion) {
  Motion motion;
  motion.time = {0};
  motion.coordinates = {Matrix::Zero(1, 1)};
  motion.base_displacement = {Matrix::Zero(1, 3)};
  const auto arrays_of = [&](const std::string &name) {
    write_motion_files(folder, name, {small_shell()}, {}, motion);
    return point_arrays(path / name / "frame-00001.vtu");
  };
  motion.contacts.push_back({.nodes = {}, .gap = {0.1}, .force = {0}, .peak_force = {0}});
  EXPECT_EQ(arrays_of("none"), expected_arrays) << "no side of the contact is on a mesh";
  motion.contacts[0].nodes.push_back({.body = 0, .node = 3, .push = Vector3::UnitZ()});
  std::map<std::string, int> arrays = expected_arrays;
  arrays.insert(
      {{"contact_force", 3}, {"contact_gap", 1}, {"peak_contact_force", 1}, {"contact_state", 1}});
  EXPECT_EQ(arrays_of("touched"), arrays);
  EXPECT_EQ(point_arrays(path / "touched/frame-00001-lines.vtu"), arrays);
  EXPECT_EQ(point_arrays(path / "touched/stops-00001.vtu"), arrays);
  EXPECT_EQ(attribute_of_piece(path / "touched/stops-00001.vtu", "NumberOfCells"), 1);
  motion.contacts[0].nodes.push_back({.body = 0, .node = 4, .push = -Vector3::UnitZ()});
  arrays_of("between meshes");
  EXPECT_FALSE(fs::exists(path / "between meshes/stops-00001.vtu"));
}

TEST_F(VtuWriter, VelocityAndStressAreFieldsWhereTheyAreKnown) {
  Motion motion;
  motion.time = {0};
  motion.coordinates = motion.velocities = {Matrix::Zero(1, 1)};
  motion.base_displacement = motion.base_velocity = {Matrix::Zero(1, 3)};
  std::map<std::string, int> arrays = expected_arrays;
  arrays.insert({"velocity", 3});
  write_motion_files(folder, "moving", {small_shell()}, {}, motion);
  EXPECT_EQ(point_arrays(path / "moving/frame-00001.vtu"), arrays);
  ReducedBody body = small_shell();
  body.recovery.cell_stress = {.rows = Matrix::Zero(12, 1), .first = {0, 2, 4}};
  write_motion_files(folder, "surfaces", {body}, {}, motion);
  EXPECT_EQ(point_arrays(path / "surfaces/frame-00001-lines.vtu"), arrays);
  body.recovery.line_stress = {.rows = Matrix::Zero(12, 1), .first = {0, 4}};
  arrays.insert({"von_mises_stress", 1});
  write_motion_files(folder, "both", {body}, {}, motion);
  EXPECT_EQ(point_arrays(path / "both/frame-00001-lines.vtu"), arrays);
  arrays.insert({{"von_mises_stress_first_face", 1}, {"von_mises_stress_second_face", 1}});
  EXPECT_EQ(point_arrays(path / "both/frame-00001.vtu"), arrays);
}

TEST_F(VtuWriter, SidesOfBeamsAreAPartOfTheMotion) {
  Motion motion;
  motion.time = {0};
  motion.coordinates = {Matrix::Zero(1, 1)};
  motion.base_displacement = {Matrix::Zero(1, 3)};
  motion.contacts.push_back({.nodes = {{.body = 0, .node = 3, .push = Vector3::UnitZ()}},
                             .gap = {0.1},
                             .force = {0},
                             .peak_force = {0}});
  write_motion_files(folder, "moving", {small_shell()}, {{Matrix::Zero(3, 4)}}, motion);
  const std::vector<Entry> entries = pvd_entries(path / "moving.pvd");
  ASSERT_GE(entries.size(), 3U);
  EXPECT_EQ(entries[2].file, "moving/sections-00001.vtu");
  EXPECT_EQ(attribute_of_piece(path / entries[2].file, "NumberOfCells"), 4);
  EXPECT_EQ(point_arrays(path / entries[2].file), expected_arrays) << "no contact values";
}

TEST_F(VtuWriter, IndexIsCountedFromOne) {
  EXPECT_EQ(index_suffix({}), "");
  EXPECT_EQ(index_suffix({1, 0, 16}), "-2-1-17");
}

} // namespace vtu_writer_tests
} // namespace vibroimpact::output
