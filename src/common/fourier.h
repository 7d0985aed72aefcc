// Discrete Fourier transforms (FFTW) and amplitude spectra of equally spaced samples.
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace vibroimpact {

/// sum over n of x_n exp(-2 pi i j n / N) for j = 0 ... N/2.
std::vector<std::complex<double>> forward_transform(const std::vector<double> &samples);
/// sum over j of X_j exp(2 pi i j n / N) / N for n = 0 ... N - 1.
std::vector<std::complex<double>> inverse_transform(const std::vector<std::complex<double>> &lines);

/// Weights w_n of N samples: "none" (all 1) or "hann" (periodic, sin^2(pi n / N)).
std::vector<double> taper(const std::string &name, std::size_t samples);

/// One-sided amplitudes at j / (N interval), j = 0 ... N/2: a sine of amplitude A on a line shows A
/// there; line 0 is the mean. `weights` has N entries.
std::vector<double> amplitude_spectrum(const std::vector<double> &samples,
                                       const std::vector<double> &weights);

} // namespace vibroimpact
