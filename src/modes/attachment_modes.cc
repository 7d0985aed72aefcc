#include "modes/attachment_modes.h"

#include "common/decompositions.h"

#include <cmath>

namespace vibroimpact::modes {

namespace {

// A free body is solved with K + mu M, mu this fraction of its lowest eigenvalue above 0. The
// answer is then wrong by as much, and only in its elastic modes: the space that it spans together
// with the kept ones hardly notices.
constexpr double shift_fraction = 1e-8;
// An answer of which the kept modes leave no more than this (in the norm of M) is contained in
// them; shapes whose correlation matrix has an eigenvalue below its square depend on each other.
constexpr double least_independent = 1e-7;

Index count_rigid(const Vector &eigenvalues) { return (eigenvalues.array() == 0).count(); }

double shift_for(const Vector &eigenvalues) {
  const Index rigid = count_rigid(eigenvalues);
  if (rigid == 0)
    return 0;
  if (rigid == eigenvalues.size())
    throw NumericalError("Attachment modes of a free body need at least one elastic mode");
  return -shift_fraction * eigenvalues[rigid];
}

class Residuals {
public:
  Residuals(const EigenProblem &problem, const NormalModes &modes)
      : problem_(problem), layout_(problem.stiffness),
        rigid_(own_rows(layout_, modes.shapes.leftCols(count_rigid(modes.eigenvalues)))),
        kept_(own_rows(layout_, modes.shapes.middleCols(modes.first, modes.number))),
        factorised_(problem.factorised_at(shift_for(modes.eigenvalues))) {}

  AttachmentModes from(const Matrix &loads) const {
    Block force = own_rows(layout_, loads);
    force -= multiply(problem_.mass, rigid_) * inner_products(layout_, rigid_, force);
    const Block answers = normalised(factorised_.solve(force));
    const Block left = independent(without(kept_, without(rigid_, answers)));
    if (left.cols() == 0)
      return {Vector(), Matrix(layout_.size, 0)};
    const Matrix stiffness =
        inner_products(layout_, left, multiply(problem_.accurate_stiffness, left));
    const SymmetricEigen modes = symmetric_eigen((stiffness + stiffness.transpose()) / 2);
    return {modes.values, gather(layout_, left * modes.vectors)};
  }

private:
  Matrix mass_products(const Block &x) const {
    const Matrix products = inner_products(layout_, x, multiply(problem_.mass, x));
    return (products + products.transpose()) / 2;
  }

  Block normalised(const Block &x) const {
    const Vector size = mass_products(x).diagonal().cwiseSqrt();
    return x * size.unaryExpr([](double s) { return s > 0 ? 1 / s : 0; }).asDiagonal();
  }

  /// Twice, as once leaves the round-off of the large part.
  Block without(const Block &modes, Block x) const {
    const Block weighted = multiply(problem_.mass, modes);
    for (int round = 0; round < 2; ++round)
      x -= modes * inner_products(layout_, weighted, x);
    return x;
  }

  /// An M-orthonormal basis of what is significant of columns that had the norm 1.
  Block independent(const Block &x) const {
    const Vector size = mass_products(x).diagonal().cwiseMax(0.0).cwiseSqrt();
    std::vector<Index> significant;
    for (Index j = 0; j < size.size(); ++j)
      if (size[j] > least_independent)
        significant.push_back(j);
    if (significant.empty())
      return Block(x.rows(), 0);
    const Block some = normalised(x(Eigen::all, significant));
    const auto [values, vectors] = symmetric_eigen(mass_products(some));
    const Index dependent = (values.array() <= least_independent * least_independent).count();
    const Index rank = values.size() - dependent;
    return without(kept_, some * vectors.rightCols(rank) *
                              values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal());
  }

  EigenProblem problem_;
  Layout layout_;
  Block rigid_;
  Block kept_;
  const Factorisation &factorised_;
};

} // namespace

AttachmentModes residual_attachment_modes(const EigenProblem &problem, const NormalModes &modes,
                                          const Matrix &loads) {
  return Residuals(problem, modes).from(loads);
}

} // namespace vibroimpact::modes
