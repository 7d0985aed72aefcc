// Published relations between a restitution coefficient e and the dimensionless damping
// d_c = mu v_c / k of the Hunt–Crossley force F = k u^n (1 + (mu/k) u'), for an impact of two free
// bodies at approach speed v_c.
//
//   exact                 (1 + e) d_c = ln[(1 + d_c) / (1 - e d_c)]   see docs/theory.md
//   hunt-crossley         d_c = 3/2 (1 - e)                            Hunt & Crossley 1975
//   herbert-mcwhannell    d_c = 6 (1 - e) / [(2 e - 1)^2 + 3]          Herbert & McWhannell 1977
//   lee-wang              d_c = 3/4 (1 - e)                            Lee & Wang 1983
//   lankarani-nikravesh   d_c = 3/4 (1 - e^2)                          Lankarani & Nikravesh 1994
//   gonthier              d_c = (1 - e^2) / e                          Gonthier et al. 2004
//   flores                d_c = 8/5 (1 - e) / e                        Flores et al. 2011
//
// all of them as collected by Machado et al. 2012. The exact relation holds for every exponent n
// and goes as 3/2 (1 - e) for e -> 1. So do hunt-crossley, herbert-mcwhannell and
// lankarani-nikravesh. The others do not: lee-wang gives half of it, gonthier 4/3 and flores 16/15,
// being made for strongly damped impacts; for e -> 0 gonthier grows like 1/e as the exact one does,
// flores like 1.6/e, and those without e in the denominator stay finite.
#pragma once

#include <string>
#include <vector>

namespace vibroimpact::contact {

/// d_c >= 0 for e in (0, 1]. Throws std::invalid_argument for another e or an unknown relation.
double dimensionless_damping(const std::string &relation, double restitution_coefficient);

/// e in (0, 1] that a Hunt–Crossley contact of two free bodies shows: the exact relation solved for
/// e. d_c >= 0.
double exact_restitution(double dimensionless_damping);

/// Names for the parameter file.
std::vector<std::string> restitution_relations();

} // namespace vibroimpact::contact
