// The cases of a parameter grid as a table: a column for each key, a row for each case.
#pragma once

#include "analyses/run/grid.h"

namespace vibroimpact::analyses {

/// Declares the key Cases.
void declare_case_table(parameters::Section &grid);

/// "PATH [UNIT], PATH; VALUE, VALUE; ...": the key of the first column, which the others are tied
/// to. InputError for a table that is not one.
GridKey read_case_table(const parameters::Values &grid);

/// For each grid whose Cases name a CSV file, which is looked for in `folder`: the table in its
/// place, so that the parameters hold it. InputError.
std::vector<parameters::Override> tables_from_files(const parameters::Values &root,
                                                    const std::string &folder);

} // namespace vibroimpact::analyses
