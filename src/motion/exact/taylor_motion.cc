#include "motion/exact/linear_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using model::ExponentialForm;

namespace {

// Terms beyond are below rounding for steps of 1 / spectral radius, third derivatives included.
constexpr Index terms = 22;

// The watched forms as Taylor polynomials.
class TaylorCurves : public GuardCurves {
public:
  void watch(const GuardForms &forms) { forms_ = forms; }
  void start(const Matrix &series, double end);

  Index size() const override { return forms_.constants.size(); }
  Jet at(Index guard, double time) const override;
  double sixth_derivative(Index guard, double from, double to) const override;
  double rounding(Index guard) const override { return rounding_[guard]; }

private:
  double derivative(Index guard, Index order, double time) const;

  GuardForms forms_;
  Matrix derivatives_; // terms x guards: at the start of the step
  Vector rounding_;
};

void TaylorCurves::start(const Matrix &series, double end) {
  derivatives_.noalias() = series.transpose() * forms_.rows.transpose();
  derivatives_.row(0) += forms_.constants.transpose();
  rounding_ = forms_.constants.cwiseAbs();
  rounding_ += forms_.rows.cwiseAbs() * (series.col(0).cwiseAbs() + end * series.col(1).cwiseAbs());
  rounding_ *= 32 * std::numeric_limits<double>::epsilon();
}

double TaylorCurves::derivative(Index guard, Index order, double time) const {
  double value = derivatives_(terms - 1, guard);
  for (Index j = terms - 1; j-- > order;)
    value = derivatives_(j, guard) + time / static_cast<double>(j - order + 1) * value;
  return value;
}

Jet TaylorCurves::at(Index guard, double time) const {
  return {.value = derivative(guard, 0, time),
          .rate = derivative(guard, 1, time),
          .acceleration = derivative(guard, 2, time)};
}

double TaylorCurves::sixth_derivative(Index guard, double /*from*/, double to) const {
  double bound = std::abs(derivatives_(terms - 1, guard));
  for (Index j = terms - 1; j-- > 6;)
    bound = std::abs(derivatives_(j, guard)) + to / static_cast<double>(j - 5) * bound;
  return bound;
}

// column j of the series: j-th derivative at the start of the step
class TaylorMotion : public LinearMotion {
public:
  TaylorMotion(const LinearSystem &system, Index n_coordinates, const DenseTolerance &tolerance)
      : system_(system), n_(n_coordinates), tolerance_(tolerance) {}

  bool begin(const Vector &y, std::span<const ExponentialForm> sources) override;
  double natural_step() override;
  void derivatives(double tau, Matrix &rows) override;
  void initial_derivatives(Matrix &rows) override {
    rows = series_.leftCols(dense_derivatives + 1);
  }
  void values(std::span<const double> instants, Matrix &rows) override;
  // No product is faster than twice the radius, and the step no longer than its inverse.
  double quadrature_length(double /*start*/, double rest) const override { return rest; }
  void move(double tau) override;
  void watch(const GuardForms &forms) override { curves_.watch(forms); }
  const GuardCurves &guards(double end) override {
    curves_.start(series_, end);
    return curves_;
  }

private:
  void differentiate_sources();
  void expand(const Vector &y);
  double largest(Index row, Index order, Index count) const;
  void sum(double tau, Index order, Eigen::Ref<Vector> rows) const;

