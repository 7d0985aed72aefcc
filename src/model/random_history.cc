#include "model/random_history.h"

#include "common/fourier.h"
#include "common/uniform_numbers.h"
#include "model/recorded_history.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace vibroimpact::model {

namespace {

using std::numbers::pi;
constexpr std::size_t most_samples = std::size_t{1} << 24;

// FNV-1a: the same on every machine.
std::uint64_t hash_of(const std::string &name) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : name)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  return hash;
}

/// Pairs of independent normal numbers with variance 1, as real and imaginary part.
class NormalPairs {
public:
  explicit NormalPairs(const RandomStream &stream)
      : numbers_({stream.seed, stream.seed >> 32, stream.member, hash_of(stream.name),
                  hash_of(stream.name) >> 32}) {}

  // Box and Muller 1958
  std::complex<double> next() {
    const double radius = std::sqrt(-2 * std::log(1 - numbers_.next()));
    return std::polar(radius, 2 * pi * numbers_.next());
  }

private:
  UniformNumbers numbers_;
};

std::vector<std::complex<double>> next_of_each(std::vector<NormalPairs> &streams) {
  std::vector<std::complex<double>> drawn;
  for (NormalPairs &stream : streams)
    drawn.push_back(stream.next());
  return drawn;
}

std::complex<double> mixed(const std::vector<std::complex<double>> &drawn,
                           const std::vector<std::complex<double>> &shares) {
  return std::inner_product(drawn.begin(), drawn.end(), shares.begin(), std::complex<double>());
}

bool is_fast(std::size_t size) {
  for (const std::size_t factor : {2, 3, 5})
    while (size % factor == 0)
      size /= factor;
  return size == 1;
}

double sample_interval(const RandomDefinition &definition) {
  return 2 * pi / (definition.highest * definition.samples_per_period);
}

double envelope_of(const RandomDefinition &definition, double time) {
  if (time < definition.rise)
    return time * time / (definition.rise * definition.rise);
  const double since = time - definition.decay_from;
  return since > 0 ? std::exp(-definition.decay_rate * since) : 1;
}

} // namespace

std::size_t random_sample_count(const RandomDefinition &definition) {
  auto count = static_cast<std::size_t>(
      std::ceil(definition.duration / sample_interval(definition) * (1 - 1e-12)) + 1);
  count += count % 2;
  while (!is_fast(count))
    count += 2;
  return count;
}

std::vector<double> random_samples(const RandomDefinition &definition, double &interval) {
  const std::size_t count = random_sample_count(definition);
  interval = sample_interval(definition);
  const double spacing = 2 * pi / (interval * static_cast<double>(count));
  std::vector<NormalPairs> streams(definition.streams.begin(), definition.streams.end());
  std::vector<std::complex<double>> lines(count);
  for (std::size_t k = 1; k < count / 2; ++k) {
    const double omega = spacing * static_cast<double>(k);
    const std::vector<std::complex<double>> drawn = next_of_each(streams);
    if (omega >= definition.lowest && omega <= definition.highest)
      lines[k] = std::sqrt(definition.density(omega) * spacing) *
                 std::conj(mixed(drawn, definition.shares(omega))) * static_cast<double>(count);
  }
  std::vector<double> samples;
  samples.reserve(count);
  for (const std::complex<double> &value : inverse_transform(lines))
    samples.push_back(value.real() *
                      envelope_of(definition, interval * static_cast<double>(samples.size())));
  return samples;
}

