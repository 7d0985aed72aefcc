#include "continuation/locus_equation.h"

#include "common/decompositions.h"
#include "continuation/node.h"

namespace vibroimpact::continuation {

namespace {

// Of the two senses of a null vector always the same one, close by as well: along weights that no
// symmetry makes orthogonal to it.
Vector in_one_sense(const Vector &vector) {
  const Vector weights =
      (Vector::LinSpaced(vector.size(), 1, static_cast<double>(vector.size())).array() + M_SQRT2)
          .inverse();
  return vector.dot(weights) < 0 ? Vector(-vector) : vector;
}

} // namespace

Borders Borders::of(const Matrix &matrix) {
  const SingularValues of = singular_values(matrix);
  return {in_one_sense(of.left.rightCols(1)), in_one_sense(of.right.rightCols(1))};
}

Bordered Borders::solve(const Matrix &matrix) const {
  const Index n = matrix.rows();
  Matrix bordered(n + 1, n + 1);
  bordered << matrix, b, c.transpose(), 0;
  const LuFactors<Matrix> lu(bordered);
  const Vector last = Vector::Unit(n + 1, n), vg = lu.solve(last), wg = lu.solve_transposed(last);
  if (!vg.allFinite() || !wg.allFinite())
    throw NumericalError("the bordered matrix is singular");
  return {vg.head(n), wg.head(n), vg(n)};
}

namespace {

// d(F_u)/dh at u + h (v, 0), n x (n + keys), for v of any length. Third derivatives times h^2 and
// rounding over h are both near 1e-10 for h = 1e-5. Close to a graze a shorter difference stays on
// one side.
Matrix slope_change(const ScaledProblem &problem, const Vector &u, double chart, const Vector &v) {
  const double length = v.norm();
  if (length == 0)
    return Matrix::Zero(problem.states(), problem.unknowns());
  Vector direction = Vector::Zero(u.size());
  direction.head(v.size()) = v / length;
  for (const double h : {1e-5, 1e-6, 1e-7, 1e-8}) {
    const Linearisation ahead = problem.evaluate(u + h * direction, chart);
    const Linearisation behind = problem.evaluate(u - h * direction, chart);
    if (ahead.pattern == behind.pattern)
      return (ahead.slope - behind.slope) * (length / (2 * h));
  }
  throw NumericalError("a guard touches zero too close by for second derivatives");
}

int sign(double value) { return (value > 0) - (value < 0); }

// Of the change of g with the first key along the solutions x(p), dx = -F_x^-1 F_p dp.
int sign_along_first_key(const Augmented &at) {
  const Index n = at.slope.rows();
  const Vector change = solve_fully_pivoted(at.slope.leftCols(n), at.slope.col(n));
  return sign(at.gradient(n) - at.gradient.head(n).dot(change));
}

// Folds and flips: J - I or J + I is singular.
class SingularJacobian : public LocusEquation {
public:
  SingularJacobian(const ScaledProblem &problem, double multiplier, const Linearisation &at,
                   double chart)
      : problem_{problem}, multiplier_{multiplier}, chart_{chart} {
    borders_ = Borders::of(shifted(at));
  }

  Augmented evaluate(const Vector &u, double chart) const override {
    Augmented result;
    static_cast<Linearisation &>(result) = problem_.evaluate(u, chart);
    const Bordered bordered = borders_.solve(shifted(result));
    result.value = bordered.g;
    result.gradient = -bordered.w.transpose() * slope_change(problem_, u, chart, bordered.v);
    const Index n = problem_.states();
    if (multiplier_ == 1) {
      // w^T F_p dp + w^T F_xx (v, v) a^2 / 2 = 0
      result.cusp = result.gradient.head(n).dot(bordered.v);
      result.side = sign(bordered.w.dot(result.slope.col(n)) * result.cusp);
    } else {
      // (J + I) v + b g = 0 and w^T b = 1: g = -(mu + 1) w^T v
      result.side = sign(bordered.w.dot(bordered.v)) * sign_along_first_key(result);
    }
    return result;
  }

  // The null vectors of the last point keep the borders away from being orthogonal to those of the
  // next one; directions do not turn round, so that the sign for cusps stays.
  void renew(const Linearisation &at, double chart) override {
    const Matrix matrix = shifted(at);
    if (chart != chart_)
      borders_ = Borders::of(matrix);
    chart_ = chart;
    const Bordered bordered = borders_.solve(matrix);
    borders_ = {bordered.w.normalized(), bordered.v.normalized()};
  }

