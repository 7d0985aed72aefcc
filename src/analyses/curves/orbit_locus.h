// Locus: special points of periodic motions followed in the plane of two keys.
//
// A branch along the first key, at the value that the file gives to the second one, says where
// special points of the wanted kinds are. From each of them its locus is followed in both
// directions by a bordered system (continuation/locus.h); one that passes another of the points is
// followed once. A locus is one result whose arrays run along `locus_point`.
#pragma once

#include "analyses/curves/locus_follower.h"
#include "analyses/curves/orbit_start.h"

namespace vibroimpact::analyses {

class OrbitLocus : public Analysis {
public:
  struct Settings {
    std::vector<SweptParameter> keys; ///< two, with their ends as values
    std::vector<double> start_values; ///< of the keys, unless they are a frequency [their units]
    std::vector<LocusOf> kinds{LocusOf::fold};
    OrbitStart start;
    continuation::Settings continuation{};
    long levels = 0;        ///< of branches that begin at special points of others
    std::string excitation; ///< whose period is that of the forcing; empty: the only one
    std::vector<RecorderFactory> recorders = default_recorders();
  };
  explicit OrbitLocus(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "locus"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  std::vector<std::vector<parameters::Override>> variants() const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  /// Where the branch begins.
  struct Motion {
    periodic::Orbit orbit;
    Vector sizes{}; ///< of OrbitProblem in two keys
    motion::VariationAccuracy accuracy{};
    double size = 0;                                ///< of its state, scaled
    std::shared_ptr<periodic::FreePeriod> period{}; ///< where it is free
  };
  Vector start_values(const System &system) const;
  Motion first_motion(System &system, LineContext &context, StepRecord *steps) const;
  KeyedMap maps(std::vector<SweptParameter> keys, const Motion &motion, System &system,
                LineContext &context) const;
  std::vector<LocusOrigin> find_origins(const Motion &motion, double first, bool symmetric,
                                        System &system, LineContext &context,
                                        StepRecord *steps) const;
  PointResult compute(System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
