#include "analyses/design/least_squares.h"

#include "common/error.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vibroimpact::analyses {

namespace {

/// Far below what the noise of any data makes of the sum of squares.
constexpr double least_fit_decrease = 1e-9; // relative
/// Of the largest squared column of the Jacobian.
constexpr double first_fit_damping = 1e-3;

/// The p between `lower` <= 0 and `upper` >= 0 of least |R p + c|^2 + w |p|^2. That is strictly
/// convex, so that it is found by an active set: the free coordinates go to the minimum over them
/// or to the first bound on the way, which holds from then on; at such a minimum the bound with the
/// largest multiplier of the wrong sign is released.
class BoxedStep {
public:
  BoxedStep(const Matrix &r, const Vector &c, Vector lower, Vector upper)
      : r_(r), c_(c), lower_(std::move(lower)), upper_(std::move(upper)) {}

  Vector at(double damping) {
    damping_ = damping;
    p_ = Vector::Zero(r_.cols());
    free_.resize(static_cast<std::size_t>(r_.cols()));
    for (Index k = 0; k < r_.cols(); ++k)
      free_[static_cast<std::size_t>(k)] = k;
    for (Index round = 0; round < 10 * (r_.cols() + 1); ++round)
      if (go_to_minimum() && !release_bound())
        break;
    return p_;
  }

private:
  /// Over the free coordinates, as if they had no bounds.
  Vector free_minimum() const {
    const auto n = static_cast<Index>(free_.size());
    Matrix stacked(r_.rows() + n, n);
    Vector held = p_;
    held(free_).setZero();
    stacked << r_(Eigen::all, free_), Matrix::Identity(n, n) * std::sqrt(damping_);
    Vector right = Vector::Zero(r_.rows() + n);
    right.head(r_.rows()) = -(c_ + r_ * held);
    return stacked.colPivHouseholderQr().solve(right);
  }

  /// False where a bound was met on the way.
  bool go_to_minimum() {
    if (free_.empty())
      return true;
    const Vector way = free_minimum() - p_(free_);
    double share = 1;
    auto met = free_.end();
    for (auto k = free_.begin(); k != free_.end(); ++k) {
      const double here = way[k - free_.begin()];
      const double room = (here > 0 ? upper_ : lower_)[*k] - p_[*k];
      if (std::abs(here) * share > std::abs(room)) {
        share = room / here;
        met = k;
      }
    }
    p_(free_) += share * way;
    if (met == free_.end())
      return true;
    p_[*met] = way[met - free_.begin()] > 0 ? upper_[*met] : lower_[*met];
    free_.erase(met);
    return false;
  }

  bool release_bound() {
    const Vector slope = r_.transpose() * (r_ * p_ + c_) + damping_ * p_;
    const double rounding = 1e-14 * (r_.cwiseAbs().transpose() * c_.cwiseAbs()).maxCoeff();
    Index released = -1;
    double most = rounding;
    for (Index k = 0; k < p_.size(); ++k)
      if (const double inwards = p_[k] >= upper_[k] ? slope[k] : -slope[k];
          inwards > most && std::find(free_.begin(), free_.end(), k) == free_.end()) {
        most = inwards;
        released = k;
      }
    if (released >= 0)
      free_.push_back(released);
    return released >= 0;
  }

  const Matrix &r_;
  const Vector &c_;
  const Vector lower_, upper_;
  double damping_ = 0;
  Vector p_;
  std::vector<Index> free_;
};

/// Residuals and derivatives at an iterate, the latter as R of J = Q R, with c = Q^T r.
struct FitIterate {
  Vector x;
  double sum = 0; ///< of squares
  Matrix r;
  Vector c;
};

FitIterate fit_iterate_at(const LeastSquaresProblem &problem, const Vector &x,
                          const Vector &residuals) {
  const Matrix jacobian = problem.jacobian(x);
  const Index n = std::min(jacobian.rows(), jacobian.cols());
  const Eigen::HouseholderQR<Matrix> factors(jacobian);
  const Vector turned = factors.householderQ().transpose() * residuals;
  return {.x = x,
          .sum = residuals.squaredNorm(),
          .r = factors.matrixQR().topRows(n).triangularView<Eigen::Upper>(),
          .c = turned.head(n)};
}

std::optional<Vector> fit_residuals_at(const LeastSquaresProblem &problem, const Vector &x) {
  try {
    return problem.residuals(x);
  } catch (const NumericalError &) {
    return std::nullopt;
  }
}

/// The damping by the ratio of the decrease to that of the linear model (H. B. Nielsen).
class MarquardtDamping {
public:
  explicit MarquardtDamping(const FitIterate &first)
      : value_(first_fit_damping * first.r.colwise().squaredNorm().maxCoeff()) {}

  double value() const { return value_; }
  void held(double ratio) {
    value_ *= std::max(1.0 / 3, 1 - std::pow(2 * ratio - 1, 3));
    factor_ = 2;
  }
  void failed() {
    value_ = std::max(value_, std::numeric_limits<double>::min()) * factor_;
    factor_ *= 2;
  }

private:
  double value_;
  double factor_ = 2;
};

} // namespace

SearchEnd least_squares(const LeastSquaresProblem &problem) {
  FitIterate here = fit_iterate_at(problem, problem.start, problem.residuals(problem.start));
  MarquardtDamping damping(here);
  bool evaluation_failed = false; // since the last step
  for (int number = 0; number < problem.most_steps; ++number) {
    const Vector step = BoxedStep(here.r, here.c, problem.lower - here.x, problem.upper - here.x)
                            .at(damping.value());
    const double length = step.cwiseAbs().maxCoeff();
    if (length == 0)
      return SearchEnd::objective_tolerance;
    const Vector there = (here.x + step).cwiseMax(problem.lower).cwiseMin(problem.upper);
    const std::optional<Vector> residuals = fit_residuals_at(problem, there);
    const double decrease = residuals ? here.sum - residuals->squaredNorm() : -here.sum;
    evaluation_failed = evaluation_failed || !residuals;
    if (!(decrease > 0)) {
      if (length < problem.tolerance)
        return evaluation_failed ? SearchEnd::other : SearchEnd::rounding;
      damping.failed();
      continue;
    }
    const double model = here.c.squaredNorm() - (here.r * step + here.c).squaredNorm();
    if (length < problem.tolerance)
      return evaluation_failed ? SearchEnd::other : SearchEnd::tolerance;
    if (decrease < least_fit_decrease * residuals->squaredNorm())
      return SearchEnd::objective_tolerance;
    damping.held(decrease / model);
    here = fit_iterate_at(problem, there, *residuals);
    evaluation_failed = false;
  }
  return SearchEnd::evaluations;
}

} // namespace vibroimpact::analyses
