// The identified impacts of one record as result fields, below contact/NAME/identification/, and as
// summary lines.
#pragma once

#include "analyses/identification/identify_fits.h"
#include "analyses/identification/identify_pulses.h"
#include "analyses/results/field_writer.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// What an identification starts from.
struct IdentificationInput {
  std::string contact; ///< name
  ContactConstants constants;
  std::optional<double> dissipation; ///< of the law, where it is the same for all impacts [s/m]
  Scales scales;
  Uncertainties uncertainties;
  std::vector<PulseFigures> pulses; ///< of every impact
  std::size_t listed_impacts = 0;   ///< in the summary
  double slowest_fitted = 0;        ///< by v_c, in fitted laws [m/s]
};

/// Constants of the contact, the pulses as measured, and for each set of formulas e with its
/// interval, v_c, mu (dimension impact_NAME) and the fitted laws.
void add_identification(const FieldWriter &result, const IdentificationInput &input);

/// e of each set over a grid of impulses and peak forces that reaches a fifth beyond the largest
/// pulse, and over gamma from 1 to 4: `points` per axis.
void add_restitution_maps(const FieldWriter &result, const IdentificationInput &input,
                          std::size_t points);

/// The force [N] over the samples [s] of its record.
void add_force_record(const FieldWriter &result, const std::string &contact,
                      const std::vector<double> &time, const std::vector<double> &force);

/// Where the pulses of a measured record are.
void add_measured_pulses(const FieldWriter &result, const std::string &contact,
                         const std::vector<MeasuredPulse> &pulses);

} // namespace vibroimpact::analyses
