#include "common/decompositions.h"

#include "common/error.h"
#include "common/scalar.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <unsupported/Eigen/MatrixFunctions>

namespace vibroimpact {

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

Matrix exponential(const Matrix &a) { return a.exp(); }

} // namespace vibroimpact
