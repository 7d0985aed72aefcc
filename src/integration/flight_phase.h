// A linear phase for the kernel of unwatched flights: its guards as sums of exponentials, and the
// way from the state to the amplitudes and back.
#pragma once

#include "integration/exponential_basis.h"
#include "integration/guard_forms.h"
#include "integration/guard_sums.h"

#include <vector>

namespace vibroimpact {

/// What happens at a guard.
struct FlightGuard {
  std::size_t contact = 0;
  std::size_t guard = 0;
  int target = 0; ///< mode of the contact's law
};

class FlightPhase {
public:
  /// For the present modes of the equations. `inverse`: from y less the response to the inputs to
  /// the columns of the modes.
  FlightPhase(const Equations &equations, ExponentialBasis basis, Matrix inverse);

  const std::vector<int> &contact_modes() const { return contact_modes_; }
  const ExponentialBasis &basis() const { return basis_; }
  const std::vector<FlightGuard> &guards() const { return guards_; }
  Index size() const { return inverse_.rows(); }
  std::size_t n_groups() const { return basis_.groups.size(); }

  /// y and the sources: size() + 3 sources entries.
  void rows(const Amplitudes &amplitudes, Vector &rows) const;
  /// Amplitudes of the modes from y, when those of the inputs are in place.
  void find_modes(const Vector &y, Amplitudes &amplitudes);

  /// New internal states when a guard is passed, in the rows just before; y is changed in place.
  void reset(std::size_t guard, const Vector &rows, Vector &y) const;

  const GuardSums &sums() const { return sums_; }

private:
  struct Reset {
    Index row = 0; ///< in y
    RowVector form;
    double constant = 0;
  };
  void add_sums(const Equations &equations);
  void add_guards(const Equations &equations, std::size_t contact);

  std::vector<int> contact_modes_;
  ExponentialBasis basis_;
  Matrix inverse_;
  std::vector<FlightGuard> guards_;
  std::vector<std::vector<Reset>> resets_;
  GuardSums sums_;
  Vector rest_;
};

} // namespace vibroimpact
