#include "analyses/sweeps/linear_response.h"

#include "analyses/sweeps/tied_contacts.h"
#include "common/decompositions.h"
#include "common/error.h"

#include <limits>

namespace vibroimpact::analyses {

namespace {

using ComplexAmplitude = std::complex<double>;
constexpr ComplexAmplitude i(0, 1);

ComplexVector solved(const ComplexMatrix &dynamic, const ComplexVector &load) {
  const LuFactors<ComplexMatrix> factors(dynamic);
  if (!(factors.reciprocal_condition() > std::numeric_limits<double>::epsilon()))
    throw NumericalError("the response without damping is unbounded at this frequency");
  return factors.solve(load);
}

} // namespace

LinearResponse::LinearResponse(const model::Model &model, std::size_t source,
                               const std::vector<model::Projection> &tied)
    : model_(model), source_(source), stiffness_(model.stiffness().dense()),
      damping_(model.damping().dense()) {
  if (!model.linear())
    throw InputError("A frequency response must have a linear model, without cubic springs and "
                     "rotors; use a stepped sweep.");
  const model::Source &driving = model.sources().at(source);
  if (!driving.function->harmonic())
    throw InputError("A frequency response must have a harmonic excitation, but " + driving.name +
                     " is none.");
  if (!tied.empty())
    tie(tied);
}

void LinearResponse::tie(const std::vector<model::Projection> &tied) {
  const Matrix rows = rows_of(tied, model_.size());
  Vector base(rows.rows());
  for (std::size_t k = 0; k < tied.size(); ++k)
    base[static_cast<Index>(k)] = tied[k].base_coefficients[source_];
  basis_ = model::AssembledSystem(model_, rows).basis();
  const Matrix compliance = model_.mass().cwiseInverse().asDiagonal() * rows.transpose();
  moved_ = -compliance * least_norm_solution(Matrix(rows * compliance), base);
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
  ComplexVector coordinates = basis_.size() > 0 ? solved_tied(dynamic, load * amplitude, amplitude)
                                                : solved(dynamic, load * amplitude);
  return {.angular_frequency = angular_frequency,
          .source = amplitude,
          .coordinates = std::move(coordinates)};
}

ComplexVector LinearResponse::solved_tied(const ComplexMatrix &dynamic, const ComplexVector &load,
                                          ComplexAmplitude source) const {
  const ComplexMatrix basis = basis_.cast<ComplexAmplitude>();
  const ComplexVector moved = moved_.cast<ComplexAmplitude>() * source;
  return basis * solved(basis.transpose() * dynamic * basis,
                        basis.transpose() * (load - dynamic * moved)) +
         moved;
}

ComplexAmplitude LinearResponse::observed(const model::Projection &projection,
                                          const ComplexAmplitudes &amplitudes) const {
  ComplexAmplitude sum = projection.row.cast<ComplexAmplitude>() * amplitudes.coordinates;
  return sum + projection.base_coefficients[source_] * amplitudes.source;
}

} // namespace vibroimpact::analyses
