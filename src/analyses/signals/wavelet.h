// Continuous wavelet transform with analytic wavelets, and the short-time Fourier transform.
//
// A wavelet of scale frequency f passes the part of a signal around f: in the frequency domain it
// is the real factor h(v), v = (frequency)/f, that vanishes for negative frequencies and is 2 at
// v = 1. So the modulus of the transform of a sine of amplitude A is A on its ridge, the scale
// frequency that equals its own, and its argument is that of the analytic signal.
//
//   bump    h = 2 exp(1 - 1 / (1 - y^2)),  y = (v - 1) mu / sigma;  0 where |y| >= 1
//   morlet  h = 2 exp(-(v - 1)^2 mu^2 / 2);                         0 where v <= 0
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

class Wavelet {
public:
  /// Bump wavelet: centre mu > width sigma > 0.
  static Wavelet bump(double centre, double width);
  /// Morlet wavelet of centre mu > 0 (about 2 pi times the periods within its standard deviation).
  static Wavelet morlet(double centre);

  /// h(v)
  double response(double ratio) const;
  /// Time in which the envelope of the wavelet falls to 1/e of its peak, times the scale frequency:
  /// closer than that to an end of the record the transform is not to be trusted.
  double decay_periods() const;

private:
  Wavelet(bool compact, double centre, double width)
      : compact_(compact), centre_(centre), width_(width) {}
  double envelope(double periods) const;

  bool compact_;
  double centre_, width_;
};

/// The transform of a record, its mean taken off and zeros set before and behind.
class WaveletTransform {
public:
  /// `interval` between samples [s] > 0; `lowest`: smallest scale frequency wanted [Hz].
  WaveletTransform(const Wavelet &wavelet, const std::vector<double> &samples, double interval,
                   double lowest);

  /// W(frequency, t) at every sample.
  std::vector<std::complex<double>> at(double frequency) const;

private:
  Wavelet wavelet_;
  std::size_t samples_;
  double interval_;
  std::size_t padded_; ///< samples with the zeros behind
  std::vector<std::complex<double>> lines_;
};

/// Amplitudes of a Hann window of `length` samples around sample `centre` (zeros beyond the ends),
/// at j / (length interval), j = 0 ... length/2. A sine of amplitude A on a line shows A there.
std::vector<double> short_time_amplitudes(const std::vector<double> &samples, std::size_t centre,
                                          std::size_t length);

} // namespace vibroimpact::analyses
