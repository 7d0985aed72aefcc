// Which guards of a phase are zero where a motion enters it, and what rounding has made of the
// amplitudes there.
#pragma once

#include "motion/path/known_phases.h"

#include <functional>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

class GuardsAtStart {
public:
  /// By its derivatives in the phase: what the value of a guard is known to.
  using KnownTo = std::function<double(std::size_t guard, const double *derivatives)>;
  /// Order of the zero from which a guard rises; 0: it falls. Without it the slope says so.
  using Order = std::function<int(std::size_t guard, const double *derivatives)>;

  /// A motion begins without rounding; phases have `largest` coordinates at most.
  void begin(std::size_t largest);
  /// Guards of the contact that changed, or of all, may be zero in a phase to come and must rise
  /// then; what those of other contacts do, the kernel sees. False: one falls at once.
  bool enter(const KnownPhase &phase, std::optional<std::size_t> contact, const double *amplitudes,
             const AlignedArray &rounding, const KnownTo &known_to, const Order &order = {});
  /// The motion stays in the phase before.
  void stay(const KnownPhase &phase);
  /// What rounding may hide of a guard.
  double hidden(const PhaseView &view, std::size_t guard, const double *amplitudes) const;

  /// Of the amplitudes: here, and in the phase to come, which becomes that here.
  const AlignedArray &rounding() const { return rounding_; }
  AlignedArray &next_rounding() { return next_rounding_; }
  void take_next_rounding() { rounding_.swap(next_rounding_); }
  /// As the march takes them.
  const double *noise() const { return noise_.data(); }
  std::vector<unsigned char> &order() { return order_; }

private:
  const Kernel &kernel_ = kernel();
  AlignedArray rounding_, next_rounding_, noise_;
  std::vector<unsigned char> order_;
};

} // namespace vibroimpact::motion
