#include "modes/rayleigh_ritz.h"

#include "modes/relative_jacobi.h"

#include <Eigen/Cholesky>

namespace vibroimpact::modes {

namespace {

// x <- x L^-T with x^T M x = L L^T, twice because the first pass leaves the round-off of an
// ill-conditioned x.
Block orthonormalise(const EigenProblem &problem, Block x) {
  const Layout layout(problem.mass);
  for (int pass = 0; pass < 2; ++pass) {
    const Matrix gram = inner_products(layout, x, multiply(problem.mass, x));
    const Eigen::LLT<Matrix> cholesky(gram);
    if (cholesky.info() != Eigen::Success)
      throw NumericalError("The approximate modes are linearly dependent");
    if (x.rows() > 0) // a rank may have none
      cholesky.matrixU().solveInPlace<Eigen::OnTheRight>(x);
  }
  return x;
}

Block residuals(const EigenProblem &problem, const Eigenpairs &pairs) {
  return multiply(problem.accurate_stiffness, pairs.vectors) -
         multiply(problem.mass, pairs.vectors) * pairs.values.asDiagonal();
}

} // namespace

Eigenpairs rayleigh_ritz(const EigenProblem &problem, Block x) {
  x = orthonormalise(problem, std::move(x));
  const Layout layout(problem.mass);
  const Matrix projected = inner_products(layout, x, multiply(problem.accurate_stiffness, x));
  const double largest = projected.diagonal().cwiseAbs().maxCoeff();
  const DenseEigenpairs dense =
      relative_jacobi((projected + projected.transpose()) / 2, 1e-20 * largest);
  return {dense.values, x * dense.vectors};
}

Correction inverse_iteration(const EigenProblem &problem, const Factorisation &shifted,
                             const Eigenpairs &pairs) {
  const Block r = residuals(problem, pairs);
  Correction correction{.step = shifted.solve(r), .residual_products = {}};
  correction.residual_products = inner_products(Layout(problem.mass), r, correction.step);
  return correction;
}

double orthogonality_residual(const EigenProblem &problem, const Block &x) {
  const Layout layout(problem.mass);
  const Matrix gram = inner_products(layout, x, multiply(problem.mass, x));
  return (gram - Matrix::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
}

} // namespace vibroimpact::modes