namespace {

using parameters::Values;

void declare_envelope(parameters::Section &random) {
  using namespace parameters;
  random
      .quantity("Rise time", "0 s", dimension::time, range::non_negative, "t_1",
                "The history rises with the square of the time until then.")
      .quantity("Decay from", "", dimension::time, range::non_negative, "t_2",
                "Instant from which it fades; without it it does not.")
      .quantity("Decay rate", "", dimension::inverse_time, range::positive, "c",
                "It fades as exp(-Decay rate (t - Decay from)).")
      .required("Decay from is given");
}

void declare_streams(parameters::Section &random) {
  using namespace parameters;
  const Range counted{.lower = 0, .upper = 1e15};
  random.integer("Seed", "1", counted, "", "Other seeds give other histories.")
      .integer("Member", "1", counted, "",
               "Of the ensemble: a parameter grid over it makes the members.")
      .text("Stream", "",
            "Excitations of the same stream have the same amplitudes; empty: the excitation's "
            "name, its own.")
      .text("Common stream", "", "Stream that this excitation shares with others in part.")
      .quantity("Common share", "0", dimension::none, range::fraction, "g",
                "Of the amplitudes; the coherence of two excitations is the square of the product "
                "of theirs.");
  declare_coherent_place(random);
}

/// The streams, and what the amplitudes take of each.
void read_streams(const Values &random, const HistoryContext &context,
                  RandomDefinition &definition) {
  const RandomStream own{.seed = static_cast<std::uint64_t>(random.integer("Seed")),
                         .member = static_cast<std::uint64_t>(random.integer("Member")),
                         .name =
                             random.text("Stream").empty() ? context.name : random.text("Stream")};
  const auto add = [&](const std::string &name) {
    definition.streams.push_back(own);
    definition.streams.back().name = name;
  };
  const CoherentPlaces &coherent = context.coherent;
  if (!coherent.streams.empty()) {
    for (const std::string &name : coherent.streams)
      add(name);
    definition.shares = [coherent](double omega) { return coherent.shares(omega); };
    return;
  }
  std::vector<std::complex<double>> shares = {1};
  if (const double share = random.quantity("Common share"); share > 0) {
    add(random.text("Common stream"));
    shares = {share, std::sqrt(1 - share * share)};
  }
  add(own.name);
  definition.shares = [shares](double) { return shares; };
}

/// What the history adds to the times: it begins and ends with it.
RandomDefinition read_random(const Values &random, const HistoryContext &context) {
  for (const char *key : {"Highest frequency", "Duration"})
    random.require(key);
  RandomDefinition definition{.density = read_spectral_density(random, context.dimension),
                              .lowest = random.quantity("Lowest frequency"),
                              .highest = random.quantity("Highest frequency"),
                              .duration = random.quantity("Duration"),
                              .samples_per_period = random.quantity("Samples per period"),
                              .streams = {},
                              .shares = {},
                              .rise = random.quantity("Rise time")};
  read_streams(random, context, definition);
  definition.decay_from =
      random.has("Decay from") ? random.quantity("Decay from") : definition.duration * 2;
  if (random.has("Decay from"))
    random.require("Decay rate");
  if (random.has("Decay rate"))
    definition.decay_rate = random.quantity("Decay rate");
  return definition;
}

void check_random(const Values &random, const RandomDefinition &definition) {
  if (!(definition.highest > definition.lowest))
    random.reject("Highest frequency", "must be greater than Lowest frequency");
  if (random.given("Decay rate") && !random.given("Decay from"))
    random.reject("Decay rate", "must not be set without Decay from");
  if (definition.decay_from < definition.rise)
    random.reject("Decay from", "must not lie before Rise time");
  if (random.given("Common share") && random.text("Common stream").empty())
    random.reject("Common share", "must not be set without Common stream");
  const double count = definition.duration / sample_interval(definition);
  if (count > static_cast<double>(most_samples))
    random.reject("Duration", "must be shorter: there would be more than " +
                                  std::to_string(most_samples) +
                                  " samples, which Highest frequency and Samples per period make");
}

} // namespace

void declare_random(parameters::Section &excitation) {
  using namespace parameters;
  Section &random = excitation.subsection(
      "Random", "The given quantity as a member of a Gaussian random process with a given "
                "spectrum. After Duration it is that of the record's end: a force is zero.");
  declare_spectral_density(random);
  random
      .quantity("Lowest frequency", "0 Hz", dimension::frequency, range::non_negative, "f_1",
                "Nothing below it.")
      .quantity("Highest frequency", "", dimension::frequency, range::positive, "f_2",
                "Nothing above it.")
      .required("History = random")
      .quantity("Duration", "", dimension::time, range::positive, "T", "Length of the history.")
      .required("History = random")
      .quantity("Samples per period", "8", dimension::none, Range{.lower = 4, .upper = 1000}, "",
                "Samples in a period of the highest frequency, between which a cubic spline goes.");
  declare_envelope(random);
  declare_streams(random);
}

TimeFunctionPointer create_random(const Values &excitation, const HistoryContext &context) {
  const Values random = excitation.subsection("Random");
  const RandomDefinition definition = read_random(random, context);
  check_random(random, definition);
  double interval = 0;
  Samples samples{.time = {}, .value = random_samples(definition, interval)};
  for (std::size_t k = 0; k < samples.value.size(); ++k)
    samples.time.push_back(interval * static_cast<double>(k));
  const bool held = context.moves_base && context.given != Given::acceleration;
  return make_recorded(context.given, samples, Interpolation::cubic_spline,
                       held ? OutsideRecord::held : OutsideRecord::zero);
}

} // namespace vibroimpact::model