  std::unique_ptr<LocusEquation> clone() const override {
    return std::make_unique<SingularJacobian>(*this);
  }

private:
  Matrix shifted(const Linearisation &at) const {
    const Index n = problem_.states();
    return at.slope.leftCols(n) + (1 - multiplier_) * Matrix::Identity(n, n);
  }

  const ScaledProblem &problem_;
  double multiplier_;
  double chart_;
  Borders borders_;
};

// |mu| - 1 of the complex pair that is nearest to the last one, d(mu) = w^T dJ v / (w^T v).
class UnitModulus : public LocusEquation {
public:
  UnitModulus(const ScaledProblem &problem, const Linearisation &at) : problem_{problem} {
    double least = std::numeric_limits<double>::infinity();
    for (const auto mu : multipliers_of(map_jacobian(at)))
      if (mu.imag() > 0 && std::abs(std::abs(mu) - 1) < least) {
        least = std::abs(std::abs(mu) - 1);
        multiplier_ = mu;
      }
    if (!std::isfinite(least))
      throw NumericalError("there is no complex pair of multipliers at the start of the locus");
  }

  Augmented evaluate(const Vector &u, double chart) const override {
    Augmented result;
    static_cast<Linearisation &>(result) = problem_.evaluate(u, chart);
    const Mode mode = nearest(result);
    const auto dj_v =
        (slope_change(problem_, u, chart, mode.right.real()) +
         std::complex<double>(0, 1) * slope_change(problem_, u, chart, mode.right.imag()))
            .eval();
    const std::complex<double> product = (mode.left.transpose() * mode.right).value();
    const Eigen::RowVectorXcd rate = mode.left.transpose() * dj_v / product;
    result.value = std::abs(mode.value) - 1;
    result.gradient = (std::conj(mode.value) * rate).real() / std::abs(mode.value);
    result.angle = std::arg(mode.value);
    result.side = sign_along_first_key(result);
    return result;
  }

  void renew(const Linearisation &at, double /*chart*/) override {
    multiplier_ = nearest(at).value;
  }
  std::unique_ptr<LocusEquation> clone() const override {
    return std::make_unique<UnitModulus>(*this);
  }

private:
  Mode nearest(const Linearisation &at) const {
    Mode mode = nearest_mode(map_jacobian(at), multiplier_);
    if (mode.value.imag() <= 0)
      throw NumericalError("the pair of multipliers becomes real");
    return mode;
  }

  const ScaledProblem &problem_;
  std::complex<double> multiplier_;
};

class TouchingGuard : public LocusEquation {
public:
  TouchingGuard(const ScaledProblem &problem, const Graze &graze)
      : problem_{problem}, graze_{graze} {}

  Augmented evaluate(const Vector &u, double chart) const override {
    LinearisedExtension extension = problem_.extend(u, chart, graze_);
    Augmented result;
    static_cast<Linearisation &>(result) = std::move(extension.smooth);
    result.value = extension.value;
    result.gradient = extension.gradient;
    result.side = -sign_along_first_key(result);
    return result;
  }
  void renew(const Linearisation &, double) override {}
  std::unique_ptr<LocusEquation> clone() const override {
    return std::make_unique<TouchingGuard>(*this);
  }

private:
  const ScaledProblem &problem_;
  Graze graze_;
};

} // namespace

std::unique_ptr<LocusEquation> make_equation(const ScaledProblem &problem, const LocusStart &start,
                                             const Linearisation &at) {
  const double chart = start.point.chart;
  if (start.kind != LocusKind::graze && !problem.problem().is_map() &&
      start.kind != LocusKind::fold)
    throw std::logic_error("without a map there are loci of folds and grazing motions only");
  switch (start.kind) {
  case LocusKind::fold:
    return std::make_unique<SingularJacobian>(problem, 1, at, chart);
  case LocusKind::flip:
    return std::make_unique<SingularJacobian>(problem, -1, at, chart);
  case LocusKind::neimark_sacker:
    return std::make_unique<UnitModulus>(problem, at);
  case LocusKind::graze:
    if (!start.graze)
      throw std::logic_error("a grazing locus begins at a grazing motion");
    return std::make_unique<TouchingGuard>(problem, *start.graze);
  }
  throw std::logic_error("a locus of no kind");
}

} // namespace vibroimpact::continuation
