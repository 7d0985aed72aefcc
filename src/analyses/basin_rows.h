// The starts of a grid of cells: a row of cells along the first axis, which varies initial
// conditions, for each value of the second axis, which varies initial conditions or any other key.
#pragma once

#include "analyses/swept_parameter.h"
#include "analyses/system.h"

namespace vibroimpact::analyses {

/// Keys of an axis of cells between two ends, and how many there are.
void declare_cell_axis(parameters::Section &section, const std::string &name,
                       const std::string &description);
/// The values are the centres of the cells. InputError.
SweptParameter read_cell_axis(const parameters::Values &section, const std::string &name);

struct BasinRow {
  System system;
  /// Coordinates, then velocities, at the first key equal to zero, and their change with it.
  Vector origin, slope;

  model::InitialState start(double first) const;
};

/// The row at a value of the second key. InputError when the first key changes more than initial
/// conditions, or these not in proportion.
BasinRow basin_row(const SweptParameter &first, const SweptParameter &second, double value,
                   const SystemSource &build);

/// Do two systems move alike from every start? Compares all they are made of: matrices, loads,
/// histories over their period, gaps, and what the contact laws do at local states of the given
/// size.
bool same_motions(const System &a, const System &b, double size);

} // namespace vibroimpact::analyses
