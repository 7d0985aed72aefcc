#include "analyses/sweeps/linear_response.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <limits>

namespace vibroimpact::analyses {

namespace {

using ComplexAmplitude = std::complex<double>;
constexpr ComplexAmplitude i(0, 1);

} // namespace

LinearResponse::LinearResponse(const model::Model &model, std::size_t source)
    : model_(model), source_(source), stiffness_(model.stiffness().dense()),
      damping_(model.damping().dense()) {
  if (!model.linear())
    throw InputError("A frequency response must have a linear model, without cubic springs and "
                     "rotors; use a stepped sweep.");
  const model::Source &driving = model.sources().at(source);
  if (!driving.function->harmonic())
    throw InputError("A frequency response must have a harmonic excitation, but " + driving.name +
                     " is none.");
}

ComplexAmplitudes LinearResponse::at(double angular_frequency) const {
  const model::Source &driving = model_.sources()[source_];
  const auto function = driving.function->with_frequency(angular_frequency);
  // s = Im(S exp(i w t)): s(0) = Im S, s'(0) = w Re S.
  const ComplexAmplitude amplitude(function->rate(0) / angular_frequency, function->value(0));
  const double squared = angular_frequency * angular_frequency;
  Eigen::MatrixXcd dynamic = stiffness_.cast<ComplexAmplitude>();
  dynamic += i * angular_frequency * damping_.cast<ComplexAmplitude>();
  dynamic.diagonal() -= (squared * model_.mass()).cast<ComplexAmplitude>();
  Eigen::VectorXcd load = (driving.load - squared * driving.inertial_load).cast<ComplexAmplitude>();
  load += i * angular_frequency * driving.rate_load.cast<ComplexAmplitude>();
  const LuFactors<ComplexMatrix> factors(dynamic);
  if (!(factors.reciprocal_condition() > std::numeric_limits<double>::epsilon()))
    throw NumericalError("the response without damping is unbounded at this frequency");
  return {.angular_frequency = angular_frequency,
          .source = amplitude,
          .coordinates = factors.solve(ComplexVector(load * amplitude))};
}

ComplexAmplitude LinearResponse::observed(const model::Projection &projection,
                                          const ComplexAmplitudes &amplitudes) const {
  ComplexAmplitude sum = projection.row.cast<ComplexAmplitude>() * amplitudes.coordinates;
  return sum + projection.base_coefficients[source_] * amplitudes.source;
}

} // namespace vibroimpact::analyses
