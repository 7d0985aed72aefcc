// Locus: special points of periodic motions followed in the plane of two keys.
//
// A branch along the first key, at the value that the file gives to the second one, says where
// special points of the wanted kinds are. From each of them its locus is followed in both
// directions by a bordered system (continuation/locus.h); one that passes another of the points is
// followed once. A locus is one result whose arrays run along `locus_point`.
#pragma once

#include "analyses/analysis.h"
#include "analyses/orbit_start.h"
#include "analyses/recorders.h"
#include "analyses/swept_parameter.h"
#include "continuation/locus.h"

namespace vibroimpact::analyses {

/// What special points a locus can be one of.
enum class SpecialKind { fold, period_doubling, loss_of_symmetry, neimark_sacker, graze };

class OrbitLocus : public Analysis {
public:
  struct Settings {
    std::vector<SweptParameter> keys; ///< two, with their ends as values
    std::vector<double> start_values; ///< of the keys, unless they are a frequency [their units]
    std::vector<SpecialKind> kinds{SpecialKind::fold};
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
  Vector start_values(const System &system) const;
  PointResult compute(System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
