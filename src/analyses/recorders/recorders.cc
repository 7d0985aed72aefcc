#include "analyses/recorders/recorders.h"

#include "analyses/recorders/energy.h"
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/forces.h"
#include "analyses/recorders/friction.h"
#include "analyses/recorders/history.h"
#include "analyses/recorders/impacts.h"
#include "analyses/recorders/level_crossings.h"
#include "analyses/recorders/lyapunov.h"
#include "analyses/recorders/quasi_static.h"
#include "analyses/recorders/regime.h"
#include "analyses/recorders/section.h"
#include "analyses/recorders/spectrum.h"
#include "analyses/recorders/statistics.h"
#include "analyses/recorders/stresses.h"
#include "analyses/recorders/time_frequency.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

constexpr RecorderKind recorder_kinds[] = {
    {"extreme values", "smallest and largest values", ExtremeValues::declare,
     ExtremeValues::create},
    {"statistics", "means and root mean squares", Statistics::declare, Statistics::create},
    {"level crossings", "how often levels are passed, and for how long", LevelCrossings::declare,
     LevelCrossings::create},
    {"impacts", "figures of the impacts", Impacts::declare, Impacts::create},
    {"stresses", "largest von Mises stresses", Stresses::declare, Stresses::create},
    {"energy", "works and losses", Energy::declare, Energy::create},
    {"forces", "forces in connections and on the base, transmissibility", Forces::declare,
     Forces::create},
    {"friction", "work, wear and ways of friction, sticking and slipping",
     FrictionRecorder::declare, FrictionRecorder::create},
    {"quasi static", "static displacement under the frozen excitation", QuasiStatic::declare,
     QuasiStatic::create},
    {"history", "sampled time histories", History::declare, History::create},
    {"section", "Poincare and other sections", SectionRecorder::declare, SectionRecorder::create},
    {"regime", "repetition and character of the motion", RegimeRecorder::declare,
     RegimeRecorder::create},
    {"lyapunov", "largest Lyapunov exponent", LyapunovRecorder::declare, LyapunovRecorder::create},
    {"spectrum", "amplitude spectra and orders", SpectrumRecorder::declare,
     SpectrumRecorder::create},
    {"wavelet", "continuous wavelet transform", WaveletRecorder::declare, WaveletRecorder::create},
    {"spectrogram", "short-time spectra", SpectrogramRecorder::declare,
     SpectrogramRecorder::create},
};

std::vector<std::string> recorder_names() {
  std::vector<std::string> names;
  for (const RecorderKind &kind : recorder_kinds)
    names.emplace_back(kind.name);
  return names;
}

} // namespace

void declare_recorders(parameters::Section &analysis) {
  std::string list;
  for (const RecorderKind &kind : recorder_kinds)
    list += (list.empty() ? "" : ", ") + std::string(kind.name) + " (" + kind.description + ")";
  analysis.names("Record", "",
                 "What is kept of the recorded window: " + list +
                     ", or none. Empty means extreme values and impacts, and none in a transient "
                     "analysis, which has its histories.");
  for (const RecorderKind &kind : recorder_kinds)
    kind.declare(analysis);
}

std::vector<RecorderFactory> read_recorders(const parameters::Values &analysis,
                                            const std::vector<std::string> &fallback) {
  std::vector<std::string> names = analysis.has("Record") ? analysis.names("Record") : fallback;
  if (names == std::vector<std::string>{"none"})
    names.clear();
  for (const std::string &name : names)
    analysis.require_known("Record", name, recorder_names());
  std::vector<RecorderFactory> factories;
  for (const RecorderKind &kind : recorder_kinds)
    if (std::find(names.begin(), names.end(), kind.name) != names.end())
      factories.push_back(kind.create(analysis));
  return factories;
}

std::vector<RecorderFactory> default_recorders() {
  return {[](const System &system) {
            return std::make_unique<ExtremeValues>(ObservedSelection{}, system);
          },
          [](const System &system) { return std::make_unique<Impacts>(system); }};
}

} // namespace vibroimpact::analyses
