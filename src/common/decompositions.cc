#include "common/decompositions.h"

#include <Eigen/LU>
#include <Eigen/QR>

namespace vibroimpact {

template <class Dense> struct LuFactors<Dense>::Factors { Eigen::PartialPivLU<Dense> of; };

template <class Dense> void LuFactors<Dense>::compute(const Dense &a) {
  if (!factors_ || factors_.use_count() > 1)
    factors_ = std::make_shared<Factors>();
  factors_->of.compute(a);
}

template <class Dense> Dense LuFactors<Dense>::solve(const Dense &b) const {
  return factors_->of.solve(b);
}

template <class Dense>
typename LuFactors<Dense>::Column LuFactors<Dense>::solve(const Column &b) const {
  return factors_->of.solve(b);
}

template <class Dense>
typename LuFactors<Dense>::Column LuFactors<Dense>::solve_transposed(const Column &b) const {
  return factors_->of.transpose().solve(b);
}

template <class Dense> Dense LuFactors<Dense>::inverse() const { return factors_->of.inverse(); }

template <class Dense> typename Dense::Scalar LuFactors<Dense>::determinant() const {
  return factors_->of.determinant();
}

template <class Dense> double LuFactors<Dense>::reciprocal_condition() const {
  return factors_->of.rcond();
}

template class LuFactors<Matrix>;
template class LuFactors<ComplexMatrix>;

Matrix inverse(const Matrix &a) { return a.inverse(); }
double determinant(const Matrix &a) { return a.determinant(); }

Vector solve_fully_pivoted(const Matrix &a, const Vector &b) { return a.fullPivLu().solve(b); }

bool is_invertible(const Matrix &a) { return a.fullPivLu().isInvertible(); }
Matrix null_space(const Matrix &a) { return a.fullPivLu().kernel(); }

Vector least_norm_solution(const Matrix &a, const Vector &b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Matrix least_norm_solution(const Matrix &a, const Matrix &b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

struct LeastNorm::Factors {
  Eigen::CompleteOrthogonalDecomposition<Matrix> of;
};

LeastNorm::LeastNorm(const Matrix &a)
    : factors_(
          std::make_shared<Factors>(Factors{Eigen::CompleteOrthogonalDecomposition<Matrix>(a)})) {}

Matrix LeastNorm::solve(const Matrix &b) const { return factors_->of.solve(b); }

Orthonormal orthonormalised(const Matrix &a, Basis which) {
  const Eigen::HouseholderQR<Matrix> qr(a);
  const Index columns = which == Basis::whole ? a.rows() : a.cols();
  return {.basis = qr.householderQ() * Matrix::Identity(a.rows(), columns),
          .diagonal = qr.matrixQR().diagonal()};
}

struct PivotedQr::Factors {
  Eigen::ColPivHouseholderQR<Matrix> of;
};

PivotedQr::PivotedQr(const Matrix &a, std::optional<double> threshold) {
  auto factors = std::make_shared<Factors>(Factors{Eigen::ColPivHouseholderQR<Matrix>(a)});
  if (threshold)
    factors->of.setThreshold(*threshold);
  factors_ = std::move(factors);
}

Index PivotedQr::rank() const { return factors_->of.rank(); }
Vector PivotedQr::solve(const Vector &b) const { return factors_->of.solve(b); }

Matrix PivotedQr::basis(Index columns) const {
  return factors_->of.householderQ() * Matrix::Identity(factors_->of.rows(), columns);
}

} // namespace vibroimpact
