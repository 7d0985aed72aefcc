// Random time histories with a given spectrum: members of a stationary Gaussian process, perhaps
// under an envelope.
//
//   s(t) = w(t) sum over k of A_k cos(k dw t) + B_k sin(k dw t),   lowest <= k dw <= highest
//
// A_k and B_k are independent and normal with the variance G(k dw) dw, so that s is exactly
// Gaussian and, without envelope, stationary, with the spectrum G in lines dw = 2 pi / T apart
// (Shinozuka and Deodatis 1991 discuss such sums). T is at least the duration. It is evaluated by a
// fast Fourier transform at a fraction of the shortest period and goes between these samples by a
// cubic spline, which is the closed form that the exact integration takes.
//
// Amplitudes depend on seed, member and streams alone. An excitation takes shares of several
// streams: with A = g C + sqrt(1 - g^2) D, C of a stream that others have too and D of its own, two
// excitations of shares g and h have the coherence (g h)^2. Shares that change with the frequency:
// coherence.h.
//
//   w = (t / rise)^2 for t < rise, exp(-rate (t - from)) for t > from, else 1   (Jennings 1968)
#pragma once

#include "model/history.h"
#include "model/spectral_density.h"

#include <complex>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::model {

struct RandomStream {
  std::uint64_t seed = 1;
  std::uint64_t member = 1;
  std::string name;
};

/// What A + i B at an angular frequency [rad/s] takes of each stream; the squares of their
/// magnitudes add up to 1.
using StreamShares = std::function<std::vector<std::complex<double>>(double omega)>;

struct RandomDefinition {
  SpectralDensity density;
  double lowest = 0;             ///< [rad/s]
  double highest = 0;            ///< > lowest [rad/s]
  double duration = 0;           ///< > 0 [s]
  double samples_per_period = 8; ///< of the highest frequency
  std::vector<RandomStream> streams;
  StreamShares shares;
  double rise = 0;       ///< [s]
  double decay_from = 0; ///< [s]
  double decay_rate = 0; ///< [1/s]
};

/// Number of samples; of the form 2^a 3^b 5^c and even.
std::size_t random_sample_count(const RandomDefinition &definition);
/// The samples, from t = 0 on; `interval` [s].
std::vector<double> random_samples(const RandomDefinition &definition, double &interval);

void declare_random(parameters::Section &excitation);
TimeFunctionPointer create_random(const parameters::Values &excitation,
                                  const HistoryContext &context);

} // namespace vibroimpact::model
