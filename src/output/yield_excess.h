// Von Mises stresses in the results that are beyond the yield stress of their body, where the
// linear elastic model no longer describes it.
#pragma once

#include "common/result_sink.h"
#include "output/summary_list.h"
#include "parameters/values.h"
#include "reduction/reduced_body.h"

#include <map>
#include <string>
#include <vector>

namespace vibroimpact::output {

/// Of the bodies that have one, by their names [Pa].
using YieldStresses = std::map<std::string, double>;

/// The key Yield stress in the Material of each of these bodies of a file.
YieldStresses read_yield_stresses(const parameters::Values &file,
                                  const std::vector<reduction::ReducedBody> &bodies);

class YieldExcess {
public:
  explicit YieldExcess(YieldStresses yield_stresses = {});

  /// Counts point/BODY.POINT/von_mises_stress/maximum, the same below recorded/, and
  /// body/BODY/von_mises_stress/maximum.
  void add(const PointResult &point);

  /// `PREFIX.body.NAME.yield_ratio = 1.2 [1]` for each body whose stress is known: the largest von
  /// Mises stress over the yield stress.
  void add_to(SummaryList &list, const std::string &prefix) const;

  /// A sentence for each body whose stress passes its yield stress.
  std::vector<std::string> warnings() const;

private:
  struct Largest {
    double stress = 0; ///< [Pa]
    std::string place; ///< "beam.root", or the body itself
  };
  void add(const std::string &place, const Field &field);

  YieldStresses yield_stresses_;
  std::map<std::string, Largest> largest_; ///< by the body
};

} // namespace vibroimpact::output
