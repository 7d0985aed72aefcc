// Parameter grids: any analysis repeated at every combination of values of any keys.
#pragma once

#include "common/result_sink.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

inline constexpr const char *grid_type = "parameter grid";

void declare_grid(parameters::Section &analysis);

/// One swept key.
struct GridKey {
  std::string path;                ///< "Contact/heads/Clearance"
  std::vector<std::string> values; ///< as written in the file
  /// Keys that change along with this one: as many values each.
  std::vector<GridKey> followers{};
  std::string name{};   ///< of its section, "Key NAME"
  std::string target{}; ///< `path` in its one spelling, see Values::key_path()
  std::string origin{}; ///< file and line of its values, for messages
};

/// Declares the sections `kind` NAME, each of a key that takes several values.
void declare_grid_keys(parameters::Section &section, const std::string &kind,
                       const std::string &sentence);
/// These keys in the order of the file, none of them among `taken`, where they are put. InputError.
std::vector<GridKey> read_grid_keys(const parameters::Values &section, const std::string &kind,
                                    const std::string &repeated, const std::string &owner,
                                    std::vector<std::string> &taken);
/// reject()s the key Path of `key`, whose one spelling is `target`, where it changes nothing that
/// the analysis `repeated` reads, or is among `taken`; else it is put there. `owner` repeats the
/// analysis: "grid".
void check_changed_key(const parameters::Values &key, const std::string &target,
                       const std::string &repeated, const std::string &owner,
                       std::vector<std::string> &taken);
/// The same for the path that stands in another key of a section.
void check_changed_key(const parameters::Values &section, const std::string &name,
                       const std::string &target, const std::string &repeated,
                       const std::string &owner, std::vector<std::string> &taken);

/// Paths of all keys, followers included.
std::vector<std::string> grid_paths(const std::vector<GridKey> &keys);

/// Keys of a `parameter grid` section that repeats the analysis `repeated`, in the order of the
/// file. InputError when there are none, when two change the same key or one of `taken`, or when
/// one changes nothing that the repeated analysis reads.
std::vector<GridKey> read_grid(const parameters::Values &analysis, const std::string &repeated,
                               std::vector<std::string> taken = {});
/// Name of the analysis that the grid repeats.
std::string repeated_analysis(const parameters::Values &analysis,
                              const std::vector<std::string> &known);

/// Number of points of the grid.
std::size_t grid_size(const std::vector<GridKey> &keys);
/// Position of grid point `point` along the keys.
std::vector<std::size_t> grid_index(const std::vector<GridKey> &keys, std::size_t point);
/// Overrides of grid point `point`, the last key varying fastest.
std::vector<parameters::Override> grid_overrides(const std::vector<GridKey> &keys,
                                                 std::size_t point);

/// Each value of each key once (of more than a hundred some, both ends among them), the other keys
/// at their first: the points that show whether the values can be used.
std::vector<std::size_t> grid_probes(const std::vector<GridKey> &keys);
/// "Contact/heads/Clearance = 1 mm, ..." of grid point `point`, for messages.
std::string grid_case(const std::vector<GridKey> &keys, std::size_t point);

/// The outer axes of a grid: numbers in SI where the key is a number, else labels.
std::vector<Axis> grid_axes(const std::vector<GridKey> &keys,
                            const parameters::ParameterSet &parameters);

} // namespace vibroimpact::analyses
