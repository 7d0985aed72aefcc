// Stress of a body's elements per unit coordinate, from its shapes.
#pragma once

#include "reduction/reduced_body.h"
#include "structure/body_model.h"

namespace vibroimpact::reduction {

/// All elements that meet at a node, as those of one cell; see BodyPoint::stress. `shapes`: 6N x n,
/// rows 6 i + component of node i.
CellStress stress_at_node(const structure::BodyModel &model, int node, const Matrix &shapes);

/// See Recovery::line_stress and Recovery::cell_stress. The mean of the corners of an
/// element stands for its middle, where the stress of a coarse mesh is the best.
CellStress line_stress(const structure::BodyModel &model, const Matrix &shapes);
CellStress cell_stress(const structure::BodyModel &model, const Matrix &shapes);

} // namespace vibroimpact::reduction
