#include "motion/interval/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {
// Beyond this depth an interval is shorter than the spacing of doubles next to 1.
constexpr int maximum_depth = 52;

constexpr auto make_binomials() {
  constexpr int count = Bernstein::maximum_degree + 1;
  std::array<std::array<double, count>, count> table{};
  for (int n = 0; n < count; ++n)
    for (int k = 0; k <= n; ++k)
      table[n][k] = k == 0 || k == n ? 1 : table[n - 1][k - 1] + table[n - 1][k];
  return table;
}
constexpr auto binomials = make_binomials();
} // namespace

// At tau = 0 the k-th derivative of degree n is n! / (n - k)! times the k-th forward difference of
// the coefficients; at tau = 1 likewise from the other end.
void Bernstein::set_ends(double h, std::span<const double> start, std::span<const double> end) {
  constexpr int binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  const int count = static_cast<int>(start.size());
  double left[5];
  double right[5];
  double factor = 1;
  double sign = 1;
  for (int k = 0; k < count; ++k) {
    left[k] = factor * start[k];
    right[k] = sign * factor * end[k];
    factor *= h / (degree_ - k);
    sign = -sign;
  }
  for (int i = 0; i < count; ++i) {
    double from_left = left[0];
    double from_right = right[0];
    for (int k = 1; k <= i; ++k) {
      from_left += binomial[i][k] * left[k];
      from_right += binomial[i][k] * right[k];
    }
    coefficients_[i] = from_left;
    coefficients_[degree_ - i] = from_right;
  }
}

Bernstein Bernstein::hermite(double h, std::span<const double> start, std::span<const double> end) {
  Bernstein p;
  p.degree_ = 2 * static_cast<int>(start.size()) - 1;
  p.set_ends(h, start, end);
  return p;
}

// The coefficient in the middle follows from the mean of all, which is the difference of the values
// over h. Where that is lost in rounding the others make a polynomial by themselves.
Bernstein Bernstein::hermite_rate(double h, std::span<const double> start,
                                  std::span<const double> end) {
  const double rounding =
      64 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start[0]), std::abs(end[0]));
  if (rounding > 1e-9 * h * std::max(std::abs(start[1]), std::abs(end[1])))
    return hermite(h, start.subspan(1), end.subspan(1));
  Bernstein p;
  p.degree_ = 2 * static_cast<int>(start.size()) - 2;
  p.set_ends(h, start.subspan(1), end.subspan(1));
  double others = 0;
  for (int i = 0; i <= p.degree_; ++i)
    others += p.coefficients_[i];
  p.coefficients_[p.degree_ / 2] = (p.degree_ + 1) * (end[0] - start[0]) / h - others;
  return p;
}

Bernstein Bernstein::quintic(double h, const std::array<double, 3> &start,
                             const std::array<double, 3> &end) {
  return hermite(h, start, end);
}

Bernstein Bernstein::cubic(double h, const std::array<double, 2> &start,
                           const std::array<double, 2> &end) {
  return hermite(h, start, end);
}

Bernstein Bernstein::of_coefficients(std::span<const double> coefficients) {
  Bernstein polynomial;
  polynomial.degree_ = static_cast<int>(coefficients.size()) - 1;
  std::copy(coefficients.begin(), coefficients.end(), polynomial.coefficients_.begin());
  return polynomial;
}

Bernstein Bernstein::basis(int degree, int j) {
  Bernstein polynomial;
  polynomial.degree_ = degree;
  polynomial.coefficients_[j] = 1;
  return polynomial;
}

Bernstein Bernstein::line(double start, double end) {
  Bernstein polynomial;
  polynomial.degree_ = 1;
  polynomial.coefficients_[0] = start;
  polynomial.coefficients_[1] = end;
  return polynomial;
}

// A sum of positive weights times the coefficients, exact at both ends.
double Bernstein::operator()(double tau) const {
  const double rest = 1 - tau;
  const auto &binomial = binomials[degree_];
  double power = 1;
  double sum = coefficients_[0];
  for (int i = 1; i <= degree_; ++i) {
    power *= tau;
    sum = sum * rest + power * binomial[i] * coefficients_[i];
  }
  return sum;
}

