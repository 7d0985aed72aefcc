// What the modes that are left out add at points whose static flexibility is known (rubin1975,
// macneal1971).
//
// With R the static flexibility that the modes lack at a point, symmetric and positive
// semidefinite, R = sum_i lambda_i w_i w_i^T, a residual mode
//
//   a_i'' + 2 zeta omega_r a_i' + omega_r^2 a_i = sqrt(lambda_i) omega_r w_i . f
//
// moves the point by sqrt(lambda_i) omega_r w_i a_i: R exactly under static forces. The mass at the
// point that it stands for, 1 / (lambda_i omega_r^2), is not 0, as rigid sides would exchange no
// impulse with a point without mass. omega_r stands above the modes given. The modes left out have
//
//   sum phi^2 / omega_j^2 = R,   sum phi^2 / omega_j^4 = R / omega_r^2
//
// the second being right too, for omega_j ~ j^p and components of one size, if omega_r^2 =
// omega_N^2 (4 p - 1) / (2 p - 1): 3 for rods and plates (p = 1), 7/3 for beams in bending.
#pragma once

#include "reduction/modal_definition.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Sets BodyPoint::flexibility where the definition says how stiff a point is. Throws
/// DefinitionError for a point stiffer than its modes.
void set_flexibility(const ModalDefinition &definition, ReducedBody &body);

/// Appends the residual modes for the attachments. Between different points R counts as 0. Throws
/// DefinitionError where it is not known.
void add_residual_modes(const ModalDefinition &definition, ReducedBody &body);

} // namespace vibroimpact::reduction