  const LinearSystem &system_;
  Index n_;
  const DenseTolerance &tolerance_;
  std::vector<ExponentialForm> sources_;
  double radius_ = 0; // no motion is faster [1/s]
  Vector error_allowed_;
  TaylorCurves curves_;
  Matrix series_; // (y, then s, s', s'' of each source) x terms
};

bool TaylorMotion::begin(const Vector &y, std::span<const ExponentialForm> sources) {
  sources_.assign(sources.begin(), sources.end());
  radius_ = system_.spectral_radius();
  for (const ExponentialForm &source : sources_)
    for (const ExponentialForm::Term &term : source.terms)
      radius_ = std::max(radius_, std::abs(term.exponent));
  expand(y);
  error_allowed_ = tolerance_.absolute;
  for (Index i = 0; i < y.size(); ++i)
    error_allowed_[i] += tolerance_.relative * largest(i, 0, 2);
  return true;
}

void TaylorMotion::differentiate_sources() {
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Index row = system_.size() + 3 * static_cast<Index>(k);
    series_.middleRows(row, 3).setZero();
    const ExponentialForm &form = sources_[k];
    Vector derivative = Vector::Zero(terms + 2);
    for (const ExponentialForm::Term &term : form.terms) {
      Complex value = term.amplitude;
      for (Index j = 0; j < derivative.size(); ++j, value *= term.exponent)
        derivative[j] += value.real();
    }
    double factorial = 1;
    for (std::size_t j = 0; j < form.polynomial.size() && j < terms; ++j) {
      factorial *= j > 0 ? static_cast<double>(j) : 1;
      derivative[static_cast<Index>(j)] += factorial * form.polynomial[j];
    }
    for (Index order = 0; order < 3; ++order)
      series_.row(row + order) = derivative.segment(order, terms).transpose();
  }
}

void TaylorMotion::expand(const Vector &y) {
  series_.resize(system_.size() + 3 * static_cast<Index>(sources_.size()), terms);
  differentiate_sources();
  series_.col(0).head(y.size()) = y;
  system_.differentiate(series_);
}

// Bound of a derivative over a step from `count` derivatives at its start.
double TaylorMotion::largest(Index row, Index order, Index count) const {
  double bound = 0;
  double scale = 1;
  for (Index j = order; j < order + count && std::isfinite(scale); ++j) {
    bound = std::max(bound, scale * std::abs(series_(row, j)));
    scale = radius_ > 0 ? scale / radius_ : 0;
  }
  return bound;
}

double TaylorMotion::natural_step() {
  double tenth = 0;
  double eighth = 0;
  const auto ratio = [&](Index row, Index order) {
    const double derivative = largest(row, order, 4);
    return derivative > 0 ? derivative / error_allowed_[row] : 0;
  };
  for (Index i = 0; i < n_; ++i)
    tenth = std::max(tenth, ratio(i, 10));
  for (Index i = 2 * n_; i < system_.size(); ++i)
    eighth = std::max(eighth, ratio(i, 8));
  const double step = dense_step(tenth, eighth);
  return radius_ > 0 ? std::min(step, 1 / radius_) : step;
}

void TaylorMotion::sum(double tau, Index order, Eigen::Ref<Vector> rows) const {
  rows = series_.col(terms - 1);
  for (Index j = terms - 1; j-- > order;)
    rows = series_.col(j) + tau / static_cast<double>(j - order + 1) * rows;
}

void TaylorMotion::derivatives(double tau, Matrix &rows) {
  rows.resize(series_.rows(), dense_derivatives + 1);
  for (Index m = 0; m <= dense_derivatives; ++m)
    sum(tau, m, rows.col(m));
}

void TaylorMotion::values(std::span<const double> instants, Matrix &rows) {
  rows.resize(series_.rows(), static_cast<Index>(instants.size()));
  for (std::size_t i = 0; i < instants.size(); ++i)
    sum(instants[i], 0, rows.col(static_cast<Index>(i)));
}

void TaylorMotion::move(double tau) {
  Vector rows(series_.rows());
  sum(tau, 0, rows);
  for (ExponentialForm &source : sources_)
    source = source.about(source.origin + tau);
  expand(rows.head(system_.size()));
}

} // namespace

std::unique_ptr<LinearMotion> make_taylor_motion(const LinearSystem &system, Index n_coordinates,
                                                 const DenseTolerance &tolerance) {
  return std::make_unique<TaylorMotion>(system, n_coordinates, tolerance);
}

} // namespace vibroimpact::motion
