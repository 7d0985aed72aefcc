// Power spectral densities of random excitations.
//
// One-sided and by angular frequency: G(w) >= 0 for w > 0, the variance is the integral of G. A
// unit per Hz is one per 2 pi rad/s.
#pragma once

#include "parameters/values.h"

#include <functional>

namespace vibroimpact::model {

/// G [square of the quantity's unit times s/rad] at an angular frequency > 0 [rad/s].
using SpectralDensity = std::function<double(double)>;

/// Declares the choice Spectrum and its keys.
void declare_spectral_density(parameters::Section &random);

/// `quantity`: dimension of what the density is of. InputError for keys that the spectrum does not
/// use, and for a table that is none.
SpectralDensity read_spectral_density(const parameters::Values &random,
                                      const parameters::Dimension &quantity);

} // namespace vibroimpact::model