Bernstein Bernstein::derivative() const {
  Bernstein d;
  d.degree_ = std::max(0, degree_ - 1);
  for (int i = 0; i < degree_; ++i)
    d.coefficients_[i] = degree_ * (coefficients_[i + 1] - coefficients_[i]);
  return d;
}

Bernstein &Bernstein::operator*=(double factor) {
  for (int i = 0; i <= degree_; ++i)
    coefficients_[i] *= factor;
  return *this;
}

// The coefficient k is the sum over i + j = k of C(p, i) C(q, j) / C(p + q, k) b_i b_j.
Bernstein Bernstein::operator*(const Bernstein &other) const {
  Bernstein product;
  product.degree_ = degree_ + other.degree_;
  for (int i = 0; i <= degree_; ++i)
    for (int j = 0; j <= other.degree_; ++j)
      product.coefficients_[i + j] += binomials[degree_][i] * binomials[other.degree_][j] /
                                      binomials[product.degree_][i + j] * coefficients_[i] *
                                      other.coefficients_[j];
  return product;
}

Bernstein Bernstein::raised() const {
  Bernstein p;
  p.degree_ = degree_ + 1;
  p.coefficients_[0] = coefficients_[0];
  for (int i = 1; i <= degree_; ++i) {
    const double weight = static_cast<double>(i) / (degree_ + 1);
    p.coefficients_[i] = weight * coefficients_[i - 1] + (1 - weight) * coefficients_[i];
  }
  p.coefficients_[degree_ + 1] = coefficients_[degree_];
  return p;
}

Bernstein &Bernstein::operator+=(const Bernstein &other) {
  Bernstein addend = other;
  while (addend.degree_ < degree_)
    addend = addend.raised();
  while (degree_ < addend.degree_)
    *this = raised();
  for (int i = 0; i <= degree_; ++i)
    coefficients_[i] += addend.coefficients_[i];
  return *this;
}

Bernstein &Bernstein::operator+=(double constant) {
  for (int i = 0; i <= degree_; ++i)
    coefficients_[i] += constant;
  return *this;
}

Bernstein Bernstein::with_middle(double amount) const {
  Bernstein p = raised();
  p.coefficients_[p.degree_ / 2] += amount;
  return p;
}

void Bernstein::clear_start(double negligible) {
  coefficients_[0] = 0;
  for (int i = 1; i <= degree_ && std::abs(coefficients_[i]) <= negligible; ++i)
    coefficients_[i] = 0;
}

double Bernstein::lower_bound() const {
  return *std::min_element(coefficients_.begin(), coefficients_.begin() + degree_ + 1);
}

double Bernstein::upper_bound() const {
  return *std::max_element(coefficients_.begin(), coefficients_.begin() + degree_ + 1);
}

void Bernstein::split(Bernstein &left, Bernstein &right) const {
  std::array<double, maximum_degree + 1> c = coefficients_;
  left.degree_ = right.degree_ = degree_;
  for (int level = degree_; level >= 0; --level) {
    left.coefficients_[degree_ - level] = c[0];
    right.coefficients_[level] = c[level];
    for (int i = 0; i < level; ++i)
      c[i] = 0.5 * (c[i] + c[i + 1]);
  }
}

int Bernstein::sign_after_start() const {
  for (int i = 0; i <= degree_; ++i)
    if (coefficients_[i] != 0)
      return coefficients_[i] > 0 ? 1 : -1;
  return 0;
}

// By de Casteljau's algorithm.
Bernstein Bernstein::behind(double tau) const {
  Bernstein p = *this;
  for (int level = degree_; level > 0; --level)
    for (int i = 0; i < level; ++i)
      p.coefficients_[i] += tau * (p.coefficients_[i + 1] - p.coefficients_[i]);
  return p;
}

// The left part by the other side of de Casteljau's triangle.
Bernstein Bernstein::between(double from, double to) const {
  Bernstein p = from > 0 ? behind(from) : *this;
  const double tau = from < 1 ? (to - from) / (1 - from) : 0;
  for (int level = 1; tau < 1 && level <= degree_; ++level)
    for (int i = degree_; i >= level; --i)
      p.coefficients_[i] =
          p.coefficients_[i - 1] + tau * (p.coefficients_[i] - p.coefficients_[i - 1]);
  return p;
}

