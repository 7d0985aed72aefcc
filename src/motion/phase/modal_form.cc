#include "motion/phase/modal_form.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vibroimpact::motion {

namespace {

using Real = long double;
using LongComplexScalar = std::complex<Real>;
using Long = LongMatrix;
using LongComplex = LongComplexMatrix;

// The norm of the inverse of normalised eigenvectors beyond which more than four digits of the
// amplitudes cancel when they are summed up again.
constexpr Real largest_inverse = 1e4L;
// Of eigenvectors and of bases: what A W - W B may be, relative to A.
constexpr Real largest_residual = 1e-15L;

// Eigenvalues are one cluster whose eigenvectors have |w_i . w_j| above a bound; when that does not
// do, above less and less. Of several free motions rounding makes eigenvalues and eigenvectors that
// mean nothing, and only all of them together are an invariant subspace.
struct Clustering {
  Real parallel;
  bool near_values; ///< only of eigenvalues that are nearly equal
};
constexpr Clustering clusterings[] = {
    {0.9999L, true}, {0.99L, true}, {0.0L, true}, {0.9L, false}, {0.0L, false}};

// Powers of two d with D^-1 A D of rows and columns of similar size. What is rounding beside the
// rest of its row and of its column does not count: scaled up, it would hide all else [james2014].
Vector balance(Matrix matrix) {
  constexpr double rounding = 1e-15;
  const Index n = matrix.rows();
  const Vector rows = matrix.cwiseAbs().rowwise().maxCoeff();
  const Vector columns = matrix.cwiseAbs().colwise().maxCoeff();
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      if (std::abs(matrix(i, j)) <= rounding * std::min(rows[i], columns[j]))
        matrix(i, j) = 0;
  Vector scale = Vector::Ones(n);
  for (int sweep = 0; sweep < 20; ++sweep)
    for (Index i = 0; i < n; ++i) {
      double row = 0;
      double column = 0;
      for (Index j = 0; j < n; ++j)
        if (j != i) {
          row += std::abs(matrix(i, j)) * scale[j] / scale[i];
          column += std::abs(matrix(j, i)) * scale[i] / scale[j];
        }
      if (row > 0 && column > 0)
        scale[i] *= std::exp2(std::round(0.5 * std::log2(row / column)));
    }
  return scale;
}

// Exchanges the eigenvalues k and k + 1 of a Schur form T = U^H A U by a rotation that takes the
// eigenvector of the second to the first place (Golub and Van Loan 2013, section 7.6.2).
void exchange(LongComplex &t, LongComplex &u, Index k) {
  Eigen::JacobiRotation<LongComplexScalar> rotation;
  const LongComplexScalar difference = t(k + 1, k + 1) - t(k, k);
  if (t(k, k + 1) == 0.0L && difference == 0.0L)
    rotation = {0.0L,
                1.0L}; // equal and independent: any rotation would do, but is to exchange them
  else
    rotation.makeGivens(t(k, k + 1), difference);
  t.applyOnTheLeft(k, k + 1, rotation.adjoint());
  t.applyOnTheRight(k, k + 1, rotation);
  u.applyOnTheRight(k, k + 1, rotation);
  t(k + 1, k) = 0;
}

// Orthonormal basis of the invariant subspace of some eigenvalues of a Schur form.
LongComplex invariant_subspace(LongComplex t, LongComplex u, std::vector<Index> places) {
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (Index k = places[i]; k > static_cast<Index>(i); --k)
      exchange(t, u, k - 1);
  return u.leftCols(static_cast<Index>(places.size()));
}

// Of vectors whose span contains its own conjugate.
Long real_basis(const LongComplex &vectors, Index size) {
  Long parts(vectors.rows(), 2 * vectors.cols());
  parts << vectors.real(), vectors.imag();
  return extended::pivoted_basis(parts, size);
}

// |A V - V V^T A V| against |A|, for orthonormal V.
bool is_invariant(const Long &matrix, const Long &basis) {
  const Long image = matrix * basis;
  return (image - basis * (basis.transpose() * image)).norm() <= largest_residual * matrix.norm();
}

// Eigenvalues that belong together, each list with the conjugates of its members; the lists of all
// eigenvalues.
std::vector<std::vector<Index>> clusters(const LongComplex &vectors, const LongComplex &values,
                                         const Clustering &by) {
  const Index n = vectors.cols();
  std::vector<Index> root(static_cast<std::size_t>(n));
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index i) {
    while (root[static_cast<std::size_t>(i)] != i)
      i = root[static_cast<std::size_t>(i)];
    return i;
  };
  const auto unite = [&](Index i, Index j) { root[static_cast<std::size_t>(find(i))] = find(j); };
  const Real radius = values.cwiseAbs().maxCoeff();
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < i; ++j) {
      const Real distance = std::abs(values(i) - values(j));
      const bool same = distance <= 1e-7L * radius ||
                        distance <= 1e-3L * std::max(std::abs(values(i)), std::abs(values(j)));
      const bool along = std::abs(vectors.col(i).dot(vectors.col(j))) >= by.parallel;
      const Real size = std::abs(values(i)) + std::abs(values(j));
      const bool conjugate = std::abs(values(i).imag()) > 1e-12L * size &&
                             std::abs(values(i) - std::conj(values(j))) <= 1e-12L * size;
      if ((along && (same || !by.near_values)) || conjugate)
        unite(i, j);
    }
  std::vector<std::vector<Index>> lists(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i)
    lists[static_cast<std::size_t>(find(i))].push_back(i);
  std::erase_if(lists, [](const std::vector<Index> &list) { return list.empty(); });
  return lists;
}

} // namespace

