#include "model/histories.h"

#include "model/piecewise_function.h"
#include "model/pulse.h"
#include "model/ramped_harmonic.h"
#include "model/random_history.h"
#include "model/recorded_history.h"
#include "model/sine_sweep.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::model {

namespace {

using parameters::Section;
using parameters::Values;

TimeFunctionPointer create_harmonic(const Values &excitation, const HistoryContext &context) {
  excitation.require("Amplitude");
  excitation.require("Frequency");
  return std::make_shared<Harmonic>(context.given,
                                    excitation.quantity_of("Amplitude", context.dimension),
                                    excitation.quantity("Frequency"), excitation.quantity("Phase"));
}

TimeFunctionPointer create_constant(const Values &excitation, const HistoryContext &context) {
  excitation.require("Amplitude");
  return make_constant(context.given, excitation.quantity_of("Amplitude", context.dimension));
}

struct HistoryEntry {
  const char *name;
  void (*declare)(Section &excitation); ///< nullptr: has no section of its own
  TimeFunctionPointer (*create)(const Values &excitation, const HistoryContext &context);
  std::vector<std::string> keys; ///< of Amplitude, Frequency, Phase those that it uses
};

const std::vector<HistoryEntry> &histories() {
  static const std::vector<HistoryEntry> list = {
      {"harmonic", nullptr, create_harmonic, {"Amplitude", "Frequency", "Phase"}},
      {"ramped harmonic",
       RampedHarmonic::declare,
       RampedHarmonic::create,
       {"Amplitude", "Frequency", "Phase"}},
      {"sine sweep", SineSweep::declare, SineSweep::create, {"Amplitude", "Phase"}},
      {"impulse", declare_pulse, create_pulse, {"Amplitude"}},
      {"recorded", declare_recorded, create_recorded, {}},
      {"random", declare_random, create_random, {}},
      {"constant", nullptr, create_constant, {"Amplitude"}},
  };
  return list;
}

void refuse_unused_keys(const Values &excitation, const HistoryEntry &history) {
  for (const char *key : {"Amplitude", "Frequency", "Phase"})
    if (excitation.given(key) &&
        std::find(history.keys.begin(), history.keys.end(), key) == history.keys.end())
      excitation.reject(key, std::string(key) + " must not be set when History = " + history.name);
}

} // namespace

void declare_histories(Section &excitation) {
  std::vector<std::string> names;
  for (const HistoryEntry &history : histories())
    names.emplace_back(history.name);
  excitation.choice("History", names.front(), names,
                    "How the given quantity changes in time. harmonic: Amplitude sin(Frequency t + "
                    "Phase); constant: Amplitude; the others have their own section.");
  for (const HistoryEntry &history : histories())
    if (history.declare != nullptr)
      history.declare(excitation);
}

TimeFunctionPointer create_history(const Values &excitation, const HistoryContext &context) {
  const std::string chosen = excitation.choice("History");
  for (const HistoryEntry &history : histories())
    if (chosen == history.name) {
      refuse_unused_keys(excitation, history);
      return history.create(excitation, context);
    }
  throw std::logic_error("history without an entry: " + chosen);
}

} // namespace vibroimpact::model
