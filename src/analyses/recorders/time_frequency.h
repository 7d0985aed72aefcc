// How the frequencies in a motion change with time: continuous wavelet transform and short-time
// Fourier spectrogram, for swept-sine runs.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/recorders/sampler.h"
#include "analyses/results/field_writer.h"
#include "analyses/signals/wavelet.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct WaveletSettings {
  Wavelet wavelet;
  std::vector<double> frequencies; ///< scale frequencies, increasing [Hz]
  double interval = 0;             ///< between samples [s]
  long instants = 0;               ///< of the result
};

class WaveletRecorder : public Recorder {
public:
  WaveletRecorder(std::vector<Observable> signals, WaveletSettings settings)
      : signals_(std::move(signals)), settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override { samples_.step(view); }
  void add_fields(const FieldWriter &result) const override;

private:
  std::vector<Observable> signals_;
  WaveletSettings settings_;
  double start_ = 0;
  Sampler samples_;
};

struct SpectrogramSettings {
  double window = 0;            ///< length [s]
  double interval = 0;          ///< between samples [s]
  double highest_frequency = 0; ///< [Hz]
  long instants = 0;
};

class SpectrogramRecorder : public Recorder {
public:
  SpectrogramRecorder(std::vector<Observable> signals, SpectrogramSettings settings)
      : signals_(std::move(signals)), settings_(settings) {}

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override { samples_.step(view); }
  void add_fields(const FieldWriter &result) const override;

private:
  std::vector<Observable> signals_;
  SpectrogramSettings settings_;
  double start_ = 0;
  Sampler samples_;
};

} // namespace vibroimpact::analyses
