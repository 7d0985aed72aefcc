// Readers of the subsections that bodies with a mesh have in common.
#pragma once

#include "parameters/values.h"
#include "structure/shell_definition.h"

#include <mpi.h>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::reduction::sections {

using parameters::Values;

/// Three values of the key, from number `first` on.
Vector3 vector3(const Values &section, const std::string &key, std::size_t first = 0);
/// 0 when it is not given.
double optional_quantity(const Values &section, const std::string &key);

/// Of the keys that only some choices of `chooser` use, the others must not be given.
struct KeyUse {
  const char *key;
  std::vector<std::string> choices;
};
void check_use(const Values &section, const std::string &chooser, const std::vector<KeyUse> &uses);

/// Keys that say where on a body something is, and what they say.
void declare_place(parameters::Section &section,
                   const char *when = "Position, Near and Node are not given");
structure::Location read_place(const Values &section);
/// The axis along which a body that stays in a plane does not move.
std::optional<int> read_plane(const Values &body);

/// Of the file that a key names, which is relative to the folder of the parameter file.
std::string path_of(const Values &section, const std::string &key, const std::string &folder);
/// Its content. Collective: rank 0 reads it. InputError for one that is empty or cannot be read.
std::string read_text(const Values &section, const std::string &key, const std::string &folder,
                      MPI_Comm communicator);
/// Content of the file that Mesh names. Collective: rank 0 reads it.
std::string read_mesh(const Values &geometry, const std::string &folder, MPI_Comm communicator);
structure::SectionShape read_section(const Values &section);
structure::Material read_material(const Values &material);
structure::Support read_support(const Values &section, const std::string &name);
structure::Point read_point(const Values &section, const std::string &name);
structure::Interface read_interface(const Values &section, const std::string &name);
structure::Load read_load(const Values &section, const std::string &name);
/// Nothing where the body has no such section.
std::optional<structure::SpinAxis> read_spin_axis(const Values &body);
/// All of a kind, in the order of the file.
std::vector<structure::Support> read_supports(const Values &body);
std::vector<structure::Point> read_points(const Values &body);
std::vector<structure::RigidLink> read_links(const Values &body);
/// InputError for one with the name of a point.
std::vector<structure::Interface> read_interfaces(const Values &body);
std::vector<structure::Load> read_loads(const Values &body);

} // namespace vibroimpact::reduction::sections
