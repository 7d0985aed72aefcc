// The two ends of a contact or a connection as the parameter file names them.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::model {

/// What the second end may be instead of a point.
inline constexpr const char *side_stop = "stop";     ///< fixed in space
inline constexpr const char *side_ground = "ground"; ///< the same, for connections
inline constexpr const char *side_base = "base";     ///< the base the first end's body stands on

struct Sides {
  std::string a; ///< "body.point"
  std::string b; ///< "body.point" or one of the names above
};

/// Reads the key Between. With one entry the second end is the first of `fixed`. InputError for
/// ends that are not in `known`, for more than two ends and for an end joined to itself; `form`
/// says what they are: "points as BODY.POINT, BODY.POINT".
Sides read_sides(const parameters::Values &section, const std::vector<std::string> &fixed,
                 std::vector<std::string> known, const std::string &form);

/// The same with all points of the model.
Sides read_sides(const parameters::Values &section, const std::vector<std::string> &fixed,
                 const Model &model);

/// (u_b - u_a) . n along an axis n, or the rotation about it, of two points, or of one and a place
/// that is fixed in space (`absolute`) or on the base of the first.
Projection relative_displacement(const PointReference &a, const std::optional<PointReference> &b,
                                 bool absolute, const MotionAxis &axis, const Model &model);

/// The same as a projection of the motion: absolute displacements, or relative to
/// the base where the second end is the base.
Projection relative_displacement(const Sides &sides, const MotionAxis &axis, const Model &model);

} // namespace vibroimpact::model
