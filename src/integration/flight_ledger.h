// Energies and impulses of a stretch of a linear phase in closed form.
//
// All powers are sums of products of two linear forms of the motion, so that with z the
// exponentials of the phase, their conjugates and 1 a power is the sum over i <= j of
// q_ij z_i z_j, and
//
//   integral of z_i z_j over h = [z_i z_j] / (e_i + e_j)         ([] = end - start)
//
// Where e_i + e_j is next to zero that is lost in rounding, and the integral is taken from both
// ends by the trapezoidal rule with its first correction, which is exact to (|e_i + e_j| h)^4 /
// 720.
#pragma once

#include "integration/exponential_basis.h"
#include "integration/guard_sums.h"
#include "integration/phase_forms.h"

#include <vector>

namespace vibroimpact::integration {

class FlightLedger {
public:
  /// For a phase with these powers, made of these exponentials; keeps references to both.
  FlightLedger(const PowerForms &powers, const ExponentialBasis &basis, const StateLayout &layout);

  /// The frequencies of the inputs are others.
  void renew();

  /// The longest stretch that is integrated to rounding [s].
  double longest() const { return longest_; }

  /// Adds the integrals over a stretch of length h to the ledger in `state`. In place of the
  /// integral of |power| stands the absolute value of the integral, which is never larger.
  void add(const Amplitudes &start, const Amplitudes &end, double h, Vector &state);

private:
  struct Pair {
    std::size_t first = 0, second = 0;
    Complex sum{};        ///< e_first + e_second
    Complex inverse{};    ///< of the sum
    bool is_slow = false; ///< by the trapezoidal rule
  };

  void list_exponents();
  void list_pairs();
  void list_entries();
  double slowest_vibration() const;
  void set_from(std::size_t group);
  std::size_t set_exponents(std::size_t group);
  void set_pairs(std::size_t first);
  void set_forms(std::size_t group, std::size_t place);
  void set_coefficients(std::size_t first);
  void exponentials(const Amplitudes &amplitudes, std::vector<Complex> &z) const;

  const PowerForms &powers_;
  const ExponentialBasis &basis_;
  double longest_ = 0;
  Index input_work_ = 0, absolute_input_work_ = 0;
  std::vector<bool> is_pair_;      // of the groups
  std::vector<Complex> exponents_; // of z
  std::vector<Pair> pairs_;
  std::vector<Index> entries_;        // of the state
  std::vector<std::size_t> place_of_; // of the powers, among the entries
  std::vector<Complex> forms_;        // of the powers, two for each, by z
  std::vector<Complex> coefficients_; // entries x pairs
  std::vector<Complex> start_, end_, integrals_;
};

} // namespace vibroimpact::integration
