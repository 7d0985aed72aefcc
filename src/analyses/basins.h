// Basins: which periodic motion each start of a grid of cells leads to.
//
// The attracting motions are found first, from a coarse part of the grid that is the same for
// every rank and every row, and made sure by Newton's method and their multipliers; their number
// in the list is their size at phase 0, the smallest first. Then each cell is followed until it is
// caught by one of them (periodic/attractors.h). Cells that lead to a motion which the coarse part
// has not met are marked by a number of their own, since rows do not know of each other.
#pragma once

#include "analyses/analysis.h"
#include "analyses/basin_rows.h"
#include "analyses/basin_search.h"

namespace vibroimpact::analyses {

class Basins : public Analysis {
public:
  struct Settings {
    SweptParameter first, second; ///< values: centres of the cells
    periodic::AttractorSettings attractors;
    long coarse = 0;        ///< cells along an axis of the coarse part
    std::string excitation; ///< whose period is that of the forcing; empty: the only one
  };
  explicit Basins(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "basins"; }
  /// the second axis; the first one is the dimension of the fields
  std::vector<Axis> axes() const override { return {settings_.second.axis()}; }
  std::size_t lines() const override;
  void check(const System &system) const override;
  std::vector<std::vector<parameters::Override>> variants() const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  class Rows; // of a line
  PointResult compute(std::size_t row, Rows &rows, LineContext &context) const;
  void add_cells(PointResult &result, const std::vector<double> &cells,
                 const std::vector<double> &periods, std::size_t known) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
