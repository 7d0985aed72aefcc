// The harmonic balance of a system at any value of a key, for continuation.
#pragma once

#include "analyses/keys/keyed_system.h"
#include "periodic/harmonic_model.h"

#include <optional>

namespace vibroimpact::analyses {

class KeyedBalance : public continuation::HarmonicSystem {
public:
  /// Keeps references. A frequency is set in `system` itself; for another key the systems are built
  /// by `context`. `intervals` of a period for `harmonics`.
  KeyedBalance(const SweptParameter &parameter, const std::string &excitation, System &system,
               const LineContext &context, Index harmonics, Index intervals);

  continuation::HarmonicEquations equations(double key) override;
  continuation::ForceSeries force(Index element, const RowVector &displacement,
                                  bool slopes) override {
    return balance_->force(element, displacement, slopes);
  }

  /// Of the last equations().
  const System &system() const { return *keyed_.system(); }
  const periodic::HarmonicModel &balance() const { return *balance_; }

private:
  KeyedSystem keyed_;
  Index harmonics_;
  periodic::HarmonicGrids grids_;
  std::optional<periodic::HarmonicModel> balance_;
  continuation::HarmonicEquations equations_;
  std::optional<double> key_; ///< of these
};

} // namespace vibroimpact::analyses
