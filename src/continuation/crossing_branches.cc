#include "continuation/crossing_branches.h"

#include "common/decompositions.h"

namespace vibroimpact::continuation {

namespace {

// On the way to the crossing the corrector becomes singular; the system
//
//     F(u) + c b = 0,  g(u) = 0 in R^2,  with  [w^T g^T] [[F_u, b], [C^T, 0]] = (0, 1)
//
// is regular there: F_u has rank n - 1 where g is zero, b unfolds the crossing, and c = 0 at the
// solution (Govaerts 2000, chapter 8). With F_u V + b h^T = 0 and C^T V = 1, g_u = -w^T F_uu V:
// since second derivatives are symmetric, two differences of F_u along V give all of it.
class CrossingSystem {
public:
  CrossingSystem(const ScaledProblem &problem, const Vector &guess, double chart)
      : problem_{problem}, chart_{chart}, n_{problem.states()} {
    const SingularValues of = singular_values(problem.evaluate(guess, chart).slope);
    left_ = of.left.col(n_ - 1);
    right_ = of.right.rightCols(2);
  }

  // Unknowns (u, c).
  SquareSystem operator()(const Vector &unknowns) {
    const Vector u = unknowns.head(n_ + 1);
    at = problem_.evaluate(u, chart_);
    Matrix bordered(n_ + 2, n_ + 2);
    bordered << at.slope, left_, right_.transpose(), Matrix::Zero(2, 1);
    return system(u, unknowns(n_ + 1), bordered);
  }

  Linearisation at;

private:
  SquareSystem system(const Vector &u, double c, const Matrix &bordered) const {
    constexpr double h = 1e-5;
    const Index m = n_ + 2;
    const LuFactors<Matrix> lu(bordered);
    const Vector wg = lu.solve_transposed(Vector::Unit(m, m - 1));
    const Matrix v = lu.solve(Matrix(Matrix::Identity(m, m).middleCols(n_, 2))).topRows(n_ + 1);
    SquareSystem result{Vector(m), Matrix::Zero(m, m)};
    result.residual << at.residual + c * left_, wg.tail(2);
    result.slope.topLeftCorner(n_, n_ + 1) = at.slope;
    result.slope.topRightCorner(n_, 1) = left_;
    for (Index j = 0; j < 2; ++j) {
      const Matrix change = problem_.evaluate(u + h * v.col(j), chart_).slope -
                            problem_.evaluate(u - h * v.col(j), chart_).slope;
      result.slope.block(n_ + j, 0, 1, n_ + 1) = -wg.head(n_).transpose() * change / (2 * h);
    }
    return result;
  }

  const ScaledProblem &problem_;
  double chart_;
  Index n_;
  Vector left_;
  Matrix right_;
};

} // namespace

std::optional<Corrected> crossing_between(const ScaledProblem &problem, const Piece &piece,
                                          const Settings &settings) {
  const Vector &begin = piece.begin().u;
  const Vector chord = piece.end().u - begin;
  const double before = piece.begin().tests.branch, after = piece.end().tests.branch;
  Vector guess(begin.size() + 1);
  guess << begin + before / (before - after) * chord, 0;
  CrossingSystem system(problem, guess.head(begin.size()), piece.begin().chart);
  Converged converged;
  try {
    converged = newton([&](const Vector &u) { return system(u); }, guess, piece.length(), settings);
  } catch (const NumericalError &) {
    return std::nullopt;
  }
  constexpr double no_unfolding = 1e-9;
  const Vector u = converged.u.head(begin.size());
  const double way = chord.dot(u - begin) / chord.squaredNorm();
  if (std::abs(converged.u(begin.size())) > no_unfolding || way < 0 || way > 1)
    return std::nullopt;
  return Corrected{u, system.at, converged.iterations};
}

} // namespace vibroimpact::continuation
