// Finds special points along a branch and follows their loci.
#pragma once

#include "analyses/curves/branch_follower.h"
#include "analyses/curves/locus_table.h"

namespace vibroimpact::analyses {

/// What a locus is one of.
enum class LocusOf { fold, period_doubling, loss_of_symmetry, neimark_sacker, graze };

/// A special point of a branch whose locus is wanted; without a graze that of the nearest one.
struct LocusOrigin {
  long branch = 0;
  long halves = 2;
  continuation::SpecialPoint special;
};

/// Keeps the special points of some kinds.
class LocusOrigins : public BranchSink {
public:
  explicit LocusOrigins(std::vector<LocusOf> kinds) : kinds_(std::move(kinds)) {}
  void begin(long number, long halves, double sign) override;
  void add(const continuation::BranchPoint & /*point*/) override {}
  void add(const continuation::SpecialPoint &special) override;
  void drop(long number) override;
  /// A branch that ends at its least step may have come to a graze that it does not pass.
  void end(const continuation::Branch &branch) override;

  /// By branch and the value of the key.
  std::vector<LocusOrigin> in_order() const;

private:
  std::vector<LocusOf> kinds_;
  std::vector<LocusOrigin> found_;
  long number_ = 0, halves_ = 2;
};

class LocusFollower {
public:
  /// Keeps references. `sizes` as for OrbitProblem with two keys; `second`: value of the second key
  /// on the branch; `origins`: how many will be followed. `note` is called at each point with the
  /// share that is done, at least; it may throw to end the run. What the steps give is kept in the
  /// record, if there is one.
  LocusFollower(KeyedMap &maps, Vector sizes, double second, continuation::Settings settings,
                LocusTable &table, std::size_t origins, std::function<void(double share)> note,
                StepRecord *steps)
      : maps_(maps), sizes_(std::move(sizes)), second_(second), settings_(settings), table_(table),
        steps_(steps), progress_(settings.second_key, 1, std::move(note)),
        left_(2 * static_cast<double>(origins)) {}

  /// In both directions, unless a locus so far passes this point.
  void follow(const LocusOrigin &origin);

private:
  struct Done {
    continuation::LocusKind kind;
    long halves;
    continuation::Locus locus;
  };
  void follow_both_ways(const LocusOrigin &origin);
  bool passed(const LocusOrigin &origin, const continuation::LocusStart &start) const;
  continuation::LocusStart start_at(const LocusOrigin &origin,
                                    periodic::OrbitProblem &problem) const;
  continuation::End follow(periodic::OrbitProblem &problem, const continuation::LocusStart &start);

  KeyedMap &maps_;
  Vector sizes_;
  double second_;
  continuation::Settings settings_;
  LocusTable &table_;
  StepRecord *steps_;
  CurveProgress progress_;
  double left_; ///< parts, two of each locus
  std::vector<Done> done_;
  long loci_ = 0;
};

} // namespace vibroimpact::analyses
