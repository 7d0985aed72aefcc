#include "model/spectral_density.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibroimpact::model {

namespace {

using parameters::Dimension;
using parameters::Values;

using std::numbers::pi;

/// What the key Density has of a quantity: the radian counts only where nothing else does.
Dimension density_dimension(const Dimension &quantity) {
  const bool plain = quantity.length == 0 && quantity.mass == 0;
  return {.length = 2 * quantity.length,
          .mass = 2 * quantity.mass,
          .time = 2 * quantity.time + 1,
          .angle = plain ? 2 * quantity.angle - 1 : 0};
}

SpectralDensity white(const Values &random, const Dimension &quantity) {
  const double density = random.quantity_of("Density", density_dimension(quantity));
  return [density](double) { return density; };
}

// Straight lines between the points, zero beyond them.
SpectralDensity table(const Values &random, const Dimension &quantity) {
  random.require_dimension("Densities", density_dimension(quantity));
  const std::vector<double> at = random.quantities("Frequencies");
  const std::vector<double> values = random.quantities("Densities");
  if (values.size() != at.size())
    random.reject("Densities", "must be as many as Frequencies");
  if (std::adjacent_find(at.begin(), at.end(), std::greater_equal<>()) != at.end())
    random.reject("Frequencies", "must increase");
  return [at, values](double omega) {
    const auto above = std::upper_bound(at.begin(), at.end(), omega);
    if (above == at.begin() || (above == at.end() && omega > at.back()))
      return 0.0;
    if (above == at.end())
      return values.back();
    const auto k = static_cast<std::size_t>(above - at.begin());
    const double share = (omega - at[k - 1]) / (at[k] - at[k - 1]);
    return (1 - share) * values[k - 1] + share * values[k];
  };
}

// White noise through ground of one resonance (Kanai 1957, Tajimi 1960), and a filter that takes
// away what is slow (Clough and Penzien 1975).
SpectralDensity kanai_tajimi(const Values &random, const Dimension &quantity) {
  const double density = random.quantity_of("Density", density_dimension(quantity));
  const double ground = random.quantity("Ground frequency");
  const double ratio = random.quantity("Ground damping ratio");
  const double filter = random.has("Filter frequency") ? random.quantity("Filter frequency") : 0;
  const double filter_ratio = random.quantity("Filter damping ratio");
  const auto resonance = [](double r, double zeta) {
    return (1 - r * r) * (1 - r * r) + 4 * zeta * zeta * r * r;
  };
  return [=](double omega) {
    const double r = omega / ground;
    const double through = density * (1 + 4 * ratio * ratio * r * r) / resonance(r, ratio);
    const double f = filter > 0 ? omega / filter : 0;
    return filter > 0 ? through * f * f * f * f / resonance(f, filter_ratio) : through;
  };
}

double read_variance(const Values &random, const Dimension &quantity) {
  const double rms = random.quantity_of("Root mean square", quantity);
  return rms * rms;
}

// Longitudinal turbulence (von Karman 1948), tau length scale over mean speed:
//   G(f) = 4 s^2 tau / (1 + 70.8 (f tau)^2)^(5/6)
SpectralDensity von_karman(const Values &random, const Dimension &quantity) {
  const double variance = read_variance(random, quantity), tau = random.quantity("Time scale");
  return [=](double omega) {
    const double x = omega / (2 * pi) * tau;
    return 4 * variance * tau / std::pow(1 + 70.8 * x * x, 5.0 / 6) / (2 * pi);
  };
}

// Correlation s^2 exp(-|t| / tau): G(w) = (2/pi) s^2 tau / (1 + (w tau)^2)
SpectralDensity exponential(const Values &random, const Dimension &quantity) {
  const double variance = read_variance(random, quantity), tau = random.quantity("Time scale");
  return [=](double omega) { return 2 / pi * variance * tau / (1 + omega * omega * tau * tau); };
}

struct SpectrumEntry {
  const char *name;
  std::vector<std::string> required, optional; ///< keys that it uses
  SpectralDensity (*create)(const Values &random, const Dimension &quantity);
};

const std::vector<SpectrumEntry> &spectra() {
  static const std::vector<SpectrumEntry> list = {
      {"white", {"Density"}, {}, white},
      {"table", {"Frequencies", "Densities"}, {}, table},
      {"kanai-tajimi",
       {"Density", "Ground frequency"},
       {"Ground damping ratio", "Filter frequency", "Filter damping ratio"},
       kanai_tajimi},
      {"von karman", {"Root mean square", "Time scale"}, {}, von_karman},
      {"exponential", {"Root mean square", "Time scale"}, {}, exponential},
  };
  return list;
}

bool uses(const SpectrumEntry &entry, const std::string &key) {
  return std::find(entry.required.begin(), entry.required.end(), key) != entry.required.end() ||
         std::find(entry.optional.begin(), entry.optional.end(), key) != entry.optional.end();
}

} // namespace

void declare_spectral_density(parameters::Section &random) {
  using namespace parameters;
  std::vector<std::string> names;
  for (const SpectrumEntry &entry : spectra())
    names.emplace_back(entry.name);
  random
      .choice("Spectrum", "white", names,
              "white: Density between the two frequencies; table: straight lines; kanai-tajimi: "
              "white noise through the ground, for earthquakes; von karman: turbulence; "
              "exponential: correlation that fades as exp(-t / Time scale).")
      .quantity(
          "Density", "", dimension::any, range::non_negative, "G_0",
          "One-sided power spectral density, such as N^2/Hz or (m/s^2)^2/Hz: the variance is "
          "its integral over the frequency. Of kanai-tajimi that of the white noise below the "
          "ground.")
      .required("Spectrum = white or kanai-tajimi")
      .quantities("Frequencies", "", dimension::frequency, range::non_negative, "",
                  "Of the points of a table.", 2, 100000)
      .required("Spectrum = table")
      .quantities("Densities", "", dimension::any, range::non_negative, "",
                  "As many, in the unit of Density.", 2, 100000)
      .required("Spectrum = table")
      .quantity("Ground frequency", "", dimension::frequency, range::positive, "\\omega_g",
                "Resonance of the ground.")
      .required("Spectrum = kanai-tajimi")
      .quantity("Ground damping ratio", "0.6", dimension::none, range::positive, "\\zeta_g",
                "Of that resonance.")
      .quantity("Filter frequency", "", dimension::frequency, range::positive, "\\omega_f",
                "Below it the spectrum falls off with the fourth power; without it it does not.")
      .quantity("Filter damping ratio", "0.6", dimension::none, range::positive, "\\zeta_f",
                "Of this filter.")
      .quantity("Root mean square", "", dimension::any, range::non_negative, "\\sigma",
                "Of the quantity over all frequencies.")
      .required("Spectrum = von karman or exponential")
      .quantity("Time scale", "", dimension::time, range::positive, "\\tau",
                "Of turbulence its length scale over the mean speed.")
      .required("Spectrum = von karman or exponential");
}

SpectralDensity read_spectral_density(const Values &random, const Dimension &quantity) {
  const std::string chosen = random.choice("Spectrum");
  for (const SpectrumEntry &entry : spectra()) {
    if (chosen != entry.name)
      continue;
    for (const SpectrumEntry &other : spectra())
      for (const auto &keys : {other.required, other.optional})
        for (const std::string &key : keys)
          if (random.given(key) && !uses(entry, key))
            random.reject(key, key + " must not be set when Spectrum = " + chosen);
    for (const std::string &key : entry.required)
      random.require(key);
    return entry.create(random, quantity);
  }
  throw std::logic_error("spectrum without an entry: " + chosen);
}

} // namespace vibroimpact::model
