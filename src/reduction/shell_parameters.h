// The keys of a parameter file that shells have, and those of them that solids have too.
#pragma once

#include "parameters/values.h"
#include "structure/shell_definition.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// Shape and dimensions of a cross-section, of beams and stiffeners alike.
void declare_section_keys(parameters::Section &section,
                          const std::string &rectangle = "Shape = rectangle");
std::vector<std::string> section_keys();
/// Young modulus, Poisson ratio and Density that stand for those of the body's Material.
void declare_own_material(parameters::Section &section);
structure::Material own_material(const parameters::Values &section,
                                 const parameters::Values &material);
/// Plate, Cylinder and their divisions.
void declare_shell_geometry(parameters::Section &geometry);
/// `subsection Shell NAME` and `subsection Stiffener NAME` of a body.
void declare_shells(parameters::Section &body);

/// The Divisions of a generated mesh along so many directions. Throws InputError for other numbers,
/// and when there is less memory than so many bytes for each node.
std::vector<int> read_divisions(const parameters::Values &geometry, std::size_t directions,
                                double bytes_of_node);
/// Throws InputError when a body that is no shell gives keys of declare_shell_geometry().
void refuse_shell_geometry(const parameters::Values &body);

/// Collective: rank 0 reads the mesh file. Throws InputError.
structure::ShellDefinition read_shell_definition(const parameters::Values &body,
                                                 const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact::reduction
