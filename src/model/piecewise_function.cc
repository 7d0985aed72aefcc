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
}

PiecewiseFunction::PiecewiseFunction(Given quantity, Pieces given, double highest_frequency)
    : PiecewiseFunction(displacement(quantity, std::move(given)), highest_frequency) {}

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