// As many zeros in (0, 1) as that, or fewer by an even number: with x = tau / (1 - tau) the
// polynomial is (1 - tau)^n times sum C(n, i) b_i x^i, for which Descartes' rule of signs says so.
int Bernstein::sign_changes() const {
  int changes = 0;
  double last = 0;
  for (int i = 0; i <= degree_; ++i) {
    if (coefficients_[i] * last < 0)
      ++changes;
    if (coefficients_[i] != 0)
      last = coefficients_[i];
  }
  return changes;
}

// p(tau) / tau for a polynomial that is zero at the start.
Bernstein Bernstein::without_zero_at_start() const {
  Bernstein quotient;
  quotient.degree_ = degree_ - 1;
  for (int i = 0; i < degree_; ++i)
    quotient.coefficients_[i] = coefficients_[i + 1] * degree_ / (i + 1);
  return quotient;
}

// The only zero of a polynomial that starts positive and has one sign change: bisection with
// Newton steps where these stay inside the bracket.
double Bernstein::falling_zero() const {
  if (coefficients_[0] == 0)
    return without_zero_at_start().falling_zero();
  const Bernstein slope = derivative();
  double lower = 0;
  double upper = 1;
  double tau = coefficients_[0] / (coefficients_[0] - coefficients_[degree_]);
  for (int i = 0; i < 200; ++i) {
    const double value = (*this)(tau);
    (value > 0 ? lower : upper) = tau;
    const double newton = tau - value / slope(tau);
    const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
    const bool settled = std::abs(next - tau) <= 32 * std::numeric_limits<double>::epsilon();
    if (settled || next <= lower || next >= upper)
      break;
    tau = next;
  }
  return tau;
}

std::optional<double> Bernstein::first_down_crossing() const {
  const int changes = sign_changes();
  if (sign_after_start() < 0)
    return 0;
  if (changes == 0)
    return std::nullopt;
  return changes == 1 ? falling_zero() : first_down_crossing_by_subdivision();
}

std::optional<double> Bernstein::first_down_crossing_by_subdivision() const {
  struct Piece {
    Bernstein p;
    double start;
    double length;
    int depth;
  };
  std::array<Piece, maximum_depth + 2> stack;
  std::size_t count = 0;
  stack[count++] = {*this, 0, 1, 0};
  while (count > 0) {
    const Piece piece = stack[--count];
    const int sign = piece.p.sign_after_start();
    if (sign < 0)
      return piece.start;
    const int changes = piece.p.sign_changes();
    if (changes == 0)
      continue;
    if (changes == 1)
      return piece.start + piece.length * piece.p.falling_zero();
    if (piece.depth == maximum_depth)
      continue; // a double zero to the last bit: it touches without passing through
    Piece left{.p = {}, .start = piece.start, .length = piece.length / 2, .depth = piece.depth + 1};
    Piece right{.p = {},
                .start = piece.start + piece.length / 2,
                .length = piece.length / 2,
                .depth = piece.depth + 1};
    piece.p.split(left.p, right.p);
    stack[count++] = right;
    stack[count++] = left;
  }
  return std::nullopt;
}

void Bernstein::collect_maximum(double &best) const {
  best = std::max({best, start(), end()});
  // A flat enough interval is bounded by its coefficients to the last digits.
  const double bound =
      *std::max_element(coefficients_.begin(), coefficients_.begin() + degree_ + 1);
  const double span =
      bound - *std::min_element(coefficients_.begin(), coefficients_.begin() + degree_ + 1);
  if (bound <= best || span <= 1e-15 * std::abs(bound))
    return;
  const Bernstein slope = derivative();
  const int turns = slope.sign_changes(); // an upper bound of their number
  if (turns == 1 && slope.sign_after_start() > 0)
    best = std::max(best, (*this)(slope.falling_zero()));
  if (turns <= 1)
    return;
  Bernstein left;
  Bernstein right;
  split(left, right);
  left.collect_maximum(best);
  right.collect_maximum(best);
}

double Bernstein::maximum() const {
  double best = std::max(start(), end());
  collect_maximum(best);
  return best;
}

double Bernstein::minimum() const {
  Bernstein negative = *this;
  negative *= -1;
  return -negative.maximum();
}

} // namespace vibroimpact::motion
