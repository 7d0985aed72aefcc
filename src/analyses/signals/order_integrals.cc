#include "analyses/signals/order_integrals.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

OrderIntegrals::OrderIntegrals(double origin, double angular_frequency, std::size_t orders,
                               std::size_t signals)
    : origin_(origin), angular_frequency_(angular_frequency), orders_(orders),
      sums_(signals, std::vector<std::complex<double>>(orders + 1)) {}

void OrderIntegrals::add_node(double time, double weight, double tau,
                              const std::vector<StepFunction> &functions) {
  const double angle = angular_frequency_ * (time - origin_);
  for (std::size_t s = 0; s < functions.size(); ++s) {
    const double value = weight * functions[s](tau);
    for (std::size_t j = 0; j <= orders_; ++j)
      sums_[s][j] += std::polar(value, -static_cast<double>(j) * angle);
  }
}

void OrderIntegrals::add(double start, double length, const std::vector<StepFunction> &functions) {
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  const double turn = static_cast<double>(orders_) * angular_frequency_ * length;
  const auto panels = static_cast<std::size_t>(1 + turn / std::numbers::pi);
  const double half = 0.5 / static_cast<double>(panels);
  for (std::size_t p = 0; p < panels; ++p) {
    const double middle = static_cast<double>(2 * p + 1) * half;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0}) {
        const double x = Gauss::abscissa()[i];
        if (x == 0 && side > 0)
          continue; // the middle stands in the table once
        const double tau = middle + side * half * x;
        add_node(start + tau * length, Gauss::weights()[i] * half * length, tau, functions);
      }
  }
  duration_ += length;
}

double OrderIntegrals::mean(std::size_t signal) const {
  return sums_[signal][0].real() / duration_;
}

double OrderIntegrals::amplitude(std::size_t signal, std::size_t order) const {
  return 2 * std::abs(sums_[signal][order]) / duration_;
}

double OrderIntegrals::phase(std::size_t signal, std::size_t order) const {
  return std::arg(sums_[signal][order]);
}

} // namespace vibroimpact::analyses
