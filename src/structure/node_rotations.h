// Rotations that no element has: those of nodes of solids alone.
#pragma once

#include "structure/body_model.h"

namespace vibroimpact::structure {

/// Holds the rotations of nodes at which no element turns and that belong to no rigid body, so that
/// they are no unknowns. Supports, points, loads and rigid bodies are there. Throws DefinitionError
/// for supports, masses and moments that ask for such a rotation, and for a rigid link that leaves
/// one without stiffness.
void hold_idle_rotations(BodyModel &model, const BodyParts &parts,
                         const std::vector<RigidLink> &links);

} // namespace vibroimpact::structure
