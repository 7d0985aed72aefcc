// Decompositions of dense matrices of any size, made in one place: their templates are instantiated
// once, which is a third of the time of a build otherwise. Methods and results are Eigen's; what is
// singular or does not converge is the caller's to judge, by what these return.
#pragma once

#include "common/linear_algebra.h"

#include <memory>
#include <optional>

namespace vibroimpact {

/// P A = L U with partial pivoting, A square; of `Dense` Matrix or ComplexMatrix.
template <class Dense> class LuFactors {
public:
  using Column = Eigen::Matrix<typename Dense::Scalar, Eigen::Dynamic, 1>;

  LuFactors() = default;
  explicit LuFactors(const Dense &a) { compute(a); }
  /// Without allocation where the size is that of before.
  void compute(const Dense &a);

  /// A^-1 b
  Dense solve(const Dense &b) const;
  Column solve(const Column &b) const;
  /// A^-T b
  Column solve_transposed(const Column &b) const;
  Dense inverse() const;
  typename Dense::Scalar determinant() const;
  /// An estimate of 1 / (|A| |A^-1|).
  double reciprocal_condition() const;

private:
  struct Factors;
  std::shared_ptr<Factors> factors_; ///< none: not made yet
};

extern template class LuFactors<Matrix>;
extern template class LuFactors<ComplexMatrix>;

Matrix inverse(const Matrix &a);
double determinant(const Matrix &a);

/// A^-1 b with full pivoting, A square.
Vector solve_fully_pivoted(const Matrix &a, const Vector &b);
bool is_invertible(const Matrix &a);
/// A basis of the null space, by columns; a zero column where there is none.
Matrix null_space(const Matrix &a);

/// The x of least norm among those of least |A x - b|, for any A: complete orthogonal
/// decomposition.
Vector least_norm_solution(const Matrix &a, const Vector &b);
Matrix least_norm_solution(const Matrix &a, const Matrix &b);

/// Complete orthogonal decomposition, for several right sides one after the other.
class LeastNorm {
public:
  explicit LeastNorm(const Matrix &a);
  Matrix solve(const Matrix &b) const;

private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// A = Q R, and the diagonal of R.
struct Orthonormal {
  Matrix basis; ///< the first columns of Q, as many as A has, or all
  Vector diagonal;
};
enum class Basis { columns, whole };
Orthonormal orthonormalised(const Matrix &a, Basis which);

/// A P = Q R with column pivoting.
class PivotedQr {
public:
  /// `threshold`: pivots below this share of the largest count as zero; by default rounding.
  explicit PivotedQr(const Matrix &a, std::optional<double> threshold = {});

  Index rank() const;
  Vector solve(const Vector &b) const;
  /// The first `columns` columns of Q.
  Matrix basis(Index columns) const;

private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// A = U diag(values) V^T, values falling.
struct SingularValues {
  Matrix left; ///< U, empty where not asked for
  Vector values;
  Matrix right; ///< V
};
/// With all singular vectors, those of value zero included.
SingularValues singular_values(const Matrix &a);
/// V alone, as many columns as there are values.
SingularValues right_singular_values(const Matrix &a);
/// A^-1 b where the least singular value is above `least`; else none.
std::optional<Vector> solve_well_conditioned(const Matrix &a, const Vector &b, double least);

/// Of a symmetric matrix, values rising; only its lower triangle is read.
struct SymmetricEigen {
  Vector values;
  Matrix vectors; ///< orthonormal, by columns
};
SymmetricEigen symmetric_eigen(const Matrix &a);
/// Of a symmetric tridiagonal matrix, rising. NumericalError when they do not converge.
Vector tridiagonal_eigenvalues(const Vector &diagonal, const Vector &beside);

/// Of any real square matrix; none when they do not converge.
std::optional<ComplexVector> try_eigenvalues(const Matrix &a);
/// NaN when they do not converge, as those of a matrix that is not finite.
ComplexVector eigenvalues(const Matrix &a);

struct GeneralEigen {
  ComplexVector values;
  ComplexMatrix vectors;
};
GeneralEigen general_eigen(const Matrix &a);

/// L with L L^T = A; none when A is not positive definite.
std::optional<Matrix> cholesky(const Matrix &a);

/// exp(A)
Matrix exponential(const Matrix &a);

// The same in extended precision.
namespace extended {

LongMatrix inverse(const LongMatrix &a);
LongComplexMatrix inverse(const LongComplexMatrix &a);
long double determinant(const LongMatrix &a);
LongMatrix solve_fully_pivoted(const LongMatrix &a, const LongMatrix &b);
/// The first `columns` columns of Q in A P = Q R.
LongMatrix pivoted_basis(const LongMatrix &a, Index columns);
LongVector tridiagonal_eigenvalues(const LongVector &diagonal, const LongVector &beside);

struct GeneralEigen {
  LongComplexVector values;
  LongComplexMatrix vectors;
};
/// None when they do not converge.
std::optional<GeneralEigen> general_eigen(const LongMatrix &a);

/// A = U T U^*, T upper triangular.
struct ComplexSchurForm {
  LongComplexMatrix unitary, triangular;
};
ComplexSchurForm complex_schur(const LongComplexMatrix &a);

} // namespace extended

} // namespace vibroimpact
