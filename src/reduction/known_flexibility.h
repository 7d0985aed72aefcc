// What is known of a body's static flexibility, whole and kept.
#pragma once

#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Are its coordinates modes, so that some may be left out? Of beams, shells, and bodies that are
/// given by their modes.
bool has_modes(const ReducedBody &body);

/// direction^T flexibility direction [m/N]. NaN where it is not known: without
/// BodyPoint::flexibility, and where that has NaN for an axis along which `direction` points.
double flexibility_along(const BodyPoint &point, const Vector3 &direction);

/// Of the coordinates of the body: sum of row^2 / stiffness over those that have one [m/N].
double kept_flexibility(const ReducedBody &body, const RowVector &row);

} // namespace vibroimpact::reduction
