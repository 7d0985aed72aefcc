// Nodes, elements and sets of nodes out of an input deck of CalculiX or Abaqus.
#pragma once

#include "structure/mesh.h"

namespace vibroimpact::structure {

/// The mesh with the numbers of its nodes (Mesh::numbers), all of them, and its sets of nodes as
/// groups, names in capitals. Cells are what is seen: lines of beams, surfaces of shells, and the
/// faces of solids that no other solid shares; faces with nodes between their corners are cut so
/// that each node is a corner. Elements of other kinds are left out, and so is everything else.
/// `length`: the unit of its coordinates [m]; `file`: its name for messages. Throws the
/// DefinitionError of Geometry/Mesh with the line.
Mesh read_input_deck(const std::string &content, double length, const std::string &file);

} // namespace vibroimpact::structure
