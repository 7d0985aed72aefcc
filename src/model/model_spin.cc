// What turns, and bearings: gyroscopic, circulatory and centrifugal matrices of a model.
#include "model/model.h"

#include "model/piecewise_function.h"
#include "model/turning_component.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <tuple>

namespace vibroimpact::model {

namespace {

Matrix skew_part(const Matrix &matrix) { return (matrix - matrix.transpose()) / 2; }

// What the bodies of a spin have of a matrix; 0 x 0 for those without.
template <class Of> Matrix blocks_of(const Model &model, const Spin &spin, const Of &of) {
  Matrix matrix = Matrix::Zero(model.size(), model.size());
  for (const std::size_t b : spin.bodies)
    if (const Matrix block = of(*model.bodies()[b]); block.size() > 0)
      matrix.block(model.offset(b), model.offset(b), block.rows(), block.cols()) = block;
  return matrix;
}

} // namespace

Matrix Bearing::rows() const {
  Matrix both(2, elongation[0].row.size());
  both << elongation[0].row, elongation[1].row;
  return both;
}

void Model::add_bearing(Bearing bearing) {
  const Matrix rows = bearing.rows();
  const Matrix stiffness = rows.transpose() * bearing.stiffness * rows;
  stiffness_.add(stiffness - skew_part(stiffness));
  add_circulatory(skew_part(stiffness));
  damping_.add(rows.transpose() * bearing.damping * rows);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Eigen::Vector2d base(bearing.elongation[0].base_coefficients[k],
                               bearing.elongation[1].base_coefficients[k]);
    sources_[k].load -= rows.transpose() * (bearing.stiffness * base);
    sources_[k].rate_load -= rows.transpose() * (bearing.damping * base);
  }
  list_drives();
  bearings_.push_back(std::move(bearing));
}

// Into the stiffness and beside it.
void Model::add_circulatory(const Matrix &skew) {
  if (skew.isZero(0))
    return;
  stiffness_.add(skew);
  if (circulatory_.size() == 0)
    circulatory_ = Matrix::Zero(size(), size());
  circulatory_ += skew;
  if (circulatory_.isZero(0))
    circulatory_.resize(0, 0);
}

bool Model::has_circulatory_forces() const {
  return circulatory_.size() > 0 ||
         std::any_of(run_ups_.begin(), run_ups_.end(),
                     [](const RunUp &run_up) { return run_up.circulatory.size() > 0; });
}

double Model::circulatory_power(ConstVectorView q, ConstVectorView velocity) const {
  return circulatory_.size() > 0 ? -velocity.dot(circulatory_ * q) : 0;
}

void Model::add_unbalance(const std::string &name, double unbalance, const SpinSpeed &speed,
                          const PointReference &at, const Vector3 &first, double phase) {
  const Vector3 second = bodies_.at(at.body)->spin.axis.cross(first);
  constexpr double quarter = std::numbers::pi / 2; // sin x = cos(x - pi/2)
  for (const auto &[suffix, along, lag] :
       {std::tuple{"", first, 0.0}, std::tuple{" across", second, quarter}}) {
    sources_.push_back(
        {.name = name + suffix,
         .function = std::make_shared<TurningComponent>(speed, phase - lag),
         .load = Vector::Zero(size()),
         .rate_load = Vector::Zero(size()),
         .inertial_load = -unbalance * displacement(at, along, false).row.transpose()});
    carried_.emplace_back(bodies_.size(), Vector3::Zero());
    field_.emplace_back(bodies_.size(), Vector3::Zero());
  }
  list_drives();
}

Matrix Model::gyroscopic(std::size_t spin) const {
  return blocks_of(*this, spins_[spin],
                   [](const reduction::ReducedBody &body) { return body.spin.gyroscopic; });
}

Matrix Model::circulation(std::size_t spin) const {
  return blocks_of(*this, spins_[spin],
                   [](const reduction::ReducedBody &body) { return body.spin.circulatory; });
}

Matrix Model::centrifugal(std::size_t spin) const {
  return blocks_of(*this, spins_[spin], [](const reduction::ReducedBody &body) {
    return body.spin.rotating_frame ? body.spin.centrifugal : Matrix();
  });
}

void Model::add_spin(const Spin &spin) {
  spins_.push_back(spin);
  const Matrix matrix = gyroscopic(spins_.size() - 1);
  const Matrix circulatory = circulation(spins_.size() - 1);
  if (!spin.speed.constant()) {
    run_ups_.push_back({.speed = spin.speed,
                        .gyroscopic = matrix,
                        .circulatory = circulatory.isZero(0) ? Matrix() : circulatory});
    return;
  }
  const double speed = spin.speed.at(0);
  damping_.add(speed * matrix);
  add_circulatory(speed * circulatory);
  stiffness_.add(speed * speed * centrifugal(spins_.size() - 1));
  Vector load = Vector::Zero(size());
  for (const std::size_t b : spin.bodies)
    if (bodies_[b]->spin.rotating_frame)
      load.segment(offsets_[b], bodies_[b]->size()) = bodies_[b]->spin.centrifugal_load;
  if (!load.isZero(0))
    add_load(spin.name, make_constant(Given::displacement, speed * speed), load);
}

double Model::add_run_up_forces(double time, ConstVectorView q, ConstVectorView velocity,
                                VectorView f) const {
  double power = 0;
  for (const RunUp &run_up : run_ups_) {
    f -= run_up.speed.at(time) * (run_up.gyroscopic * velocity);
    if (run_up.circulatory.size() == 0)
      continue;
    const Vector force = run_up.speed.at(time) * (run_up.circulatory * q);
    f -= force;
    power -= force.dot(velocity);
  }
  return power;
}

void Model::add_run_up_stiffness(double time, Matrix &stiffness) const {
  for (const RunUp &run_up : run_ups_)
    if (run_up.circulatory.size() > 0)
      stiffness += run_up.speed.at(time) * run_up.circulatory;
}

void Model::add_run_up_damping(double time, Matrix &damping) const {
  for (const RunUp &run_up : run_ups_)
    damping += run_up.speed.at(time) * run_up.gyroscopic;
}

} // namespace vibroimpact::model
