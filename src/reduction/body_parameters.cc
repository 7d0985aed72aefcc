#include "reduction/body_parameters.h"

#include "reduction/beam_parameters.h"
#include "reduction/body_sections.h"
#include "reduction/lumped_parameters.h"
#include "reduction/matrix_parameters.h"
#include "reduction/modal_parameters.h"
#include "reduction/shell_parameters.h"
#include "reduction/solid_parameters.h"

#include <algorithm>

namespace vibroimpact::reduction {

namespace {

using namespace sections;

modes::Selection read_selection(const Values &section) {
  modes::Selection selection;
  selection.number = static_cast<int>(section.integer("Number"));
  if (!section.has("Band"))
    return selection;
  if (section.given("Number"))
    section.reject("Number", "must not be set when Band is set");
  const std::vector<double> band = section.quantities("Band");
  if (!(band[1] > band[0]))
    section.reject("Band", "must be a lower and a greater upper frequency");
  selection.band = {band[0], band[1]};
  return selection;
}

Damping read_damping(const Values &section) {
  check_use(section, "Damping model",
            {{"Damping ratio", {"ratio"}},
             {"Attachment damping ratio", {"ratio"}},
             {"Rayleigh alpha", {"rayleigh"}},
             {"Rayleigh beta", {"rayleigh"}},
             {"Viscous constant", {"viscous"}}});
  Damping damping;
  damping.ratios = section.quantities("Damping ratio");
  if (section.has("Attachment damping ratio"))
    damping.attachment_ratio = section.quantity("Attachment damping ratio");
  const std::string model = section.choice("Damping model");
  if (model == "rayleigh") {
    damping.model = Damping::Model::rayleigh;
    damping.alpha = optional_quantity(section, "Rayleigh alpha");
    damping.beta = optional_quantity(section, "Rayleigh beta");
  } else if (model == "viscous") {
    section.require("Viscous constant");
    damping.model = Damping::Model::viscous;
    damping.viscous_constant = section.quantity("Viscous constant");
  }
  return damping;
}

std::vector<Attachment> read_attachments(const Values &section,
                                         const std::vector<std::string> &places) {
  std::vector<std::string> known;
  for (const std::string &place : places)
    for (const char *axis : {".x", ".y", ".z"})
      known.push_back(place + axis);
  std::vector<Attachment> attachments;
  for (const std::string &place : section.names("Attachments")) {
    section.require_known("Attachments", place, known);
    attachments.push_back({place.substr(0, place.size() - 2), place.back() - 'x'});
  }
  return attachments;
}

/// Modes, attachments and damping of a body with a mesh, from its section.
void read_modes(const Values &body, BodyDefinition &definition) {
  const Values section = body.subsection("Modes");
  std::vector<std::string> places = body.instances("Point");
  for (const std::string &interface : body.instances("Interface"))
    places.push_back(interface);
  definition.selection = read_selection(section);
  definition.attachments = read_attachments(section, places);
  if (section.choice("Reduction") == "fixed interface")
    definition.reduction = BodyDefinition::Reduction::fixed_interface;
  definition.damping = read_damping(section);
}

// A body of this type uses none of the sections `fixed` and `named`.
void refuse(const Values &body, const std::vector<const char *> &fixed,
            const std::vector<const char *> &named) {
  const auto reject = [&](const char *unused) {
    body.reject("Type",
                "must not be " + body.choice("Type") + " when there is a subsection " + unused);
  };
  for (const char *unused : fixed)
    if (body.subsection_given(unused))
      reject(unused);
  for (const char *unused : named)
    if (!body.instances(unused).empty())
      reject(unused);
}

/// What only a body with known modes has.
void refuse_modal_keys(const Values &body) {
  refuse(body, {"Modal data"}, {});
  for (const std::string &name : body.instances("Point"))
    for (const std::string &key : modal_point_keys())
      if (body.instance("Point", name).given(key))
        body.instance("Point", name)
            .reject(key, "must not be set when Type = " + body.choice("Type"));
}

void read_beam(const Values &body, const std::string &folder, MPI_Comm communicator,
               BodyDefinition &definition) {
  if (!body.instances("Mass").empty())
    body.reject("Type",
                "must not be beam when there is a subsection Mass; a Point can carry a mass");
  refuse(body, {"Rotor", "Motor", "Matrices"}, {"Shell", "Stiffener", "Solid"});
  refuse_modal_keys(body);
  refuse_shell_geometry(body);
  definition.beam = read_beam_definition(body, folder, communicator);
  definition.beam.plane_normal = read_plane(body);
  read_modes(body, definition);
}

void read_shell(const Values &body, const std::string &folder, MPI_Comm communicator,
                BodyDefinition &definition) {
  refuse(body, {"Section", "Rotor", "Motor", "Matrices", "Spin axis"},
         {"Mass", "Member", "Hinge", "Solid"});
  refuse_modal_keys(body);
  definition.shell = read_shell_definition(body, folder, communicator);
  definition.shell.plane_normal = read_plane(body);
  read_modes(body, definition);
}

void read_solid(const Values &body, const std::string &folder, MPI_Comm communicator,
                BodyDefinition &definition) {
  refuse(body, {"Section", "Rotor", "Motor", "Matrices", "Spin axis"},
         {"Mass", "Member", "Hinge", "Shell", "Stiffener"});
  refuse_modal_keys(body);
  definition.solid = read_solid_definition(body, folder, communicator);
  definition.solid.plane_normal = read_plane(body);
  read_modes(body, definition);
}

void read_matrices(const Values &body, const std::string &folder, MPI_Comm communicator,
                   BodyDefinition &definition) {
  refuse(body, {"Section", "Material", "Rotor", "Motor", "Spin axis"},
         {"Mass", "Member", "Hinge", "Shell", "Stiffener", "Solid", "Rigid link"});
  refuse_modal_keys(body);
  definition.matrices = read_matrix_definition(body, folder, communicator);
  definition.matrices.plane_normal = read_plane(body);
  read_modes(body, definition);
  const Values modes = body.subsection("Modes");
  if (definition.damping.model == Damping::Model::viscous)
    modes.reject("Damping model", "must not be viscous when Type = matrices");
  if (definition.matrices.damping_file.empty())
    return;
  for (const char *key : {"Damping model", "Damping ratio", "Attachment damping ratio"})
    if (modes.given(key))
      modes.reject(key, "must not be set when Matrices / Damping is set");
  definition.damping.model = Damping::Model::given;
}

/// A body without a mesh has no plane.
void refuse_plane(const Values &body) {
  if (body.given("Planar"))
    body.reject("Planar", "must not be set when Type = " + body.choice("Type"));
}

void read_rotor(const Values &body, BodyDefinition &definition) {
  refuse_plane(body);
  refuse(body, {"Geometry", "Section", "Material", "Modes", "Modal data", "Matrices", "Spin axis"},
         {"Support", "Point", "Rigid link", "Interface", "Mass", "Member", "Hinge", "Shell",
          "Stiffener", "Solid", "Load"});
  const Values rotor = body.subsection("Rotor");
  rotor.require("Mass");
  rotor.require("Inertia");
  definition.rotor = {.inertia = rotor.quantity("Inertia"), .friction = rotor.quantity("Friction")};
}

void read_lumped(const Values &body, BodyDefinition &definition) {
  refuse_plane(body);
  refuse(body,
         {"Geometry", "Section", "Material", "Modes", "Modal data", "Rotor", "Motor", "Matrices"},
         {"Support", "Rigid link", "Interface", "Member", "Hinge", "Shell", "Stiffener", "Solid",
          "Load"});
  read_lumped_masses(body, definition);
  definition.lumped_spin = read_spin_axis(body);
  if (definition.lumped_spin && !definition.lumped_spin->members.empty())
    body.subsection("Spin axis").reject("Members", "must not be set when Type = lumped");
}

void read_modal(const Values &body, const std::string &folder, BodyDefinition &definition) {
  refuse_plane(body);
  refuse(body,
         {"Geometry", "Section", "Material", "Modes", "Matrices", "Rotor", "Motor", "Spin axis"},
         {"Support", "Rigid link", "Interface", "Mass", "Member", "Hinge", "Shell", "Stiffener",
          "Solid", "Load"});
  definition.modal = read_modal_definition(body, folder);
}

} // namespace

BodyDefinition read_body(const Values &body, const std::string &name, const std::string &folder,
                         MPI_Comm communicator) {
  BodyDefinition definition;
  definition.name = name;
  if (body.choice("Type") == "lumped") {
    definition.type = BodyDefinition::Type::lumped;
    read_lumped(body, definition);
  } else if (body.choice("Type") == "rotor") {
    definition.type = BodyDefinition::Type::rotor;
    read_rotor(body, definition);
  } else if (body.choice("Type") == "modes") {
    definition.type = BodyDefinition::Type::modes;
    read_modal(body, folder, definition);
  } else if (body.choice("Type") == "shell") {
    definition.type = BodyDefinition::Type::shell;
    read_shell(body, folder, communicator, definition);
  } else if (body.choice("Type") == "solid") {
    definition.type = BodyDefinition::Type::solid;
    read_solid(body, folder, communicator, definition);
  } else if (body.choice("Type") == "matrices") {
    definition.type = BodyDefinition::Type::matrices;
    read_matrices(body, folder, communicator, definition);
  } else {
    read_beam(body, folder, communicator, definition);
  }
  return definition;
}

} // namespace vibroimpact::reduction
