#include "contact/impulses.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vibroimpact::contact {

namespace {

constexpr double rounding = 1e-13;

// The active-set method of Lawson and Hanson for the equivalent quadratic program.
class ActiveSet {
public:
  ActiveSet(const Matrix &matrix, const Vector &q)
      : matrix_(matrix), q_(q), x_(Vector::Zero(q.size())),
        negligible_(rounding * q.cwiseAbs().maxCoeff()) {}

  Vector solve() {
    // Each free set is visited once at most; so many are never needed.
    const Index limit = 30 * (q_.size() + 1);
    for (Index i = 0; i < limit; ++i) {
      const Index entering = most_violated();
      if (entering < 0)
        return x_;
      free_.push_back(entering);
      minimise();
    }
    throw NumericalError("the impulses of simultaneous contacts could not be found");
  }

private:
  // Of those held at zero; -1 when none is violated.
  Index most_violated() const {
    const Vector slack = matrix_ * x_ + q_;
    Index worst = -1;
    for (Index i = 0; i < q_.size(); ++i)
      if (std::find(free_.begin(), free_.end(), i) == free_.end() && slack[i] < -negligible_ &&
          (worst < 0 || slack[i] < slack[worst]))
        worst = i;
    return worst;
  }

  // To the minimum over the free entries, giving up those that would become negative.
  void minimise() {
    while (!free_.empty()) {
      bool bounded = false;
      const Vector direction = towards_minimum(bounded);
      double step = bounded ? 1 : std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < free_.size(); ++i)
        if (const double d = direction[static_cast<Index>(i)]; d < 0)
          step = std::min(step, -x_[free_[i]] / d);
      if (!std::isfinite(step))
        throw NumericalError("bodies are squeezed between rigid contacts that close on them");
      for (std::size_t i = 0; i < free_.size(); ++i)
        x_[free_[i]] += step * direction[static_cast<Index>(i)];
      if (bounded && step == 1)
        return;
      drop(direction);
    }
  }

  // Along a null direction of the free block where the program has no minimum in it.
  Vector towards_minimum(bool &bounded) const {
    const auto n = static_cast<Index>(free_.size());
    Matrix block(n, n);
    Vector right(n);
    Vector now(n);
    for (Index i = 0; i < n; ++i) {
      right[i] = -q_[free_[static_cast<std::size_t>(i)]];
      now[i] = x_[free_[static_cast<std::size_t>(i)]];
      for (Index j = 0; j < n; ++j)
        block(i, j) =
            matrix_(free_[static_cast<std::size_t>(i)], free_[static_cast<std::size_t>(j)]);
    }
    const Vector gradient = right - block * now;
    const Vector direction = least_norm_solution(block, gradient);
    const Vector left = gradient - block * direction;
    bounded = left.cwiseAbs().maxCoeff() <= 1e3 * negligible_;
    return bounded ? direction : left;
  }

  void drop(const Vector &direction) {
    std::vector<Index> kept;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const bool at_zero = direction[static_cast<Index>(i)] < 0 &&
                           x_[free_[i]] <= rounding * x_.cwiseAbs().maxCoeff();
      if (at_zero)
        x_[free_[i]] = 0;
      else
        kept.push_back(free_[i]);
    }
    free_ = std::move(kept);
  }

  const Matrix &matrix_;
  const Vector &q_;
  Vector x_;
  double negligible_;
  std::vector<Index> free_;
};

} // namespace

Vector solve_complementarity(const Matrix &matrix, const Vector &q) {
  return q.size() == 0 ? q : ActiveSet(matrix, q).solve();
}

} // namespace vibroimpact::contact
