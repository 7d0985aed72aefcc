#include "integration/flight_ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact {

namespace {
// Without the checks for infinities that the operators have.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
} // namespace

FlightLedger::FlightLedger(const PowerForms &powers, const ExponentialBasis &basis,
                           const StateLayout &layout)
    : input_work_(layout.input_work()), absolute_input_work_(layout.absolute_input_work()) {
  list_exponents(basis);
  list_pairs();
  add_products(powers, basis);
  integrals_.resize(pairs_.size());
  start_.resize(exponents_.size());
  end_.resize(exponents_.size());
}

void FlightLedger::list_exponents(const ExponentialBasis &basis) {
  for (const ExponentialBasis::Group &group : basis.groups) {
    is_pair_.push_back(group.is_pair);
    exponents_.push_back(group.is_pair ? group.exponent : Complex(group.exponent.real()));
    if (group.is_pair)
      exponents_.push_back(std::conj(group.exponent));
  }
  exponents_.emplace_back(0);
}

// [rad/s]; the fastest decay where nothing vibrates.
double FlightLedger::slowest_vibration() const {
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const Complex exponent : exponents_) {
    fastest = std::max(fastest, std::abs(exponent));
    if (exponent.imag() > 0)
      slowest = std::min(slowest, exponent.imag());
  }
  return std::min(slowest, fastest);
}

void FlightLedger::list_pairs() {
  constexpr double slow = 1e-3; // times the longest stretch
  const double slowest = slowest_vibration();
  longest_ = slowest > 0 ? 2 * std::numbers::pi / slowest : std::numeric_limits<double>::infinity();
  const std::size_t count = exponents_.size();
  pairs_.reserve(count * (count + 1) / 2);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i; j < count; ++j) {
      const Complex sum = exponents_[i] + exponents_[j];
      const double square = std::norm(sum);
      const bool is_slow = !(square * longest_ * longest_ >= slow * slow);
      pairs_.push_back({.first = i,
                        .second = j,
                        .sum = sum,
                        .inverse = is_slow ? Complex() : std::conj(sum) / square,
                        .is_slow = is_slow});
    }
}

std::size_t FlightLedger::place_of(Index entry) {
  const auto known = std::find(entries_.begin(), entries_.end(), entry);
  const auto place = static_cast<std::size_t>(known - entries_.begin());
  if (known == entries_.end()) {
    entries_.push_back(entry);
    coefficients_.resize(entries_.size() * pairs_.size());
  }
  return place;
}

// A form c Re(a) + d Im(a) of an amplitude is (c - i d) / 2 a + (c + i d) / 2 conj(a).
void FlightLedger::add_products(const PowerForms &powers, const ExponentialBasis &basis) {
  const Matrix seen = powers.rows().lazyProduct(basis.columns);
  const std::size_t count = exponents_.size();
  std::vector<Complex> forms(2 * count);
  for (std::size_t k = 0; k < powers.size(); ++k) {
    for (std::size_t factor = 0; factor < 2; ++factor) {
      const auto row = static_cast<Index>(2 * k + factor);
      Complex *form = &forms[factor * count];
      for (const ExponentialBasis::Group &group : basis.groups) {
        if (!group.is_pair) {
          *form++ = seen(row, group.column);
          continue;
        }
        *form++ = {0.5 * seen(row, group.column), -0.5 * seen(row, group.column + 1)};
        *form++ = {0.5 * seen(row, group.column), 0.5 * seen(row, group.column + 1)};
      }
      *form = powers.constants()[row];
    }
    const Complex *a = forms.data();
    const Complex *b = forms.data() + count;
    Complex *coefficient = &coefficients_[place_of(powers.entry(k)) * pairs_.size()];
    for (const Pair &pair : pairs_) {
      *coefficient += product(a[pair.first], b[pair.second]);
      if (pair.first != pair.second)
        *coefficient += product(a[pair.second], b[pair.first]);
      ++coefficient;
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
    const Complex *coefficient = &coefficients_[entry * pairs_.size()];
    double integral = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      integral += coefficient[k].real() * integrals_[k].real() -
                  coefficient[k].imag() * integrals_[k].imag();
    state[entries_[entry]] += integral;
    if (entries_[entry] == input_work_)
      state[absolute_input_work_] += std::abs(integral);
  }
}

} // namespace vibroimpact
