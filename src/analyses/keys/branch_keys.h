// Keys and checks that all analyses have which follow something along a key from the value that the
// file gives to it: in which direction, with which steps.
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "analyses/run/system.h"
#include "continuation/settings.h"

namespace vibroimpact::analyses {

enum class Directions { both, forward, backward };

/// Range of the key, Direction, and the steps.
void declare_branch_keys(parameters::Section &section);
/// Most points, Longest step and Least step of a `curve`: "branch".
void declare_steps(parameters::Section &section, const std::string &curve,
                   const std::string &longest = "0.1");

Directions read_direction(const parameters::Values &section);
/// InputError for steps that exclude each other.
continuation::Settings read_steps(const parameters::Values &section);
continuation::Range range_of(const SweptParameter &parameter);
/// Both.
continuation::Settings read_continuation(const parameters::Values &section,
                                         const SweptParameter &parameter);
/// What the file gives to the key [its unit]; 0 for a frequency, which only the system knows.
/// InputError.
double read_start(const SweptParameter &parameter, const parameters::Values &section);

/// Value of the key in the system, `read` being that of the file unless it is a frequency. `who`
/// needs an excitation with a period: "A branch".
double start_value(const SweptParameter &parameter, double read, const System &system,
                   const std::string &excitation, const std::string &who);
/// InputError for a start beyond the ends, and for a frequency that cannot change.
void check_start(const SweptParameter &parameter, double read, const System &system,
                 const std::string &excitation, const std::string &who);
/// The ends, unless the key is a frequency (Analysis::variants()).
std::vector<std::vector<parameters::Override>> end_variants(const SweptParameter &parameter);

} // namespace vibroimpact::analyses
