// A linear system in coordinates in which its matrix is block-diagonal.
//
//   y' = A y,   y = W x,   x' = W^-1 A W x
//
// A pair of conjugate eigenvalues is a block of two columns, (2 Re w, -2 Im w) of its eigenvector,
// whose coordinates are real and imaginary part of one complex amplitude; a real eigenvalue is one
// column. Eigenvalues whose eigenvectors are nearly dependent, as those of free bodies or of
// critical damping, stay together: their invariant subspace is a dense block of real coordinates,
// in which nothing is lost. All is done in extended precision on the balanced matrix (Osborne
// 1960), since what rounding makes of the eigenvectors shows in the instants of contact changes.
#pragma once

#include "common/linear_algebra.h"
#include "common/memory.h"

#include <complex>
#include <vector>

namespace vibroimpact::motion {

using Complex = std::complex<double>;

enum class BlockKind {
  pair,  ///< of conjugate eigenvalues: two columns
  real,  ///< one column
  dense, ///< of eigenvalues that stay together
};

/// One block of columns.
struct ModalBlock {
  BlockKind kind = BlockKind::real;
  Index column = 0; ///< the first of its columns
  Index size = 1;
  Complex exponent{}; ///< imaginary part > 0 of a pair, 0 of a real one [1/s]
  Matrix generator{}; ///< of a dense block, size x size [1/s]

  /// x' = B x of its coordinates, size x size.
  Matrix matrix() const;
};

/// x' = B x of the two coordinates of a pair.
Matrix pair_generator(Complex exponent);

class ModalForm {
public:
  using Long = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

  /// matrix: n x n, finite [1/s]
  explicit ModalForm(const Matrix &matrix);

  const std::vector<ModalBlock> &blocks() const { return blocks_; }
  const Matrix &basis() const { return basis_; }     ///< W, n x n
  const Matrix &inverse() const { return inverse_; } ///< W^-1
  /// W^-1 in extended precision, for amplitudes that are small differences of large terms.
  const Long &long_inverse() const { return long_inverse_; }
  std::size_t bytes() const { return bytes_of(basis_, inverse_, long_inverse_); }

private:
  bool diagonalise(const Long &balanced, const Vector &scale);
  void separate(const Long &balanced, const Vector &scale);
  void finish(const Long &matrix, const Long &basis, const Vector &scale);

  std::vector<ModalBlock> blocks_;
  Matrix basis_, inverse_;
  Long long_inverse_;
};

} // namespace vibroimpact::motion
