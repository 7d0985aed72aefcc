#include "analyses/recorders/time_frequency.h"

#include "analyses/results/fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr const char *wavelet_section = "Wavelet";
constexpr const char *spectrogram_section = "Spectrogram";

Sampler sampler_of(const std::vector<Observable> &signals, const Window &window, double interval) {
  const double intervals = std::floor((window.end - window.start) / interval * (1 + 1e-12));
  return {signals, window.start, interval, static_cast<std::size_t>(intervals) + 1};
}

// Equally spaced sample numbers from the first to the last of `samples`.
std::vector<std::size_t> picked(std::size_t samples, long instants) {
  std::vector<std::size_t> numbers;
  const auto wanted = std::min(static_cast<std::size_t>(instants), samples);
  for (std::size_t i = 0; i < wanted; ++i)
    numbers.push_back(wanted > 1 ? i * (samples - 1) / (wanted - 1) : 0);
  return numbers;
}

void add_times(const FieldWriter &result, const std::string &name, double start, double interval,
               const std::vector<std::size_t> &numbers) {
  std::vector<double> times;
  for (const std::size_t number : numbers)
    times.push_back(start + static_cast<double>(number) * interval);
  result.series(name, name, times, "s", "time");
}

// Frequencies x instants.
void add_map(const FieldWriter &result, const std::string &name, const std::string &frequencies,
             const Matrix &values, const Observable &signal) {
  result.array(Label(name + "/" + signal.path, signal.unit,
                     "amplitude of the " + signal.description(), {frequencies, name + "_time"}),
               values);
}

double hertz(const parameters::Values &values, const std::string &key) {
  return values.quantity(key) / (2 * std::numbers::pi);
}

// Above the Nyquist frequency nothing can be resolved.
void require_sampling(const parameters::Values &values, double highest) {
  values.require("Sampling interval");
  if (values.quantity("Sampling interval") * highest > 0.5)
    values.reject("Sampling interval", "must be at most half a period of Highest frequency");
}

std::vector<double> logarithmic(double first, double last, long number) {
  std::vector<double> values;
  for (long i = 0; i < number; ++i)
    values.push_back(
        first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(number - 1)));
  return values;
}

Wavelet read_wavelet(const parameters::Values &values) {
  if (values.choice("Wavelet") == "morlet")
    return Wavelet::morlet(values.quantity("Morlet centre"));
  const double centre = values.quantity("Bump centre");
  const double width = values.quantity("Bump width");
  if (width >= centre)
    values.reject("Bump width", "must be less than Bump centre");
  return Wavelet::bump(centre, width);
}

} // namespace

void WaveletRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      wavelet_section, "Continuous wavelet transform over scale frequency and time; a sine of "
                       "amplitude A shows A on its ridge.");
  declare_signals(section);
  section
      .choice("Wavelet", "bump", {"bump", "morlet"},
              "Bump: sharper in frequency; Morlet: sharper in time.")
      .quantity("Bump centre", "5", dimension::none, range::positive, "mu",
                "Centre frequency of the bump wavelet at scale one.")
      .quantity("Bump width", "0.6", dimension::none, range::positive, "sigma",
                "Half width of the bump wavelet's band at scale one.")
      .quantity("Morlet centre", "6", dimension::none, Range{.lower = 5}, "mu",
                "Centre frequency of the Morlet wavelet; the larger the sharper in frequency.")
      .quantity("Lowest frequency", "", dimension::frequency, range::positive, "",
                "Lowest scale frequency.")
      .required()
      .quantity("Highest frequency", "", dimension::frequency, range::positive, "",
                "Highest scale frequency.")
      .required()
      .integer("Frequencies", "100", Range{.lower = 2, .upper = 1e5}, "",
               "Number of scale frequencies, spaced logarithmically.")
      .quantity("Sampling interval", "", dimension::time, range::positive, "",
                "Interval of the samples that are transformed.")
      .required()
      .integer("Instants", "500", Range{.lower = 2, .upper = 1e7}, "",
               "Number of instants of the result.");
}

RecorderFactory WaveletRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(wavelet_section);
  values.require("Lowest frequency");
  values.require("Highest frequency");
  const double lowest = hertz(values, "Lowest frequency");
  const double highest = hertz(values, "Highest frequency");
  if (highest <= lowest)
    values.reject("Highest frequency", "must be greater than Lowest frequency");
  require_sampling(values, highest);
  const WaveletSettings settings{.wavelet = read_wavelet(values),
                                 .frequencies =
                                     logarithmic(lowest, highest, values.integer("Frequencies")),
                                 .interval = values.quantity("Sampling interval"),
                                 .instants = values.integer("Instants")};
  return [settings, values](const System &system) -> std::unique_ptr<Recorder> {
    return std::make_unique<WaveletRecorder>(chosen_signals(values, system), settings);
  };
}

