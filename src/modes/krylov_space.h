// An M-orthonormal basis that grows by blocks: OP = (K - shift M)^-1 M, which is symmetric in the
// inner product of M, applied to the newest block and made orthogonal to all before it, twice. The
// projection of OP onto it is kept whole, so that blocks may lose columns, begin anew, or be
// condensed to the best Ritz vectors (thick restart, wu2000) without rules of their own.
#pragma once

#include "modes/factorisation.h"
#include "modes/sparse_product.h"

#include <cstdint>

namespace vibroimpact::modes {

/// Eigenpairs of the projection; nu = 1 / (lambda - shift).
struct RitzPairs {
  Vector values;       ///< nu, descending
  Matrix coefficients; ///< of the vectors in the basis
  Vector residuals;    ///< |OP x - nu x| / nu in the norm of M: bounds the relative error of nu
};

class KrylovSpace {
public:
  /// Columns that a block has at most.
  static constexpr Index block_size = 6;

  /// `start`: M-orthonormal vectors to begin with, none as a rule. Room for `capacity` columns.
  /// Collective.
  KrylovSpace(const Factorisation &shifted, Mat mass, Index capacity, const Block &start);

  /// Adds OP times the newest block. Collective.
  void advance();
  /// Columns that OP has been applied to.
  Index size() const { return done_; }
  /// Whether there is room for another block.
  Index capacity() const { return basis_.cols(); }
  bool full() const { return used_ + block_size > basis_.cols(); }
  /// OP maps the space onto itself, and nothing outside it was found.
  bool exhausted() const { return used_ == done_; }
  RitzPairs ritz_pairs() const;
  /// Basis times coefficients.
  Block vectors(const Matrix &coefficients) const;
  /// Leaves the first `kept` Ritz vectors and the newest block, and room for `capacity` columns.
  void condense(const RitzPairs &pairs, Index kept, Index capacity);

private:
  void append(Block block, const Vector &sizes);
  void append_fresh();
  Vector column_sizes(const Block &block, const Block &weighted) const;
  void remove_basis(const Matrix &products, Block &block) const;
  Block random_block();

  const Factorisation &shifted_;
  Layout layout_;
  SparseProduct mass_;
  Block basis_;
  Matrix projection_; ///< upper triangle of basis^T M OP basis
  Block weighted_;    ///< M times the newest block
  Matrix coupling_;   ///< OP's part of the block before it in the newest one
  Index used_ = 0;    ///< columns of the basis
  Index done_ = 0;
  std::uint64_t columns_drawn_ = 0;
};

} // namespace vibroimpact::modes
