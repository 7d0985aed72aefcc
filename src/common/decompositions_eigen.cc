#include "common/decompositions.h"

#include "common/error.h"
#include "common/scalar.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <unsupported/Eigen/MatrixFunctions>

namespace vibroimpact {

namespace {

bool strictly_upper(const Matrix &a) {
  for (Index j = 0; j < a.cols(); ++j)
    if (!a.col(j).tail(a.rows() - j).isZero(0))
      return false;
  return true;
}

} // namespace

SingularValues singular_values(const Matrix &a) {
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

SingularValues right_singular_values(const Matrix &a) {
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeThinV);
  return {{}, svd.singularValues(), svd.matrixV()};
}

std::optional<Vector> solve_well_conditioned(const Matrix &a, const Vector &b, double least) {
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  if (svd.singularValues().minCoeff() < least)
    return std::nullopt;
  return svd.solve(b);
}

SymmetricEigen symmetric_eigen(const Matrix &a) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Vector tridiagonal_eigenvalues(const Vector &diagonal, const Vector &beside) {
  Eigen::SelfAdjointEigenSolver<Matrix> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success)
    throw NumericalError("the eigenvalues of a tridiagonal matrix do not converge");
  return solver.eigenvalues();
}

std::optional<ComplexVector> try_eigenvalues(const Matrix &a) {
  const Eigen::EigenSolver<Matrix> solver(a, false);
  if (solver.info() != Eigen::Success)
    return std::nullopt;
  return solver.eigenvalues();
}

ComplexVector eigenvalues(const Matrix &a) {
  if (auto values = try_eigenvalues(a))
    return *std::move(values);
  return ComplexVector::Constant(a.rows(), nan);
}

GeneralEigen general_eigen(const Matrix &a) {
  const Eigen::EigenSolver<Matrix> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

std::optional<Matrix> cholesky(const Matrix &a) {
  const Eigen::LLT<Matrix> factors(a);
  if (factors.info() != Eigen::Success)
    return std::nullopt;
  return Matrix(factors.matrixL());
}

// Of a strictly triangular matrix, as polynomials have, Taylor's series ends and is exact.
Matrix exponential(const Matrix &a) {
  if (!strictly_upper(a))
    return a.exp();
  Matrix sum = Matrix::Identity(a.rows(), a.cols());
  Matrix term = sum;
  for (Index k = 1; k < a.rows(); ++k) {
    term = term.lazyProduct(a).eval() / static_cast<double>(k);
    sum += term;
  }
  return sum;
}

} // namespace vibroimpact
