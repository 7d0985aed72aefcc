#include "model/piecewise_function.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace vibroimpact::model {

namespace {

Pieces displacement(Given quantity, Pieces given) {
  if (quantity == Given::displacement)
    return given;
  return quantity == Given::velocity ? given.integral() : given.integral().integral();
}

} // namespace

// The coefficient of t^j is that of the polynomial and the sum of amplitude exponent^j / j!. One
// that is below the rounding of its terms is zero.
Onset::Onset(const ExponentialForm &form) : origin_(form.origin) {
  double fastest = 0;
  for (const ExponentialForm::Term &term : form.terms)
    fastest = std::max(fastest, std::abs(term.exponent));
  if (fastest == 0 || form.terms.size() + form.polynomial.size() < 2)
    return;
  length_ = 1 / (16 * fastest);
  std::vector<std::complex<double>> terms;
  for (const ExponentialForm::Term &term : form.terms)
    terms.push_back(term.amplitude);
  for (int j = 0; j <= degree; ++j) {
    const auto place = static_cast<std::size_t>(j);
    double sum = place < form.polynomial.size() ? form.polynomial[place] : 0;
    double size = std::abs(sum);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      sum += terms[k].real();
      size += std::abs(terms[k]);
      terms[k] *= form.terms[k].exponent / (j + 1.0);
    }
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    coefficients_[place] = std::abs(sum) > rounding * size ? sum : 0;
  }
}

double Onset::derivative(int order, double time) const {
  const double t = time - origin_;
  double sum = 0;
  for (int j = degree; j >= order; --j) {
    const double factor = order == 0 ? 1 : order == 1 ? j : j * (j - 1.0);
    sum = sum * t + factor * coefficients_[static_cast<std::size_t>(j)];
  }
  return sum;
}

std::size_t Pieces::index(double time) const {
  return static_cast<std::size_t>(std::upper_bound(breaks.begin(), breaks.end(), time) -
                                  breaks.begin());
}

Pieces Pieces::integral() const {
  Pieces integrated{.breaks = breaks, .forms = {forms[0].integral(0)}};
  integrated.forms.reserve(forms.size());
  for (std::size_t k = 1; k < forms.size(); ++k)
    integrated.forms.push_back(forms[k].integral(integrated.forms.back().value(breaks[k - 1])));
  return integrated;
}

PiecewiseFunction::PiecewiseFunction(Pieces pieces, double highest_frequency)
    : pieces_(std::move(pieces)), highest_frequency_(highest_frequency) {
  if (pieces_.forms.size() != pieces_.breaks.size() + 1)
    throw std::logic_error("a piecewise function needs one form more than breaks");
  if (std::any_of(pieces_.forms.begin(), pieces_.forms.end(),
                  [](const ExponentialForm &form) { return !form.terms.empty(); }))
    for (const ExponentialForm &form : pieces_.forms)
      onsets_.emplace_back(form);
}

PiecewiseFunction::PiecewiseFunction(Given quantity, Pieces given, double highest_frequency)
    : PiecewiseFunction(displacement(quantity, std::move(given)), highest_frequency) {}

const Onset *PiecewiseFunction::onset(std::size_t piece, double time) const {
  return !onsets_.empty() && onsets_[piece].covers(time) ? &onsets_[piece] : nullptr;
}

double PiecewiseFunction::value(double time) const {
  const std::size_t k = pieces_.index(time);
  const Onset *near = onset(k, time);
  return near ? near->derivative(0, time) : pieces_.forms[k].value(time);
}

double PiecewiseFunction::rate(double time) const {
  const std::size_t k = pieces_.index(time);
  const Onset *near = onset(k, time);
  return near ? near->derivative(1, time) : pieces_.forms[k].rate(time);
}

double PiecewiseFunction::acceleration(double time) const {
  const std::size_t k = pieces_.index(time);
  const Onset *near = onset(k, time);
  return near ? near->derivative(2, time) : pieces_.forms[k].acceleration(time);
}

double PiecewiseFunction::next_break(double time) const {
  const std::size_t next = pieces_.index(time);
  return next < pieces_.breaks.size() ? pieces_.breaks[next]
                                      : std::numeric_limits<double>::infinity();
}

std::optional<ExponentialForm> PiecewiseFunction::exponential_form(double time) const {
  return pieces_.at(time).about(time);
}

std::shared_ptr<const TimeFunction> make_constant(Given quantity, double value) {
  return std::make_shared<PiecewiseFunction>(
      quantity, Pieces{.breaks = {}, .forms = {{.origin = 0, .terms = {}, .polynomial = {value}}}},
      0);
}

} // namespace vibroimpact::model
