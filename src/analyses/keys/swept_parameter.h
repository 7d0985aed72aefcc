// What a stepped sweep varies: the frequency of an excitation, or the number behind any key.
#pragma once

#include "common/result_sink.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct SweptParameter {
  std::string path;           ///< of the key, as for --set; empty: the frequency of an excitation
  std::string unit = "Hz";    ///< of the values
  std::vector<double> values; ///< increasing [unit]
  std::string origin{};       ///< file and line of the ends, for messages

  bool is_frequency() const { return path.empty(); }
  /// The number farthest from zero [unit].
  double magnitude() const;
  /// The override that sets the key to `value` exactly.
  parameters::Override at(double value) const;
  Axis axis() const;
  std::string axis_name() const;
};

/// The number that the key `path_key` of a section names, if it had the value of `key`. InputError
/// where either cannot be used.
parameters::SiNumber read_number_for(const parameters::Values &section, const char *path_key,
                                     const char *key);

/// Keys that say what is varied and between which ends.
void declare_key_range(parameters::Section &section, bool key_required = false);
/// The same, and in which steps.
void declare_swept_parameter(parameters::Section &section);

/// With the two ends as values. InputError for a key that is unknown, belongs to an analysis or
/// holds no single number, and for ends in the wrong order; a single one of `points` may be both.
SweptParameter read_key_range(const parameters::Values &section, long points = 2);
/// The same with all values.
SweptParameter read_swept_parameter(const parameters::Values &section);

/// Frequencies [Hz] between the keys First frequency and Last frequency, as many as Points, by the
/// key Spacing. InputError for ends in the wrong order.
std::vector<double> read_frequencies(const parameters::Values &section);

} // namespace vibroimpact::analyses
