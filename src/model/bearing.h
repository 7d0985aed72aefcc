// Bearings of shafts: springs and dashpots along two directions at right angles, which join them.
//
//   (F_1, F_2) = K e + C e'      e = u_b - u_a along the two directions [m]
//                                K = (k11 k12; k21 k22) [N/m], C likewise [N s/m]
//
// is the force on the first side. Films of oil and seals have k12 and k21 of opposite signs: the
// skew part of K is a circulatory force, which takes work from what turns the shaft and drives its
// whirl where dashpots do not take more (childs1993). The skew part of C does no work.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

namespace vibroimpact::model {

/// Declares the kind "Bearing".
void declare_bearings(parameters::Section &root);

/// Adds all bearings of the file to the model; its sources must be complete. InputError for unknown
/// points, directions that are not at right angles, and a bearing without any constant.
void add_bearings(const parameters::Values &root, Model &model);

} // namespace vibroimpact::model
