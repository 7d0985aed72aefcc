#include "motion/phase/quadratic_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

using Function = std::function<double(const Vector &)>;

// Below it numbers have fewer digits, and none at all in the end: a term there counts as zero.
constexpr double smallest = std::numeric_limits<double>::min();

double value(const Matrix &form, const Vector &x) {
  Vector with_one(x.size() + 1);
  with_one << x, 1.0;
  return with_one.dot(form * with_one);
}

// Along each axis the x that makes its own square term one, so that products are not lost beside
// squares of another size.
Vector scales(const Function &f, Index n) {
  constexpr double rounding = 1e-13;
  const double constant = f(Vector::Zero(n));
  Vector scale = Vector::Ones(n);
  for (Index i = 0; i < n; ++i) {
    const Vector x = Vector::Unit(n, i);
    const double ahead = f(x);
    const double behind = f(-x);
    const double square = 0.5 * std::abs(ahead + behind - 2 * constant);
    if (square >
        std::max(smallest, rounding * (std::abs(ahead) + std::abs(behind) + std::abs(constant))))
      scale[i] = 1 / std::sqrt(square);
  }
  return scale;
}

bool agrees(const Function &f, const Matrix &form, const Vector &scale) {
  constexpr double rounding = 1e-12;
  for (const double factor : {1.0, -0.3, 1.7}) {
    Vector x = factor * scale;
    for (Index i = 0; i < x.size(); ++i)
      x[i] *= 1 - 0.37 * static_cast<double>(i);
    const double size = value(form.cwiseAbs(), x.cwiseAbs());
    if (!(std::abs(f(x) - value(form, x)) <= rounding * size + smallest))
      return false;
  }
  return true;
}

} // namespace

std::optional<Matrix> quadratic_form(const Function &f, Index n) {
  const Vector scale = scales(f, n);
  Matrix form = Matrix::Zero(n + 1, n + 1);
  form(n, n) = f(Vector::Zero(n));
  for (Index i = 0; i < n; ++i) {
    const Vector x = scale[i] * Vector::Unit(n, i);
    const double ahead = f(x) - form(n, n);
    const double behind = f(-x) - form(n, n);
    form(i, i) = (ahead + behind) / (2 * scale[i] * scale[i]);
    form(i, n) = form(n, i) = (ahead - behind) / (4 * scale[i]);
  }
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < i; ++j) {
      const Vector one = scale[i] * Vector::Unit(n, i);
      const Vector other = scale[j] * Vector::Unit(n, j);
      const double mixed = f(one + other) - f(one) - f(other) + form(n, n);
      form(i, j) = form(j, i) = mixed / (2 * scale[i] * scale[j]);
    }
  if (!agrees(f, form, scale))
    return std::nullopt;
  return form;
}

} // namespace vibroimpact::motion
