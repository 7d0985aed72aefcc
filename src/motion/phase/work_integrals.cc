#include "motion/phase/work_integrals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::motion {

namespace {
constexpr double next_to_zero = 1e-3; // over the scale of time
// Over the fastest exponent; rounding makes pairs of several zeros. A scale of time that leaves a
// slow vibration out is shorter, and as exact.
constexpr double not_zero = 1e-8;
} // namespace

WorkIntegrals::WorkIntegrals(const PowerForms &powers, const ExactPhase &phase,
                             const StateLayout &layout)
    : powers_(powers), phase_(phase), input_work_(layout.input_work()),
      absolute_input_work_(layout.absolute_input_work()), dense_(powers, phase),
      of_dense_(powers.size()) {
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const auto known = std::find(entries_.begin(), entries_.end(), powers_.entry(k));
    place_of_.push_back(static_cast<std::size_t>(known - entries_.begin()));
    if (known == entries_.end())
      entries_.push_back(powers_.entry(k));
  }
  arrange();
}

void WorkIntegrals::renew() {
  dense_.renew();
  if (arrangement_ != phase_.arrangement()) {
    arrange();
    return;
  }
  const std::vector<PhaseGroup> &groups = phase_.groups();
  const auto is_new = [&](int group) {
    return groups[static_cast<std::size_t>(group)].generation > generation_;
  };
  bool same_products = true;
  for (std::size_t j = 0; j < groups.size(); ++j)
    if (groups[j].generation > generation_)
      same_products = set_forms(j) && same_products;
  if (!same_products) {
    arrange();
    return;
  }
  set_scale();
  for (std::size_t k = 0; k < products_.size(); ++k)
    if (is_new(products_[k].first) || is_new(products_[k].second) ||
        products_[k].is_slow != is_slow(products_[k]))
      set_product(k);
  limit_length();
  generation_ = phase_.generation();
}

// Groups stand at their own numbers up to the dense blocks, which come last.
void WorkIntegrals::arrange() {
  arrangement_ = phase_.arrangement();
  generation_ = phase_.generation();
  forms_.assign(2 * powers_.size() * phase_.groups().size(), 0);
  integrals_.assign(n_blocks() * 8, 0);
  for (std::size_t j = 0; j < phase_.groups().size(); ++j)
    set_forms(j);
  list_products();
  coefficients_.assign(n_blocks() * products_.size() * 16, 0);
  set_scale();
  for (std::size_t k = 0; k < products_.size(); ++k)
    set_product(k);
  limit_length();
  view_ = {.n_products = static_cast<int>(products_.size()),
           .n_padded = phase_.view().n_padded,
           .n_blocks = static_cast<int>(n_blocks()),
           .products = products_.data(),
           .coefficients = coefficients_.data()};
}

// Products that no power sees are left out.
void WorkIntegrals::list_products() {
  products_.clear();
  const std::vector<PhaseGroup> &groups = phase_.groups();
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = i; j < groups.size(); ++j) {
      if (groups[j].kind == BlockKind::dense)
        break;
      if (!is_seen(i, j))
        continue;
      products_.push_back({.first = static_cast<int>(i), .second = static_cast<int>(j)});
      if (groups[i].kind == BlockKind::pair && groups[j].kind == BlockKind::pair)
        products_.push_back(
            {.first = static_cast<int>(i), .second = static_cast<int>(j), .conjugate = true});
    }
}

// Does a power see one of the groups in one of its factors and the other in the other?
bool WorkIntegrals::is_seen(std::size_t i, std::size_t j) const {
  const std::size_t n = phase_.groups().size();
  const auto sees = [&](std::size_t form, std::size_t group) {
    return forms_[form * n + group] != 0.0;
  };
  for (std::size_t p = 0; p < powers_.size(); ++p)
    if ((sees(2 * p, i) && sees(2 * p + 1, j)) || (sees(2 * p, j) && sees(2 * p + 1, i)))
      return true;
  return false;
}

// A turn of the slowest vibration; by the fastest exponent where nothing vibrates.
void WorkIntegrals::set_scale() {
  double fastest = 0;
  for (const PhaseGroup &group : phase_.groups())
    if (group.kind != BlockKind::dense)
      fastest = std::max(fastest, std::abs(group.exponent));
  double slowest = std::numeric_limits<double>::infinity();
  for (const PhaseGroup &group : phase_.groups())
    if (group.kind == BlockKind::pair && group.exponent.imag() > not_zero * fastest)
      slowest = std::min(slowest, group.exponent.imag());
  vibrates_ = std::isfinite(slowest);
  scale_ = 2 * std::numbers::pi / std::min(slowest, fastest);
}

