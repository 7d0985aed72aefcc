#include "analyses/signals/wavelet.h"

#include "common/fourier.h"
#include "common/zero.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace vibroimpact::analyses {

Wavelet Wavelet::bump(double centre, double width) { return {true, centre, width}; }

Wavelet Wavelet::morlet(double centre) { return {false, centre, 1}; }

double Wavelet::response(double ratio) const {
  const double y = (ratio - 1) * centre_ / width_;
  if (ratio <= 0 || (compact_ && std::abs(y) >= 1))
    return 0;
  return 2 * (compact_ ? std::exp(1 - 1 / (1 - y * y)) : std::exp(-y * y / 2));
}

// The wavelet in time, about its centre frequency, relative to its peak: the even part of h about
// v = 1 is all there is when the factor is symmetric, which both are.
double Wavelet::envelope(double periods) const {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double reach = compact_ ? width_ / centre_ : 9 / centre_;
  const auto integrand = [&](double time) {
    return Quadrature::integrate(
        [&](double v) { return response(1 + v) * std::cos(2 * std::numbers::pi * v * time); }, 0.0,
        reach, 10, 1e-10);
  };
  return integrand(periods) / integrand(0);
}

double Wavelet::decay_periods() const {
  const auto excess = [this](double periods) { return envelope(periods) - std::exp(-1.0); };
  double upper = centre_ / width_ / (2 * std::numbers::pi);
  while (excess(upper) > 0)
    upper *= 1.5;
  return zero_between(excess, 0, upper, 30);
}

// The zeros behind the record are as long as eight decays of the widest wavelet on either side, so
// that its end does not meet its beginning.
WaveletTransform::WaveletTransform(const Wavelet &wavelet, const std::vector<double> &samples,
                                   double interval, double lowest)
    : wavelet_(wavelet), samples_(samples.size()), interval_(interval) {
  const double decay = wavelet.decay_periods() / lowest / interval;
  padded_ = samples_ + static_cast<std::size_t>(std::ceil(8 * decay)) + 1;
  // The next power of two, for speed.
  std::size_t power = 1;
  while (power < padded_)
    power *= 2;
  padded_ = power;
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(samples.size(), 1));
  std::vector<double> record(padded_, 0);
  for (std::size_t n = 0; n < samples_; ++n)
    record[n] = samples[n] - mean;
  lines_ = forward_transform(record);
}

std::vector<std::complex<double>> WaveletTransform::at(double frequency) const {
  std::vector<std::complex<double>> passed(padded_);
  const double spacing = 1 / (static_cast<double>(padded_) * interval_);
  for (std::size_t j = 0; j < lines_.size(); ++j)
    passed[j] = lines_[j] * wavelet_.response(static_cast<double>(j) * spacing / frequency);
  std::vector<std::complex<double>> transform = inverse_transform(passed);
  transform.resize(samples_);
  return transform;
}

std::vector<double> short_time_amplitudes(const std::vector<double> &samples, std::size_t centre,
                                          std::size_t length) {
  std::vector<double> part(length, 0);
  for (std::size_t i = 0; i < length; ++i) {
    const std::size_t shifted = centre + i; // length / 2 ahead of the sample meant
    if (shifted >= length / 2 && shifted - length / 2 < samples.size())
      part[i] = samples[shifted - length / 2];
  }
  return amplitude_spectrum(part, taper("hann", length));
}

} // namespace vibroimpact::analyses
