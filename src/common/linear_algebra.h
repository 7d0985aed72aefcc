// Dense vectors and matrices used after the reduced model. Column-major; double precision, extended
// where the name says so.
#pragma once

#include <Eigen/Core>

#include <complex>

namespace vibroimpact {

using Index = Eigen::Index;
using Vector = Eigen::VectorXd;
using RowVector = Eigen::RowVectorXd;
using Matrix = Eigen::MatrixXd;
using Vector3 = Eigen::Vector3d;
using ComplexVector = Eigen::VectorXcd;
using ComplexMatrix = Eigen::MatrixXcd;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongComplexMatrix = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, Eigen::Dynamic>;
using LongComplexVector = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, 1>;

using VectorView = Eigen::Map<Vector>;
using ConstVectorView = Eigen::Map<const Vector>;

} // namespace vibroimpact