Matrix pair_generator(Complex exponent) {
  Matrix generator(2, 2);
  generator << exponent.real(), -exponent.imag(), exponent.imag(), exponent.real();
  return generator;
}

Matrix ModalBlock::matrix() const {
  if (kind == BlockKind::dense)
    return generator;
  return kind == BlockKind::pair ? pair_generator(exponent)
                                 : Matrix::Constant(1, 1, exponent.real());
}

ModalForm::ModalForm(const Matrix &matrix) : basis_(matrix), inverse_(matrix) {
  if (matrix.size() == 0)
    return;
  const Vector scale = balance(matrix);
  const Long balanced =
      (scale.cwiseInverse().asDiagonal() * matrix * scale.asDiagonal()).cast<Real>();
  if (!diagonalise(balanced, scale))
    separate(balanced, scale);
}

// False: the eigenvectors are too nearly dependent, or are none (of a defective pair the solver may
// return two vectors that are not eigenvectors).
bool ModalForm::diagonalise(const Long &balanced, const Vector &scale) {
  const auto eigen = extended::general_eigen(balanced);
  if (!eigen)
    return false;
  const auto &values = eigen->values;
  const LongComplex vectors = eigen->vectors.colwise().normalized();
  const LongComplex inverse = extended::inverse(vectors);
  const LongComplex rest =
      balanced.cast<LongComplexScalar>() * vectors - vectors * values.asDiagonal();
  if (!(inverse.rowwise().norm().maxCoeff() <= largest_inverse) ||
      !(rest.norm() <= largest_residual * balanced.norm()))
    return false;
  const Index n = balanced.rows();
  Long basis(n, n);
  // Conjugate eigenvalues stand side by side, the one with positive imaginary part first.
  for (Index k = 0; k < n; ++k) {
    const bool is_pair = values[k].imag() != 0;
    ModalBlock block{.kind = is_pair ? BlockKind::pair : BlockKind::real,
                     .column = k,
                     .size = is_pair ? 2 : 1,
                     .exponent = Complex(static_cast<double>(values[k].real()),
                                         static_cast<double>(values[k].imag())),
                     .generator = {}};
    basis.col(k) = (is_pair ? 2 : 1) * vectors.col(k).real();
    if (is_pair)
      basis.col(k + 1) = -2 * vectors.col(k).imag();
    k += is_pair ? 1 : 0;
    blocks_.push_back(std::move(block));
  }
  finish(balanced, basis, scale);
  return true;
}

// Clusters as small as they can be; at last the whole is one block.
void ModalForm::separate(const Long &balanced, const Vector &scale) {
  const Index n = balanced.rows();
  const auto [unitary, triangular] = extended::complex_schur(balanced.cast<LongComplexScalar>());
  const LongComplex values = triangular.diagonal();
  LongComplex vectors(n, n);
  for (Index i = 0; i < n; ++i)
    vectors.col(i) = invariant_subspace(triangular, unitary, {i});
  for (const Clustering &by : clusterings) {
    blocks_.clear();
    Long basis(n, n);
    Index column = 0;
    bool invariant = true;
    for (const std::vector<Index> &list : clusters(vectors, values, by)) {
      const auto size = static_cast<Index>(list.size());
      const Long own = real_basis(invariant_subspace(triangular, unitary, list), size);
      invariant = invariant && is_invariant(balanced, own);
      basis.middleCols(column, size) = own;
      blocks_.push_back(
          {.kind = BlockKind::dense, .column = column, .size = size, .generator = {}});
      column += size;
    }
    const bool one = blocks_.size() == 1;
    if (one ||
        (invariant && extended::inverse(basis).rowwise().norm().maxCoeff() <= largest_inverse)) {
      finish(balanced, basis, scale);
      return;
    }
  }
}

// A dense block of one column is a real one; one of two with complex eigenvalues a pair.
void ModalForm::finish(const Long &matrix, const Long &basis, const Vector &scale) {
  Long columns = basis;
  for (ModalBlock &block : blocks_) {
    if (block.kind != BlockKind::dense)
      continue;
    const Long own = extended::inverse(columns).middleRows(block.column, block.size) * matrix *
                     columns.middleCols(block.column, block.size);
    const Real half_trace = own.trace() / 2;
    const Real square = block.size == 2 ? extended::determinant(own) - half_trace * half_trace : 0;
    if (block.size == 1) {
      block.kind = BlockKind::real;
      block.exponent = static_cast<double>(own(0, 0));
    } else if (square > 1e-6L * own.squaredNorm()) {
      // B = half_trace + J sqrt(square) with J^2 = -1: the columns b and J b.
      const Real frequency = std::sqrt(square);
      block.kind = BlockKind::pair;
      block.exponent = {static_cast<double>(half_trace), static_cast<double>(frequency)};
      const Long turned = columns.middleCols(block.column, 2) *
                          ((own - half_trace * Long::Identity(2, 2)) / frequency).col(0);
      columns.col(block.column + 1) = turned;
    } else {
      block.generator = own.cast<double>();
    }
  }
  // Of one size, so that what drives the blocks can be compared; by powers of two, which do not
  // round.
  for (const ModalBlock &block : blocks_) {
    auto own = columns.middleCols(block.column, block.size);
    own /= std::exp2(
        std::round(std::log2((scale.cast<Real>().asDiagonal() * own).cwiseAbs().maxCoeff())));
  }
  basis_ = scale.asDiagonal() * columns.cast<double>();
  long_inverse_ = extended::inverse(columns) * scale.cast<Real>().cwiseInverse().asDiagonal();
  inverse_ = long_inverse_.cast<double>();
}

} // namespace vibroimpact::motion
