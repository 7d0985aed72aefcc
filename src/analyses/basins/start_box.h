// Starts between two ends of some keys that change initial conditions and nothing else.
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "analyses/run/system.h"

namespace vibroimpact::analyses {

class StartBox {
public:
  /// From systems at the ends of the keys, their first and last values, with other values fixed.
  /// InputError when a key changes more than initial conditions, or these not in proportion.
  StartBox(const std::vector<SweptParameter> &keys, const std::vector<parameters::Override> &fixed,
           const SystemSource &build);

  /// With all keys at their first values.
  const System &system() const { return system_; }
  /// `shares`: one for each key, 0 at its first value and 1 at its last one.
  model::InitialState start(const Vector &shares) const;
  /// Largest entry of a start at the ends of any key.
  double size() const { return size_; }

private:
  System system_;
  Vector origin_; ///< coordinates, then velocities
  Matrix slopes_; ///< one column for each key
  double size_ = 0;
};

/// Do two systems move alike from every start? Compares all they are made of: matrices, loads,
/// histories over a period, gaps, and what the contact laws do at local states of the given size.
bool same_motions(const System &a, const System &b, double size);

} // namespace vibroimpact::analyses
