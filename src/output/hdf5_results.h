// The schema of results.h5.
//
//   /                       attributes: version, commit, parameters, command_line, libraries,
//   ranks,
//                           processor
//   /body/NAME/             mode [-], axis, component, point, node, end (scales); frequency [Hz],
//                           damping_ratio, mass, stiffness, effective_mass, base_participation, ...
//   /contact/               contact (scale of names); clearance, flexibility_share, ...
//   /analysis/NAME/         attributes: name, type, grid; the outer axes (scales), status, reason,
//                           and the fields, nested by the slashes of their names
//   /analysis/NAME/derived/ the derived quantities; attributes operation, axis, axes
//
// Every dataset but a scale has a scale on each dimension; the scale is in the group of the dataset
// or above. Every dataset carries the attributes unit and description.
#pragma once

#include "common/hdf5_file.h"
#include "contact/truncation.h"
#include "derived/analysis_arrays.h"
#include "derived/labelled_array.h"
#include "output/yield_excess.h"
#include "reduction/reduced_body.h"

#include <string>
#include <vector>

namespace vibroimpact::output {

/// How the results came about; goes into the attributes of the file and nowhere else.
struct RunInformation {
  std::string version;
  std::string commit;
  std::string parameters; ///< the complete echo
  std::string command_line;
  std::vector<std::string> libraries; ///< "deal.II 9.4.1"
  int ranks = 1;
  std::string processor;      ///< of the machine of rank 0
  bool dimensionless = false; ///< Units = dimensionless: no result has a unit
};

void write_information(Hdf5File &file, const RunInformation &information);
void write_body(Hdf5File &file, const reduction::ReducedBody &body, bool dimensionless);
/// Behind the bodies: /body/NAME/yield_stress of those that have one.
void write_yield_stresses(Hdf5File &file, const YieldStresses &yield_stresses, bool dimensionless);
/// Nothing without contacts.
void write_contacts(Hdf5File &file, const std::vector<contact::ContactFigures> &contacts,
                    bool dimensionless);
void write_analysis(Hdf5File &file, const AnalysisHeader &header,
                    const derived::AnalysisArrays &arrays,
                    const std::vector<derived::DerivedArray> &quantities = {});

} // namespace vibroimpact::output
