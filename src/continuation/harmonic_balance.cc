#include "continuation/harmonic_balance.h"

#include "common/decompositions.h"
#include "continuation/harmonic_series.h"

#include <algorithm>

namespace vibroimpact::continuation {

namespace {

// a cos + b sin = Re[(a - i b) exp(i h phi)]
ComplexMatrix harmonic(const Matrix &series, Index h) {
  ComplexMatrix column(series.rows(), 1);
  column.real() = series.col(h == 0 ? 0 : 2 * h - 1);
  if (h == 0)
    column.imag().setZero();
  else
    column.imag() = -series.col(2 * h);
  return column;
}

void set_harmonic(Matrix &series, Index h, const ComplexMatrix &column) {
  series.col(h == 0 ? 0 : 2 * h - 1) = column.real();
  if (h > 0)
    series.col(2 * h) = -column.imag();
}

using Factors = LuFactors<ComplexMatrix>;

Factors dynamic_stiffness(const HarmonicEquations &at, Index h) {
  const double omega = static_cast<double>(h) * at.frequency;
  ComplexMatrix stiffness(at.mass.rows(), at.mass.rows());
  stiffness.real() = at.stiffness - omega * omega * at.mass;
  stiffness.imag() = omega * at.damping;
  return Factors(stiffness);
}

// Z^-1 of all harmonics of a load.
Matrix response(const HarmonicEquations &at, const Matrix &load) {
  Matrix coordinates(load.rows(), load.cols());
  for (Index h = 0; h <= harmonics_of(load.cols()); ++h)
    set_harmonic(coordinates, h, dynamic_stiffness(at, h).solve(ComplexMatrix(harmonic(load, h))));
  if (!coordinates.allFinite())
    throw NumericalError("the linear part has an undamped resonance here");
  return coordinates;
}

Matrix forces_of(const std::vector<ForceSeries> &forces, Index coefficients) {
  Matrix all(static_cast<Index>(forces.size()), coefficients);
  for (std::size_t e = 0; e < forces.size(); ++e)
    all.row(static_cast<Index>(e)) = forces[e].force;
  return all;
}

// Compliance G = r_e Z_h^-1 r_f^T of each harmonic, m x m.
std::vector<ComplexMatrix> compliances(const HarmonicEquations &at, Index harmonics) {
  std::vector<ComplexMatrix> list;
  for (Index h = 0; h <= harmonics; ++h)
    list.emplace_back(at.rows * dynamic_stiffness(at, h).solve(ComplexMatrix(at.rows.transpose())));
  return list;
}

// G as it acts on coefficients: x_a - i x_b = G (f_a - i f_b), harmonic by harmonic.
Matrix yielding(const std::vector<ComplexMatrix> &compliance, Index e, Index f,
                const Matrix &forces) {
  Matrix result(forces.rows(), forces.cols());
  result.row(0) = compliance[0](e, f).real() * forces.row(0);
  for (std::size_t k = 1; k < compliance.size(); ++k) {
    const Index a = 2 * static_cast<Index>(k) - 1, b = a + 1;
    const std::complex<double> g = compliance[k](e, f);
    result.row(a) = g.real() * forces.row(a) + g.imag() * forces.row(b);
    result.row(b) = g.real() * forces.row(b) - g.imag() * forces.row(a);
  }
  return result;
}

// dF/dx = 1 + G df/dy
Matrix derivative(const HarmonicEquations &at, const std::vector<ForceSeries> &forces,
                  Index coefficients) {
  const auto m = static_cast<Index>(forces.size());
  const std::vector<ComplexMatrix> compliance = compliances(at, harmonics_of(coefficients));
  Matrix result = Matrix::Identity(m * coefficients, m * coefficients);
  for (Index f = 0; f < m; ++f) {
    const Matrix &slope = forces[static_cast<std::size_t>(f)].by_displacement;
    for (Index e = 0; e < m; ++e)
      result(Eigen::seqN(e, coefficients, m), Eigen::seqN(f, coefficients, m)) +=
          yielding(compliance, e, f, slope);
  }
  return result;
}

} // namespace

HarmonicBalance::HarmonicBalance(HarmonicSystem &system, Index harmonics, Vector size,
                                 double key_size)
    : system_{system}, harmonics_{harmonics}, size_{std::move(size)}, key_size_{key_size} {}

Vector HarmonicBalance::scales() const {
  Vector scales(size_.size() * coefficients() + 1);
  scales << size_.replicate(coefficients(), 1), key_size_;
  return scales;
}

Matrix HarmonicBalance::series(const Vector &state) const {
  return Eigen::Map<const Matrix>(state.data(), size_.size(), coefficients());
}

Evaluation HarmonicBalance::evaluate(const Point &point) {
  const double key = point.keys(0);
  Evaluation result;
  result.residual = residual(point.state, key, &result.by_state);
  result.by_keys = key_derivative(point.state, key, result.residual);
  return result;
}

// Where there is no system on one side of the key, such as at a clearance below zero, by three
// values on the other.
Vector HarmonicBalance::key_derivative(const Vector &state, double key, const Vector &here) {
  const double step = 1e-6 * key_size_;
  const auto at = [&](double place) { return residual(state, key + place * step, nullptr); };
  const auto one_sided = [&](double side) {
    return Vector(side * (4 * at(side) - 3 * here - at(2 * side)) / (2 * step));
  };
  Vector behind;
  try {
    behind = at(-1);
  } catch (const NumericalError &) {
    return one_sided(1);
  }
  try {
    return (at(1) - behind) / (2 * step);
  } catch (const NumericalError &) {
    return one_sided(-1);
  }
}

// Of each coefficient the displacement less that which the forces leave, in its own unit.
Vector HarmonicBalance::residual(const Vector &state, double key, Matrix *by_state) {
  const HarmonicMotion motion = this->motion(state, key, by_state != nullptr);
  const HarmonicEquations equations = system_.equations(key);
  if (by_state)
    *by_state = derivative(equations, motion.forces, coefficients());
  return (motion.elements - equations.rows * motion.coordinates - equations.offset).reshaped();
}

Vector HarmonicBalance::linear_response(double key) {
  const HarmonicEquations at = system_.equations(key);
  return (at.rows * response(at, at.load) + at.offset).reshaped();
}

Vector HarmonicBalance::state_of(const Matrix &coordinates, double key) {
  const HarmonicEquations at = system_.equations(key);
  return (at.rows * coordinates + at.offset).reshaped();
}

HarmonicMotion HarmonicBalance::motion(const Vector &state, double key, bool slopes) {
  const HarmonicEquations at = system_.equations(key);
  HarmonicMotion motion{
      .frequency = at.frequency, .elements = series(state), .coordinates = {}, .forces = {}};
  for (Index e = 0; e < motion.elements.rows(); ++e)
    motion.forces.push_back(system_.force(e, motion.elements.row(e), slopes));
  const Matrix forces = forces_of(motion.forces, coefficients());
  motion.coordinates = response(at, at.load - at.rows.transpose() * forces);
  return motion;
}

LeftOut HarmonicBalance::left_out(const HarmonicMotion &motion, double key) {
  const HarmonicEquations at = system_.equations(key);
  const Index most = 3 * harmonics_;
  const Matrix elements = with_harmonics(motion.elements, most);
  Matrix forces(elements.rows(), elements.cols());
  for (Index e = 0; e < elements.rows(); ++e)
    forces.row(e) = system_.force(e, elements.row(e), false).force;
  // Parseval: the mean square is a_0^2 + sum (a^2 + b^2) / 2.
  const double above = forces.rightCols(forces.cols() - coefficients()).squaredNorm() / 2;
  const double all = forces.col(0).squaredNorm() + forces.rightCols(2 * most).squaredNorm() / 2;
  forces.leftCols(coefficients()).setZero();
  return {.force = all > 0 ? std::sqrt(above / all) : 0,
          .coordinates = response(at, -at.rows.transpose() * forces)};
}

} // namespace vibroimpact::continuation
