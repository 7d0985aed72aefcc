// Basins: which periodic motion each start of a grid of cells leads to.
//
// The attracting motions are found first, from a coarse part of the grid that is the same for
// every rank and every row, and made sure by Newton's method and their multipliers; their number
// in the list is their size at phase 0, the smallest first. Then each cell is followed until it is
// caught by one of them (periodic/attractors.h), by the motions themselves or by a map that is
// interpolated between nodes (periodic/interpolated_map.h), of which a sample of cells then says
// how many are wrong. Cells that lead to a motion which the coarse part has not met are marked as
// such, since rows do not know of each other.
#pragma once

#include "analyses/analysis.h"
#include "analyses/basins/basin_search.h"
#include "analyses/basins/start_box.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

class Basins : public Analysis {
public:
  struct Settings {
    SweptParameter first, second; ///< values: centres of the cells
    BasinSettings search;
    long coarse = 0;        ///< cells along an axis of the coarse part
    bool exactly = true;    ///< else by interpolation
    Index nodes = 0;        ///< along each state, of the interpolation
    long checked_every = 0; ///< one of so many interpolated cells is followed exactly too
  };
  explicit Basins(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "basins"; }
  /// the second axis; the first one is the dimension of the fields
  std::vector<Axis> axes() const override { return {settings_.second.axis()}; }
  std::size_t lines() const override;
  void check(const System &system) const override;
  void check_built(const SystemSource &build) const override;
  std::vector<std::vector<parameters::Override>> variants() const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  class Rows;
  PointResult compute(std::size_t row, Rows &rows, LineContext &context) const;
  void add_places(const FieldWriter &result, const Rows &rows) const;
  void add_cells(const FieldWriter &result, std::vector<double> marks,
                 std::vector<double> periods) const;

  Settings settings_;
  /// What the lines of one rank have in common: the search of the coarse part. No row depends on
  /// which others went before it.
  mutable std::shared_ptr<Rows> rows_;
};

} // namespace vibroimpact::analyses
