#include "reduction/modal_parameters.h"

#include "parameters/text.h"
#include "reduction/body_sections.h"
#include "reduction/named_file.h"

#include <map>

namespace vibroimpact::reduction {

namespace {

using namespace sections;
using parameters::Range;
using parameters::Section;
namespace dimension = parameters::dimension;
namespace range = parameters::range;

constexpr parameters::Dimension flexibility_dimension{.mass = -1, .time = 2};

} // namespace

void declare_modal_data(Section &body) {
  body.subsection("Modal data",
                  "Modes that are known: from a modal test, another program or the results of a "
                  "run. Real modes of a linear body with modal damping.")
      .text("File", "",
            "Relative to the folder of the parameter file. HDF5 (.h5, .hdf5): the layout of "
            "/body/NAME in results.h5. Any other: a table with a line for each mode and the names "
            "of the columns in its first line: frequency [Hz], damping ratio, modal mass [kg], "
            "participation.x [kg] (y, z), and POINT.x (y, z, rx, ry, rz) for the mode shapes at "
            "each point. Lines beginning with # are comments.")
      .required("Type = modes")
      .choice("Separator", "comma", {"comma", "semicolon", "space"}, "Between columns of a table.")
      .text("Body", "",
            "Of an HDF5 file: its body. Without it: the one with the name of this body, or the "
            "only one.")
      .choice("Normalisation", "modal mass",
              {"modal mass", "unit modal mass", "unit largest component"},
              "Of the mode shapes. modal mass: any, with the modal masses in the file; unit modal "
              "mass: Phi^T M Phi = 1 kg, which the file need not say; unit largest component: the "
              "largest displacement of each mode in the file is 1, with the modal masses in the "
              "file.")
      .integer("Number", "", Range{.lower = 1, .upper = 1e5}, "n",
               "The first modes of the file. Without it: all.")
      .quantities("Damping ratio", "", dimension::none, range::non_negative, "\\zeta",
                  "For a file without damping: one for each mode; the last one repeats.", 1,
                  std::numeric_limits<int>::max())
      .names("Attachments", "",
             "Places as POINT.x, POINT.y or POINT.z, or INTERFACE.x and so on for all its points, "
             "whose static flexibility is known: what the modes lack of it is added by residual "
             "modes.")
      .quantity("Residual frequency", "", dimension::frequency, range::positive, "\\omega_r",
                "Of the residual modes, above all others. Without it: the highest frequency of the "
                "modes times the square root of 3.")
      .quantity("Residual damping ratio", "", dimension::none, range::non_negative, "\\zeta_r",
                "Of the residual modes. Without it: that of the last mode.")
      .text("Lines", "",
            "Lines that are drawn between points: A -> B -> C, D -> E. The points need a "
            "Position.");
}

void declare_modal_point(Section &point) {
  point
      .quantities("Static stiffness", "", dimension::stiffness, range::non_negative, "k_s",
                  "Type = modes: force along x, y, z per displacement along it, from a static "
                  "test; 0 where it is not known.",
                  3, 3)
      .quantities("Residual flexibility", "", flexibility_dimension, range::non_negative, "R",
                  "Type = modes: displacement along x, y, z per static force along it that the "
                  "modes lack; 0 where they lack nothing.",
                  3, 3);
}

std::vector<std::string> modal_point_keys() { return {"Static stiffness", "Residual flexibility"}; }

namespace {

ModalPoint read_modal_point(const Values &section, const std::string &name) {
  for (const char *key :
       {"At", "Near", "Mass", "Rotary inertia", "Products of inertia", "Offset", "Arm"})
    if (section.given(key))
      section.reject(key, "must not be set when Type = modes");
  if (section.has("Static stiffness") && section.has("Residual flexibility"))
    section.reject("Residual flexibility", "must not be set when Static stiffness is set");
  ModalPoint point{.name = name};
  if (section.has("Position"))
    point.position = vector3(section, "Position");
  if (section.has("Static stiffness"))
    point.static_stiffness = vector3(section, "Static stiffness");
  if (section.has("Residual flexibility"))
    point.residual_flexibility = vector3(section, "Residual flexibility");
  return point;
}

/// "A -> B -> C, D -> E" as pairs of neighbours.
std::vector<std::array<std::string, 2>> read_lines(const Values &section) {
  std::vector<std::array<std::string, 2>> lines;
  for (const std::string &chain : parameters::split_list(section.text("Lines"))) {
    const std::vector<std::string> points = parameters::split_list(chain, true);
    if (points.size() < 2)
      section.reject("Lines", "must be chains of points, A -> B -> C, separated by commas");
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      lines.push_back({points[i], points[i + 1]});
  }
  return lines;
}

std::vector<Attachment> read_modal_attachments(const Values &section) {
  std::vector<Attachment> attachments;
  for (const std::string &place : section.names("Attachments")) {
    const std::size_t dot = place.rfind('.');
    const bool axis = dot != std::string::npos && dot > 0 && dot + 2 == place.size() &&
                      place.back() >= 'x' && place.back() <= 'z';
    if (!axis)
      section.reject("Attachments",
                     "must name places as POINT.x, POINT.y or POINT.z, but one is '" + place + "'");
    attachments.push_back({place.substr(0, dot), place.back() - 'x'});
  }
  return attachments;
}

ModalDefinition::Normalisation read_normalisation(const Values &section) {
  using Normalisation = ModalDefinition::Normalisation;
  static const std::map<std::string, Normalisation> known = {
      {"modal mass", Normalisation::modal_mass},
      {"unit modal mass", Normalisation::unit_mass},
      {"unit largest component", Normalisation::largest_component}};
  return known.at(section.choice("Normalisation"));
}

void refuse_keys_of_other_files(const Values &section, bool hdf5) {
  if (hdf5 && section.given("Separator"))
    section.reject("Separator", "must not be set when File is an HDF5 file");
  if (!hdf5 && section.has("Body"))
    section.reject("Body", "must not be set when File is a table");
}

} // namespace

ModalDefinition read_modal_definition(const Values &body, const std::string &folder) {
  const Values section = body.subsection("Modal data");
  section.require("File");
  read_named_file(section, folder, {});
  ModalDefinition definition{.file = named_file(section, folder),
                             .separator = section.choice("Separator"),
                             .group = section.text("Body"),
                             .dimensionless = body.parameters().dimensionless(),
                             .normalisation = read_normalisation(section),
                             .damping_ratios = section.quantities("Damping ratio"),
                             .attachments = read_modal_attachments(section),
                             .lines = read_lines(section)};
  refuse_keys_of_other_files(section, is_hdf5(definition.file));
  if (section.has("Number"))
    definition.number = static_cast<int>(section.integer("Number"));
  for (const char *key : {"Residual frequency", "Residual damping ratio"})
    if (section.has(key) && definition.attachments.empty())
      section.reject(key, "must not be set without Attachments");
  if (section.has("Residual frequency"))
    definition.residual_frequency = section.quantity("Residual frequency");
  if (section.has("Residual damping ratio"))
    definition.residual_damping_ratio = section.quantity("Residual damping ratio");
  for (const std::string &name : body.instances("Point"))
    definition.points.push_back(read_modal_point(body.instance("Point", name), name));
  return definition;
}

std::string modal_file_checksum(const Values &body, const std::string &folder) {
  return body.choice("Type") == "modes" ? file_checksum(body.subsection("Modal data"), folder) : "";
}

void check_modal_file(const Values &body, const std::string &folder,
                      const std::vector<std::string> &checksums) {
  const Values section = body.subsection("Modal data");
  if (body.choice("Type") == "modes" && section.has("File"))
    read_named_file(section, folder, checksums);
}

} // namespace vibroimpact::reduction