void WaveletRecorder::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  start_ = window.start;
  samples_ = sampler_of(signals_, window, settings_.interval);
}

void WaveletRecorder::add_fields(const FieldWriter &result) const {
  const std::vector<double> &scales = settings_.frequencies;
  const auto numbers = picked(samples_.values(0).size(), settings_.instants);
  add_times(result, "wavelet_time", start_, settings_.interval, numbers);
  result.series("scale_frequency", "scale_frequency", scales, "Hz",
                "centre frequency of the wavelet");
  std::vector<double> edge;
  const double decay = settings_.wavelet.decay_periods();
  std::transform(scales.begin(), scales.end(), std::back_inserter(edge),
                 [decay](double frequency) { return decay / frequency; });
  result.series("wavelet_edge", "scale_frequency", edge, "s",
                "closer to the ends of the record edge effects are present");
  for (std::size_t s = 0; s < signals_.size(); ++s) {
    const WaveletTransform transform(settings_.wavelet, samples_.values(s), settings_.interval,
                                     scales.front());
    Matrix values(static_cast<Index>(scales.size()), static_cast<Index>(numbers.size()));
    for (Index j = 0; j < values.rows(); ++j) {
      const auto row = transform.at(scales[static_cast<std::size_t>(j)]);
      for (Index i = 0; i < values.cols(); ++i)
        values(j, i) = std::abs(row[numbers[static_cast<std::size_t>(i)]]);
    }
    add_map(result, "wavelet", "scale_frequency", values, signals_[s]);
  }
}

void SpectrogramRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      spectrogram_section, "Amplitude spectra of short intervals of the motion (Hann window) over "
                           "frequency and time.");
  declare_signals(section);
  section
      .quantity("Interval", "", dimension::time, range::positive, "",
                "Length of an interval; lines are its reciprocal apart.")
      .required()
      .quantity("Highest frequency", "", dimension::frequency, range::positive, "",
                "Highest frequency of the result.")
      .required()
      .quantity("Sampling interval", "", dimension::time, range::positive, "",
                "Interval of the samples that are transformed.")
      .required()
      .integer("Instants", "500", Range{.lower = 2, .upper = 1e7}, "",
               "Number of intervals, spread equally over the window.");
}

RecorderFactory SpectrogramRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(spectrogram_section);
  values.require("Interval");
  values.require("Highest frequency");
  const double highest = hertz(values, "Highest frequency");
  require_sampling(values, highest);
  if (values.quantity("Interval") < 4 * values.quantity("Sampling interval"))
    values.reject("Interval", "must be at least four times Sampling interval");
  const SpectrogramSettings settings{.window = values.quantity("Interval"),
                                     .interval = values.quantity("Sampling interval"),
                                     .highest_frequency = highest,
                                     .instants = values.integer("Instants")};
  return [settings, values](const System &system) -> std::unique_ptr<Recorder> {
    return std::make_unique<SpectrogramRecorder>(chosen_signals(values, system), settings);
  };
}

void SpectrogramRecorder::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  start_ = window.start;
  samples_ = sampler_of(signals_, window, settings_.interval);
}

void SpectrogramRecorder::add_fields(const FieldWriter &result) const {
  const auto length = static_cast<std::size_t>(std::round(settings_.window / settings_.interval));
  const double spacing = 1 / (static_cast<double>(length) * settings_.interval);
  std::vector<double> lines;
  for (std::size_t j = 0; j <= length / 2; ++j)
    if (static_cast<double>(j) * spacing <= settings_.highest_frequency * (1 + 1e-12))
      lines.push_back(static_cast<double>(j) * spacing);
  const auto numbers = picked(samples_.values(0).size(), settings_.instants);
  add_times(result, "spectrogram_time", start_, settings_.interval, numbers);
  result.series("spectrogram_frequency", "spectrogram_frequency", lines, "Hz",
                "frequency of a line");
  for (std::size_t s = 0; s < signals_.size(); ++s) {
    Matrix values(static_cast<Index>(lines.size()), static_cast<Index>(numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto amplitudes = short_time_amplitudes(samples_.values(s), numbers[i], length);
      for (std::size_t j = 0; j < lines.size(); ++j)
        values(static_cast<Index>(j), static_cast<Index>(i)) = amplitudes[j];
    }
    add_map(result, "spectrogram", "spectrogram_frequency", values, signals_[s]);
  }
}

} // namespace vibroimpact::analyses
