#include "modes/relative_jacobi.h"

#include "common/error.h"

#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace vibroimpact::modes {

namespace {

constexpr int most_sweeps = 60;

bool negligible(const Matrix &a, Index i, Index j, double floor) {
  const double scale = std::sqrt((std::abs(a(i, i)) + floor) * (std::abs(a(j, j)) + floor));
  return std::abs(a(i, j)) <= std::numeric_limits<double>::epsilon() * scale;
}

bool sweep(Matrix &a, Matrix &vectors, double floor) {
  bool rotated = false;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = i + 1; j < a.rows(); ++j) {
      if (negligible(a, i, j, floor))
        continue;
      Eigen::JacobiRotation<double> rotation;
      rotation.makeJacobi(a, i, j);
      a.applyOnTheLeft(i, j, rotation.adjoint());
      a.applyOnTheRight(i, j, rotation);
      a(i, j) = a(j, i) = 0;
      vectors.applyOnTheRight(i, j, rotation);
      rotated = true;
    }
  return rotated;
}

} // namespace

DenseEigenpairs relative_jacobi(Matrix a, double floor) {
  Matrix vectors = Matrix::Identity(a.rows(), a.rows());
  for (int count = 0; sweep(a, vectors, floor); ++count)
    if (count > most_sweeps)
      throw NumericalError("Jacobi rotations did not converge");
  std::vector<Index> order(a.rows());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return a(i, i) < a(j, j); });
  DenseEigenpairs pairs{Vector(a.rows()), Matrix(a.rows(), a.rows())};
  for (Index k = 0; k < a.rows(); ++k) {
    pairs.values[k] = a(order[k], order[k]);
    pairs.vectors.col(k) = vectors.col(order[k]);
  }
  return pairs;
}

} // namespace vibroimpact::modes
