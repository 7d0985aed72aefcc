// Basin shares: how many of random starts in a box lead to which periodic motion, for models of any
// number of coordinates. The share p of N starts has the standard error sqrt(p (1 - p) / N),
// however many keys the box has.
#pragma once

#include "analyses/analysis.h"
#include "analyses/basins/basin_search.h"
#include "analyses/basins/start_box.h"

namespace vibroimpact::analyses {

class BasinShares : public Analysis {
public:
  struct Settings {
    std::vector<SweptParameter> keys; ///< ends of the box
    long starts = 0;
    long seed = 0;
    BasinSettings search;
  };
  explicit BasinShares(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "basin shares"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void check_built(const SystemSource &build) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  std::vector<model::InitialState> draw(const StartBox &box) const;
  PointResult compute(LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
