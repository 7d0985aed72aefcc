#include "modes/krylov_space.h"

#include "common/decompositions.h"

#include <algorithm>
#include <random>

namespace vibroimpact::modes {

namespace {

// Of a vector's size before what is known was removed: less is round-off. The second time nothing
// is lost but by such a vector.
constexpr double least_remainder = 1e-10;
constexpr double least_second_remainder = 0.1;

/// The block becomes block * W, M-orthonormal, without the directions whose size is below `least`
/// of `sizes`; so does its product with M. Returns C with block (before) = block (after) * C.
Matrix orthonormalise(const Layout &layout, const Vector &sizes, double least, Block &block,
                      Block &weighted) {
  if (block.cols() == 0)
    return Matrix(0, 0);
  const Matrix gram = inner_products(layout, block, weighted);
  const Vector scale = sizes.unaryExpr([](double size) { return size > 0 ? 1 / size : 0; });
  const Matrix scaled = scale.asDiagonal() * ((gram + gram.transpose()) / 2) * scale.asDiagonal();
  const auto [squares, vectors] = symmetric_eigen(scaled);
  const Index kept = (squares.array() > least * least).count();
  const Matrix change = scale.asDiagonal() * vectors.rightCols(kept) *
                        squares.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  block = block * change;
  weighted = weighted * change;
  return change.transpose() * gram;
}

} // namespace

KrylovSpace::KrylovSpace(const Factorisation &shifted, Mat mass, Index capacity, const Block &start)
    : shifted_(shifted), layout_(mass), mass_(mass),
      basis_(layout_.own, std::max(capacity, start.cols() + 2 * block_size)),
      projection_(Matrix::Zero(basis_.cols(), basis_.cols())), used_(start.cols()) {
  if (start.cols() > 0) {
    basis_.leftCols(used_) = start;
    const Block moved = shifted_.solve(mass_(start));
    projection_.topLeftCorner(used_, used_) = inner_products(layout_, start, mass_(moved));
    done_ = used_;
  }
  append_fresh();
}

/// Each entry depends on its place in the whole vector alone: the same on any number of ranks.
Block KrylovSpace::random_block() {
  Block block(layout_.own, block_size);
  for (Index j = 0; j < block.cols(); ++j) {
    std::mt19937_64 engine(columns_drawn_++);
    engine.discard(static_cast<unsigned long long>(layout_.own_begin));
    for (double &entry : block.col(j))
      entry = static_cast<double>(engine() >> 11U) * 0x1p-52 - 1;
  }
  return block;
}

void KrylovSpace::remove_basis(const Matrix &products, Block &block) const {
  add_product(-1, basis_.leftCols(used_), products, block);
}

/// OP takes out of a random block what has no mass. The basis goes out before, too: its part in
/// OP's answer would cover the rest with round-off.
void KrylovSpace::append_fresh() {
  Block block = random_block();
  for (int pass = 0; pass < 2; ++pass)
    remove_basis(inner_products(layout_, basis_.leftCols(used_), mass_(block)), block);
  block = shifted_.solve(mass_(block));
  const Block weighted = mass_(block);
  const Vector sizes = column_sizes(block, weighted);
  remove_basis(inner_products(layout_, basis_.leftCols(used_), weighted), block);
  append(std::move(block), sizes);
  coupling_.setZero(1, 0);
}

/// In the norm of M.
Vector KrylovSpace::column_sizes(const Block &block, const Block &weighted) const {
  return column_products(layout_, block, weighted).cwiseMax(0.0).cwiseSqrt();
}

/// `block` is orthogonal to the basis but for round-off.
void KrylovSpace::append(Block block, const Vector &sizes) {
  Block weighted = mass_(block);
  const Matrix first = orthonormalise(layout_, sizes, least_remainder, block, weighted);
  remove_basis(inner_products(layout_, basis_.leftCols(used_), weighted), block);
  weighted = mass_(block);
  const Matrix second =
      orthonormalise(layout_, Vector::Ones(block.cols()), least_second_remainder, block, weighted);
  coupling_ = second * first;
  basis_.middleCols(used_, block.cols()) = block;
  used_ += block.cols();
  weighted_ = std::move(weighted);
}

void KrylovSpace::advance() {
  Block block = shifted_.solve(weighted_);
  const Block weighted = mass_(block);
  const Matrix products = inner_products(layout_, basis_.leftCols(used_), weighted);
  projection_.block(0, done_, used_, block.cols()) = products;
  const Vector sizes = column_sizes(block, weighted);
  remove_basis(products, block);
  done_ = used_;
  append(std::move(block), sizes);
  if (exhausted())
    append_fresh();
}

RitzPairs KrylovSpace::ritz_pairs() const {
  const Matrix symmetric = projection_.topLeftCorner(done_, done_).selfadjointView<Eigen::Upper>();
  const SymmetricEigen modes = symmetric_eigen(symmetric);
  RitzPairs pairs{.values = modes.values.reverse(),
                  .coefficients = modes.vectors.rowwise().reverse(),
                  .residuals = Vector::Zero(done_)};
  if (!exhausted())
    pairs.residuals = (coupling_ * pairs.coefficients.bottomRows(coupling_.cols()))
                          .colwise()
                          .norm()
                          .transpose()
                          .cwiseQuotient(pairs.values.cwiseAbs());
  return pairs;
}

Block KrylovSpace::vectors(const Matrix &coefficients) const {
  Block result = Block::Zero(layout_.own, coefficients.cols());
  add_product(1, basis_.leftCols(coefficients.rows()), coefficients, result);
  return result;
}

void KrylovSpace::condense(const RitzPairs &pairs, Index kept, Index capacity) {
  const Block newest = basis_.middleCols(done_, used_ - done_);
  Block basis(layout_.own, capacity);
  basis.leftCols(kept) = vectors(pairs.coefficients.leftCols(kept));
  basis.middleCols(kept, newest.cols()) = newest;
  basis_ = std::move(basis);
  projection_ = Matrix::Zero(capacity, capacity);
  projection_.diagonal().head(kept) = pairs.values.head(kept);
  done_ = kept;
  used_ = kept + newest.cols();
}

} // namespace vibroimpact::modes
