// What a contact lacks of its bodies when only some of their modes are kept, before any motion.
//
// An impact that is short against the periods of all modes meets the mass m = 1 / (w M^-1 w^T), w
// the contact's row: of the kept coordinates m_N, of the bodies before reduction m_inf <= m_N. For
// a force k u^n between two bodies the peak force at a given speed grows like m^p, p = n / (n + 1);
// between rigid sides the impulse does, p = 1. Its error by truncation is then
//
//   (m_N / m_inf)^p - 1
//
// Against a spring k the time scale is known, Omega = sqrt(k / m_N), and modes that are fast
// against it answer statically. The part of each side that is left out is then taken for one
// oscillator with the inverse mass D = 1/m_inf - 1/m_N and the flexibility f that the side lacks,
// whose displacement per force at Omega is between f and D / Omega^2:
//
//   sqrt(1 + k sum 1 / (1/f' + Omega^2/D)) - 1,     f' = f (1 + Omega^2 / omega_N^2)
//
// omega_N is the highest frequency kept. The modes that are left out have the receptance
// sum w_j^2 / (omega_j^2 - Omega^2): f, and to the next order in Omega^2 at most f Omega^2 /
// omega_N^2 more. Attachment modes a carry f, and as they stand for sums over many modes also the
// next order; of the one after that, sum w_j^2 Omega^4 / omega_j^6, about as much is missing as
// they have themselves, s Omega^4 with s = sum w_a^2 / omega_a^6, and not much more than D Omega^2
// / omega_N^4: the smaller of the two is added to f'. Where f is not known, D / omega_N^2 >= f
// takes the place of f'.
#pragma once

#include "contact/contact_set.h"

#include <string>
#include <vector>

namespace vibroimpact::contact {

/// Of one side of a contact, or of both when they belong to the same body: what the kept
/// coordinates lack along the normal.
struct Remainder {
  double inverse_mass = 0; ///< D >= 0 [1/kg]
  double flexibility = 0;  ///< f >= 0, 0 with attachment modes [m/N]; NaN where it is not known
  double frequency = 0;    ///< omega_N, of the kept coordinates that move the side [rad/s]
  double attached = 0;     ///< s, of the attachment modes [m s^4/N]
};

/// Relative error of the peak force (rigid sides: of the impulse) of an impact, that of the
/// formulas above. NaN for a law that says nothing about its force. `kept_mass` = m_N > 0 [kg].
double impact_error(const ContactLaw &law, double kept_mass,
                    const std::vector<Remainder> &remainders);

/// Measures of a contact that are known before any motion.
struct ContactFigures {
  std::string name;
  double clearance = 0;          ///< [m]
  double flexibility_share = 0;  ///< of the kept coordinates; NaN where it is not known
  double least_share = 0;        ///< below it there is a warning
  double impact_error = 0;       ///< see above; NaN where it is not known
  std::string no_impact_error{}; ///< why it is not known, where a body does not say; else empty
  double largest_error = 0;      ///< above it there is a warning
  /// Shortest period of the kept coordinates of the side where it is longer [s]; 0 where no mesh
  /// takes part.
  double shortest_period = 0;
};

std::vector<ContactFigures> contact_figures(const ContactSet &contacts, const model::Model &model);

/// One sentence that names the contacts whose kept coordinates carry too little of the static
/// flexibility, with their shares; empty when there are none.
std::string flexibility_warning(const std::vector<ContactFigures> &contacts);
/// The same for those whose impacts have too large an error.
std::string impact_warning(const std::vector<ContactFigures> &contacts);

} // namespace vibroimpact::contact
