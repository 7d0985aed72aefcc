// Dense vectors and matrices used after the reduced model. Column-major, double precision.
#pragma once

#include <Eigen/Core>

namespace vibroimpact {

using Index = Eigen::Index;
using Vector = Eigen::VectorXd;
using RowVector = Eigen::RowVectorXd;
using Matrix = Eigen::MatrixXd;
using Vector3 = Eigen::Vector3d;

using VectorView = Eigen::Map<Vector>;
using ConstVectorView = Eigen::Map<const Vector>;

} // namespace vibroimpact