// Over the longest part the trapezoidal rule is exact to 1e-12 / 720.
void WorkIntegrals::limit_length() {
  double fastest = 0;
  for (const ProductView &product : products_)
    if (product.is_slow)
      fastest = std::max(fastest, std::hypot(product.sum_real, product.sum_imaginary));
  longest_ = vibrates_ ? scale_ : next_to_zero / fastest;
}

// What both factors of all powers see of a group: Re(c a), the constants with the number 1. False:
// one sees the group that did not before, or the other way round.
bool WorkIntegrals::set_forms(std::size_t j) {
  bool same = true;
  const PhaseGroup &group = phase_.groups()[j];
  const bool is_one = group.is_input() && group.coordinates[0] == phase_.n_modes();
  const Matrix &columns = phase_.columns();
  for (Index row = 0; row < powers_.rows().rows(); ++row) {
    Complex seen = powers_.rows().row(row).dot(columns.col(group.coordinates[0]));
    if (group.kind == BlockKind::pair)
      seen.imag(-powers_.rows().row(row).dot(columns.col(group.coordinates[1])));
    if (is_one)
      seen += powers_.constants()[row];
    Complex &form = forms_[static_cast<std::size_t>(row) * phase_.groups().size() + j];
    same = same && (form == 0.0) == (seen == 0.0);
    form = seen;
  }
  return same;
}

// Does the trapezoidal rule take the place of a division by next to nothing?
bool WorkIntegrals::is_slow(const ProductView &product) const {
  const double squared =
      product.sum_real * product.sum_real + product.sum_imaginary * product.sum_imaginary;
  return !(squared * scale_ * scale_ >= next_to_zero * next_to_zero);
}

// Re(c z) Re(d w) = (Re(c d z w) + Re(c conj(d) z conj(w))) / 2, the two being one where z or w is
// real.
Complex WorkIntegrals::coefficient(std::size_t power, const ProductView &product) const {
  const auto i = static_cast<std::size_t>(product.first);
  const auto j = static_cast<std::size_t>(product.second);
  const std::size_t n_groups = phase_.groups().size();
  const Complex *c = forms_.data() + 2 * power * n_groups;
  const Complex *d = c + n_groups;
  Complex value = product.conjugate ? c[i] * std::conj(d[j]) : c[i] * d[j];
  if (i != j)
    value += product.conjugate ? std::conj(c[j]) * d[i] : c[j] * d[i];
  return value;
}

void WorkIntegrals::set_product(std::size_t k) {
  ProductView &product = products_[k];
  const PhaseGroup &first = phase_.groups()[static_cast<std::size_t>(product.first)];
  const PhaseGroup &second = phase_.groups()[static_cast<std::size_t>(product.second)];
  const Complex sum =
      first.exponent + (product.conjugate ? std::conj(second.exponent) : second.exponent);
  product.sum_real = sum.real();
  product.sum_imaginary = sum.imag();
  product.is_slow = is_slow(product);
  const bool both = first.kind == BlockKind::pair && second.kind == BlockKind::pair;
  const Complex factor = (both ? 0.5 : 1.0) * (product.is_slow ? Complex(1) : 1.0 / sum);
  const std::size_t stride = products_.size() * 16;
  for (std::size_t block = 0; block < n_blocks(); ++block)
    std::fill_n(coefficients_.data() + block * stride + k * 16, 16, 0.0);
  for (std::size_t p = 0; p < powers_.size(); ++p) {
    const Complex value = coefficient(p, product) * factor;
    const std::size_t entry = place_of_[p];
    double *into = coefficients_.data() + (entry / 8) * stride + k * 16 + entry % 8;
    into[0] += value.real();
    into[8] += value.imag();
  }
}

void WorkIntegrals::add(const double *start, const double *end, double h, Vector &state) {
  const bool dense = phase_.has_dense();
  if (dense && dense_.takes_all(h))
    std::fill(integrals_.begin(), integrals_.end(), 0.0);
  else
    kernel().integrate(view_, start, end, h, integrals_.data());
  if (dense) {
    std::fill(of_dense_.begin(), of_dense_.end(), 0.0);
    dense_.add(start, end, h, of_dense_);
    for (std::size_t p = 0; p < of_dense_.size(); ++p)
      integrals_[place_of_[p]] += of_dense_[p];
  }
  for (std::size_t entry = 0; entry < entries_.size(); ++entry) {
    state[entries_[entry]] += integrals_[entry];
    if (entries_[entry] == input_work_)
      state[absolute_input_work_] += std::abs(integrals_[entry]);
  }
}

} // namespace vibroimpact::motion
