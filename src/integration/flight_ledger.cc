#include "integration/flight_ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::integration {

namespace {
// Without the checks for infinities that the operators have.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
} // namespace

FlightLedger::FlightLedger(const PowerForms &powers, const ExponentialBasis &basis,
                           const StateLayout &layout)
    : powers_(powers), basis_(basis), input_work_(layout.input_work()),
      absolute_input_work_(layout.absolute_input_work()) {
  list_exponents();
  list_pairs();
  list_entries();
  integrals_.resize(pairs_.size());
  start_.resize(exponents_.size());
  end_.resize(exponents_.size());
  set_from(0);
}

void FlightLedger::renew() { set_from(basis_.n_modes()); }

void FlightLedger::list_exponents() {
  for (const ExponentialBasis::Group &group : basis_.groups) {
    is_pair_.push_back(group.is_pair);
    exponents_.resize(exponents_.size() + (group.is_pair ? 2 : 1));
  }
  exponents_.emplace_back(0);
}

void FlightLedger::list_pairs() {
  for (std::size_t i = 0; i < exponents_.size(); ++i)
    for (std::size_t j = i; j < exponents_.size(); ++j)
      pairs_.push_back({.first = i, .second = j});
}

void FlightLedger::list_entries() {
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const auto known = std::find(entries_.begin(), entries_.end(), powers_.entry(k));
    place_of_.push_back(static_cast<std::size_t>(known - entries_.begin()));
    if (known == entries_.end())
      entries_.push_back(powers_.entry(k));
  }
  coefficients_.resize(entries_.size() * pairs_.size());
  forms_.resize(2 * powers_.size() * exponents_.size());
}

// All that depends on this group and those after it.
void FlightLedger::set_from(std::size_t group) {
  const std::size_t first = set_exponents(group);
  const double slowest = slowest_vibration();
  longest_ = slowest > 0 ? 2 * std::numbers::pi / slowest : std::numeric_limits<double>::infinity();
  set_pairs(first);
  set_forms(group, first);
  set_coefficients(first);
}

// The place of the group's first exponent.
std::size_t FlightLedger::set_exponents(std::size_t group) {
  std::size_t place = 0;
  for (std::size_t j = 0; j < group; ++j)
    place += is_pair_[j] ? 2 : 1;
  const std::size_t first = place;
  for (std::size_t j = group; j < basis_.groups.size(); ++j) {
    const Complex exponent = basis_.groups[j].exponent;
    exponents_[place++] = is_pair_[j] ? exponent : Complex(exponent.real());
    if (is_pair_[j])
      exponents_[place++] = std::conj(exponent);
  }
  return first;
}

// [rad/s]; the fastest decay where nothing vibrates.
double FlightLedger::slowest_vibration() const {
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const Complex exponent : exponents_) {
    fastest = std::max(fastest, std::norm(exponent));
    if (exponent.imag() > 0)
      slowest = std::min(slowest, exponent.imag());
  }
  return std::min(slowest, std::sqrt(fastest));
}

// Those with an exponent from `first` on; whether a pair is slow depends on all exponents.
void FlightLedger::set_pairs(std::size_t first) {
  constexpr double slow = 1e-3; // times the longest stretch
  for (Pair &pair : pairs_) {
    if (pair.second >= first) {
      pair.sum = exponents_[pair.first] + exponents_[pair.second];
      pair.inverse = std::conj(pair.sum) / std::norm(pair.sum);
    }
    pair.is_slow = !(std::norm(pair.sum) * longest_ * longest_ >= slow * slow);
  }
}

// Re(c a) of an amplitude is c / 2 a + conj(c) / 2 conj(a).
void FlightLedger::set_forms(std::size_t group, std::size_t place) {
  const std::size_t count = exponents_.size();
  for (std::size_t row = 0; row < 2 * powers_.size(); ++row) {
    Complex *form = forms_.data() + row * count + place;
    for (std::size_t j = group; j < basis_.groups.size(); ++j) {
      const Complex seen =
          seen_of_group(powers_.rows(), static_cast<Index>(row), basis_, basis_.groups[j]);
      *form++ = is_pair_[j] ? 0.5 * seen : seen;
      if (is_pair_[j])
        *form++ = 0.5 * std::conj(seen);
    }
    *form = powers_.constants()[static_cast<Index>(row)];
  }
}

void FlightLedger::set_coefficients(std::size_t first) {
  const std::size_t count = exponents_.size();
  for (std::size_t entry = 0; entry < entries_.size(); ++entry)
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      if (pairs_[p].second >= first)
        coefficients_[entry * pairs_.size() + p] = 0;
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const Complex *a = forms_.data() + 2 * k * count;
    const Complex *b = a + count;
    Complex *coefficient = coefficients_.data() + place_of_[k] * pairs_.size();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const Pair &pair = pairs_[p];
      if (pair.second < first)
        continue;
      coefficient[p] += product(a[pair.first], b[pair.second]);
      if (pair.first != pair.second)
        coefficient[p] += product(a[pair.second], b[pair.first]);
    }
  }
}

void FlightLedger::exponentials(const Amplitudes &amplitudes, std::vector<Complex> &z) const {
  std::size_t place = 0;
  for (std::size_t j = 0; j < is_pair_.size(); ++j) {
    const Complex amplitude(amplitudes.real[j], is_pair_[j] ? amplitudes.imaginary[j] : 0.0);
    z[place++] = amplitude;
    if (is_pair_[j])
      z[place++] = std::conj(amplitude);
  }
  z[place] = 1;
}

void FlightLedger::add(const Amplitudes &start, const Amplitudes &end, double h, Vector &state) {
  exponentials(start, start_);
  exponentials(end, end_);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Pair &pair = pairs_[k];
    const Complex before = product(start_[pair.first], start_[pair.second]);
    const Complex after = product(end_[pair.first], end_[pair.second]);
    const Complex change = after - before;
    integrals_[k] = pair.is_slow
                        ? 0.5 * h * (before + after) - h * h / 12 * product(pair.sum, change)
                        : product(change, pair.inverse);
  }
  for (std::size_t entry = 0; entry < entries_.size(); ++entry) {
    const Complex *coefficient = coefficients_.data() + entry * pairs_.size();
    double integral = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      integral += coefficient[k].real() * integrals_[k].real() -
                  coefficient[k].imag() * integrals_[k].imag();
    state[entries_[entry]] += integral;
    if (entries_[entry] == input_work_)
      state[absolute_input_work_] += std::abs(integral);
  }
}

} // namespace vibroimpact::integration
