// A body whose matrices come from files, as plain data: another program has made them.
#pragma once

#include "structure/beam_definition.h"

namespace vibroimpact::structure {

/// What one unit of a file is in SI.
struct UnitSystem {
  double length = 1; ///< [m]
  double mass = 1;   ///< [kg]
  double time = 1;   ///< [s]
};

struct MatrixDefinition {
  std::string stiffness_file;        ///< path
  std::string mass_file;             ///< path
  std::string damping_file;          ///< path; empty without
  std::string table_name;            ///< of the file, for messages
  std::string table_content;         ///< node and direction of each row, see read_dof_table()
  std::string deck_name{};           ///< of the file, for messages
  std::string deck_content{};        ///< nodes and elements, see read_input_deck(); empty without
  UnitSystem units;                  ///< of all these files
  std::optional<int> plane_normal{}; ///< axis along which nothing moves
  std::vector<Support> supports;
  std::vector<Point> points;
  std::vector<Interface> interfaces;
  std::vector<Load> loads;
};

} // namespace vibroimpact::structure
