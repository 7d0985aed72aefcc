#include "contact/laws/crush_curves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace vibroimpact::contact {

namespace {

// A curve by the residual penetration: its points without those at the end of an elastic segment.
class ByResidual {
public:
  ByResidual(const ForceCurve &curve, double stiffness) : curve_(curve), stiffness_(stiffness) {
    first_ = CrushCurves::is_elastic(curve.slope(0), stiffness) ? 1 : 0;
    for (std::size_t s = first_; s < curve.n_segments(); ++s) {
      if (!(curve.slope(s) < stiffness))
        throw std::invalid_argument("a curve is steeper than the line of unloading");
      residuals_.push_back(s == first_ ? 0 : curve.lengths()[s] - curve.forces()[s] / stiffness);
    }
    if (residuals_.empty())
      throw std::invalid_argument("a curve has no segment but an elastic one");
  }

  const std::vector<double> &residuals() const { return residuals_; }
  CrushSide side(double residual) const {
    const std::size_t s = first_ + place(residual);
    const double slope = curve_.slope(s);
    const double intercept = curve_.intercept(s);
    // p = u - (intercept + slope u) / K
    const double growth = 1 / (1 - slope / stiffness_);
    return {.segment = s,
            .at_zero = growth * intercept / stiffness_,
            .slope = growth,
            .intercept = intercept,
            .stiffness = slope};
  }
  // Exactly that of a point where there is one.
  double penetration(double residual) const {
    const std::size_t k = place(residual);
    return residuals_[k] == residual ? curve_.lengths()[first_ + k]
                                     : side(residual).penetration(residual);
  }

private:
  std::size_t place(double residual) const {
    const auto above = std::upper_bound(residuals_.begin() + 1, residuals_.end(), residual);
    return static_cast<std::size_t>(above - residuals_.begin()) - 1;
  }

  const ForceCurve &curve_;
  double stiffness_;
  std::size_t first_;
  std::vector<double> residuals_; ///< at the beginning of each segment [m]
};

ForceCurve nothing() { return {{0.0, 1.0}, {0.0, 0.0}}; }

// Both are straight between the points of either, and behind them.
void require_below(const ForceCurve &unloading, const ForceCurve &loading) {
  std::vector<double> places = loading.lengths();
  places.insert(places.end(), unloading.lengths().begin(), unloading.lengths().end());
  for (const double u : places)
    if (u > 0 && !(unloading(u) < loading(u)))
      throw std::invalid_argument("must be below Force at every penetration above zero; at " +
                                  std::to_string(u) + " m it is not.");
  if (unloading.slope(unloading.n_segments() - 1) > loading.slope(loading.n_segments() - 1))
    throw std::invalid_argument("must not be steeper than Force behind the last points of both.");
}

} // namespace

bool CrushCurves::is_elastic(double slope, double unloading_stiffness) {
  constexpr double rounding = 1e-12;
  return std::abs(slope - unloading_stiffness) <= rounding * unloading_stiffness;
}

CrushCurves::CrushCurves(const ForceCurve &loading, const std::optional<ForceCurve> &unloading,
                         double unloading_stiffness)
    : stiffness_(unloading_stiffness),
      yields_later_(CrushCurves::is_elastic(loading.slope(0), unloading_stiffness)),
      unloading_(unloading.value_or(nothing())) {
  require_below(unloading_, loading);
  const ByResidual above(loading, stiffness_);
  const ByResidual below(unloading_, stiffness_);
  std::vector<double> begins = above.residuals();
  begins.insert(begins.end(), below.residuals().begin(), below.residuals().end());
  std::sort(begins.begin(), begins.end());
  begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
  for (const double begin : begins)
    intervals_.push_back({.begin = begin,
                          .loading_begin = above.penetration(begin),
                          .unloading_begin = below.penetration(begin),
                          .loading = above.side(begin),
                          .unloading = below.side(begin)});
}

std::size_t CrushCurves::interval(double residual) const {
  const auto above =
      std::upper_bound(intervals_.begin() + 1, intervals_.end(), residual,
                       [](double p, const CrushInterval &interval) { return p < interval.begin; });
  return static_cast<std::size_t>(above - intervals_.begin()) - 1;
}

double CrushCurves::recoverable_below(std::size_t interval, double penetration) const {
  return unloading_.area(penetration, intervals_[interval].unloading.segment);
}

// Down the line to the unloading curve, and along it.
double CrushCurves::recoverable(std::size_t interval, double residual, double penetration) const {
  const CrushSide &below = intervals_[interval].unloading;
  const double met = below.penetration(residual);
  const double force = stiffness_ * (penetration - residual);
  return recoverable_below(interval, met) + 0.5 * (force + below.force(met)) * (penetration - met);
}

} // namespace vibroimpact::contact
