#include "common/fourier.h"

#include <fftw3.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <type_traits>

namespace vibroimpact {

namespace {

using Complex = std::complex<double>;

// Plans are neither measured nor dependent on where the samples lie in memory, so that equal
// samples give equal bits.
constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;

using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, decltype(&fftw_destroy_plan)>;

void run(fftw_plan made) {
  const Plan plan(made, &fftw_destroy_plan);
  if (!plan)
    throw std::logic_error("no plan for a Fourier transform");
  fftw_execute(plan.get());
}

// FFTW's complex numbers are laid out as those of C++.
fftw_complex *raw(std::vector<Complex> &values) {
  return reinterpret_cast<fftw_complex *>(values.data());
}

} // namespace

std::vector<Complex> forward_transform(const std::vector<double> &samples) {
  std::vector<double> in = samples;
  std::vector<Complex> lines(samples.size() / 2 + 1);
  run(fftw_plan_dft_r2c_1d(static_cast<int>(in.size()), in.data(), raw(lines), flags));
  return lines;
}

std::vector<Complex> inverse_transform(const std::vector<Complex> &lines) {
  std::vector<Complex> samples = lines;
  run(fftw_plan_dft_1d(static_cast<int>(lines.size()), raw(samples), raw(samples), FFTW_BACKWARD,
                       flags));
  for (Complex &sample : samples)
    sample /= static_cast<double>(samples.size());
  return samples;
}

std::vector<double> taper(const std::string &name, std::size_t samples) {
  std::vector<double> weights(samples, 1);
  if (name == "hann")
    for (std::size_t n = 0; n < samples; ++n) {
      const double s =
          std::sin(std::numbers::pi * static_cast<double>(n) / static_cast<double>(samples));
      weights[n] = s * s;
    }
  return weights;
}

std::vector<double> amplitude_spectrum(const std::vector<double> &samples,
                                       const std::vector<double> &weights) {
  std::vector<double> tapered(samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n)
    tapered[n] = weights[n] * samples[n];
  const std::vector<Complex> lines = forward_transform(tapered);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> amplitudes;
  for (std::size_t j = 0; j < lines.size(); ++j) {
    const bool single = j == 0 || 2 * j == samples.size();
    amplitudes.push_back((single ? 1 : 2) * std::abs(lines[j]) / sum);
  }
  return amplitudes;
}

} // namespace vibroimpact
