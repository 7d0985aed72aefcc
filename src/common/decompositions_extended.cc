#include "common/decompositions.h"

#include "common/error.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace vibroimpact::extended {

LongMatrix inverse(const LongMatrix &a) { return a.inverse(); }

LongComplexMatrix inverse(const LongComplexMatrix &a) { return a.inverse(); }

long double determinant(const LongMatrix &a) { return a.determinant(); }

LongMatrix solve_fully_pivoted(const LongMatrix &a, const LongMatrix &b) {
  return a.fullPivLu().solve(b);
}

LongMatrix pivoted_basis(const LongMatrix &a, Index columns) {
  const Eigen::ColPivHouseholderQR<LongMatrix> qr(a);
  return qr.householderQ() * LongMatrix::Identity(a.rows(), columns);
}

LongVector tridiagonal_eigenvalues(const LongVector &diagonal, const LongVector &beside) {
  Eigen::SelfAdjointEigenSolver<LongMatrix> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success)
    throw NumericalError("the eigenvalues of a tridiagonal matrix do not converge");
  return solver.eigenvalues();
}

std::optional<GeneralEigen> general_eigen(const LongMatrix &a) {
  const Eigen::EigenSolver<LongMatrix> solver(a);
  if (solver.info() != Eigen::Success)
    return std::nullopt;
  return GeneralEigen{solver.eigenvalues(), solver.eigenvectors()};
}

ComplexSchurForm complex_schur(const LongComplexMatrix &a) {
  const Eigen::ComplexSchur<LongComplexMatrix> schur(a);
  return {.unitary = schur.matrixU(), .triangular = schur.matrixT()};
}

} // namespace vibroimpact::extended
