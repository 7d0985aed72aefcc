// Deviations in a linear phase, y' = A y + b + loads of the sources: in closed form.
//
// Deviations of the state obey d' = A d, d(h) = exp(A h) d(0), in the coordinates in which A is
// block-diagonal. Those by a key obey d' = A d + dA/dp y + ..., which with the sources' coordinates
// w, w' = G w, is
//
//   [y, w]' = M [y, w],   d[y, w]' = M d[y, w] + dM [y, w],   M = [A B; 0 G]
//
// With [y, w] = C x in the coordinates of the exact phase, x' = D x, the coupling is E = C^-1 dM C
// (forced_response.h).
#pragma once

#include "motion/phase/exact_phases.h"
#include "motion/variation/forced_response.h"
#include "motion/variation/key_tangent.h"

#include <optional>

namespace vibroimpact::motion {

/// The linear phase of one combination of contact modes.
class LinearFlow : public PhasePart {
public:
  /// Keeps a reference.
  explicit LinearFlow(LinearPhase &phase) : phase_(phase) {}
  std::size_t bytes() const override;

  /// columns <- exp(A h) columns, physical_size() rows.
  void propagate(double h, Matrix &columns);
  /// A [1/s]
  const Matrix &generator() const { return phase_.system().matrix(); }
  /// tr A [1/s]: the determinant of the propagator is exp(h tr A).
  double divergence() const { return phase_.system().matrix().trace(); }

  /// What keys add to deviations that are zero at `time`, h later: physical_size() x keys. `state`
  /// is that of the motion at `time`; the phase is under the excitation.
  Matrix forced(const std::vector<KeyTangent *> &keys, const Excitation &excitation, double time,
                const Vector &state, double h);

private:
  /// One key under one excitation.
  struct KnownKey {
    long identity = -1, excitation = -1, sources = -1;
    std::optional<ForcedResponse> response{};
  };
  Matrix changed_inputs(const Matrix &generator, const Matrix &generator_change,
                        const KeyTangent::LinearTangent &tangent) const;
  Matrix coupling(KeyTangent &key, const Excitation &excitation) const;
  const ForcedResponse &response(std::size_t place, KeyTangent &key, const Excitation &excitation);

  LinearPhase &phase_;
  std::vector<KnownKey> keys_;
  Matrix modal_; ///< columns in modal coordinates
};

} // namespace vibroimpact::motion
