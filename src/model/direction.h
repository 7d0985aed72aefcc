// Directions in a parameter file: "x", "-z", or three numbers; "rz" and "-rz" for rotations.
#pragma once

#include "common/linear_algebra.h"
#include "model/motion_axis.h"
#include "parameters/values.h"

#include <initializer_list>
#include <optional>
#include <string>

namespace vibroimpact::model {

/// Unit vector; nothing when the text is no direction or has length zero.
std::optional<Vector3> parse_direction(const std::string &text);

/// Unit vector of a text key; InputError otherwise.
Vector3 read_direction(const parameters::Values &values, const std::string &key);

/// A direction, or one of rx, ry, rz, -rx, -ry, -rz for a rotation about x, y or z; InputError
/// otherwise.
MotionAxis read_motion_axis(const parameters::Values &values, const std::string &key);

/// Of the keys for displacements and those for rotations only the ones that the axis has may be
/// given. InputError.
void check_axis_keys(const parameters::Values &values, const MotionAxis &axis,
                     std::initializer_list<const char *> of_displacements,
                     std::initializer_list<const char *> of_rotations);

} // namespace vibroimpact::model
