// Which of the many equally good bases of the modes is taken. Eigenvectors are free in sign, and
// those of a multiple frequency in any rotation among themselves; solvers return a different choice
// for every number of ranks. The rule makes the reduced body, and all that follows, reproducible.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::reduction {

/// Rows 6 i + component of `shapes` belong to node i; columns are modes with ascending eigenvalues.
/// Rows of the nodes `points`, in order, and then those of all nodes are gone through. A row that
/// is significant (above 1e-3 of the largest of its kind, displacement or rotation, where that kind
/// reaches 1e-2 of the other one, converted by `length`, the size of the body [m]; 0 where there
/// are no places) fixes one mode of each group of equal eigenvalues: the first such row is (+, 0,
/// 0, ...) in the group, the next
/// (*, +, 0, ...), and so on. For a single mode this fixes the sign.
void fix_basis(const Vector &eigenvalues, const std::vector<int> &points, double length,
               Matrix &shapes);

/// Eigenvalues that count as equal are replaced by their mean, as the basis mixes their modes.
Vector merge_multiple(const Vector &eigenvalues);

} // namespace vibroimpact::reduction
