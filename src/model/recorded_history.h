// A time history through the samples of a record.
#pragma once

#include "model/history.h"

#include <vector>

namespace vibroimpact::model {

struct Samples {
  std::vector<double> time;  ///< [s], increasing, at least two
  std::vector<double> value; ///< as many
};

enum class Interpolation {
  linear,      ///< straight lines between the samples
  cubic_spline ///< with continuous second derivative, and slope zero at both ends
};

/// What holds before the first and after the last sample.
enum class OutsideRecord {
  zero, ///< the quantity itself is zero: a force, an acceleration
  held  ///< it keeps its first and last value: a displacement, a velocity
};

/// Every sample is a break. A given velocity or acceleration is integrated exactly, from zero at
/// the first sample.
std::shared_ptr<const TimeFunction> make_recorded(Given given, const Samples &samples,
                                                  Interpolation interpolation,
                                                  OutsideRecord outside);

void declare_recorded(parameters::Section &excitation);
TimeFunctionPointer create_recorded(const parameters::Values &excitation,
                                    const HistoryContext &context);

/// "NAME HASH" for the file of an excitation with a recorded history; "" for others, and for a file
/// that cannot be read, which is an error only where it is used. Local.
std::string record_checksum(const parameters::Values &excitation, const std::string &file_folder);

} // namespace vibroimpact::model
