#include "model/whirl.h"

#include "common/decompositions.h"

namespace vibroimpact::model {

namespace {

/// Sums over the bodies that turn, of a shape.
struct Whirl {
  double turning = 0;
  double size = 0;
};

Whirl whirl_of(const Model &model, const Spin &spin, const ComplexVector &shape) {
  Whirl sum;
  const double sign = spin.speed.at(0) < 0 ? -1 : 1;
  for (const std::size_t b : spin.bodies) {
    const reduction::SpinMatrices &matrices = model.bodies()[b]->spin;
    const ComplexVector own = shape.segment(model.offset(b), model.bodies()[b]->size());
    // u = Re(shape exp(i w t)) has the mean of u'. (a x u) = w / 2 Im(shape^H W shape).
    const ComplexVector turned = matrices.turning.cast<std::complex<double>>() * own;
    const ComplexVector across = matrices.crosswise.cast<std::complex<double>>() * own;
    sum.turning += sign * own.dot(turned).imag();
    sum.size += own.dot(across).real();
  }
  return sum;
}

} // namespace

Vector whirl_numbers(const Model &model, const ComplexMatrix &shapes) {
  constexpr double rounding = 1e-12; // of the kinetic energy, that still is a motion across
  Vector numbers = Vector::Zero(shapes.cols());
  for (Index j = 0; j < shapes.cols(); ++j) {
    const ComplexVector shape = shapes.col(j);
    Whirl sum;
    for (const Spin &spin : model.spins()) {
      const Whirl own = whirl_of(model, spin, shape);
      sum.turning += own.turning;
      sum.size += own.size;
    }
    const double whole = model.mass().dot(shape.cwiseAbs2());
    if (sum.size > rounding * whole)
      numbers[j] = sum.turning / sum.size;
  }
  return numbers;
}

WhirlingSystem::WhirlingSystem(const Model &model, const AssembledSystem &system, std::size_t spin)
    : model_(model), modes_(assembled_modes(model, system)) {
  const Matrix matrix = modes_.shapes.transpose() * model.gyroscopic(spin) * modes_.shapes;
  gyroscopic_ = (matrix - matrix.transpose()) / 2;
  if (const Matrix circulation = model.circulation(spin); !circulation.isZero(0)) {
    const Matrix projected = modes_.shapes.transpose() * circulation * modes_.shapes;
    circulatory_ = (projected - projected.transpose()) / 2;
    if (modes_.circulatory.size() == 0)
      modes_.circulatory = Matrix::Zero(circulatory_.rows(), circulatory_.cols());
  }
  if (const Matrix stiffness = model.centrifugal(spin); !stiffness.isZero(0))
    centrifugal_ = modes_.shapes.transpose() * stiffness * modes_.shapes;
  if (const SpinSpeed &speed = model.spins()[spin].speed; speed.constant())
    speed_ = speed.at(0);
}

DampedModes WhirlingSystem::at(double speed) const {
  AssembledModes modes = modes_;
  modes.damping += (speed - speed_) * gyroscopic_;
  if (circulatory_.size() > 0)
    modes.circulatory += (speed - speed_) * circulatory_;
  if (centrifugal_.size() > 0) {
    const Matrix stiffness =
        Matrix(modes.stiffness.asDiagonal()) + (speed * speed - speed_ * speed_) * centrifugal_;
    const SymmetricEigen eigen = symmetric_eigen(stiffness);
    modes.stiffness = eigen.values;
    modes.shapes *= eigen.vectors;
    modes.damping = (eigen.vectors.transpose() * modes.damping * eigen.vectors).eval();
    if (modes.circulatory.size() > 0)
      modes.circulatory = (eigen.vectors.transpose() * modes.circulatory * eigen.vectors).eval();
  }
  return damped_modes(modes);
}

} // namespace vibroimpact::model
