// Bodies without a mesh: masses on springs and dashpots, each with one coordinate.
#pragma once

#include "reduction/body_definition.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Throws structure::DefinitionError for a body without masses or a mass that is not positive.
ReducedBody lumped_body(const BodyDefinition &definition);

} // namespace vibroimpact::reduction
