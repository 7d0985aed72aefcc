#include "model/rotor.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace vibroimpact::model {

namespace {

// Cholesky's decomposition of a positive definite matrix, of which the lower half is given, and the
// two solutions. For a few numbers; general routines take longer to set up than to compute.
void solve_in_place(Matrix &matrix, Vector &x) {
  const Index n = x.size();
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j <= i; ++j) {
      double sum = matrix(i, j);
      for (Index k = 0; k < j; ++k)
        sum -= matrix(i, k) * matrix(j, k);
      matrix(i, j) = i == j ? std::sqrt(sum) : sum / matrix(j, j);
    }
    for (Index k = 0; k < i; ++k)
      x[i] -= matrix(i, k) * x[k];
    x[i] /= matrix(i, i);
  }
  for (Index i = n; i-- > 0;) {
    for (Index k = i + 1; k < n; ++k)
      x[i] -= matrix(k, i) * x[k];
    x[i] /= matrix(i, i);
  }
}

} // namespace

void RotorSet::add(Rotor rotor) {
  if (rotor.motor)
    rotor.motor->drive = n_drive_++;
  rotors_.push_back(std::move(rotor));
}

Vector RotorSet::initial_drive() const {
  Vector drive(n_drive_);
  for (const Rotor &rotor : rotors_)
    if (rotor.motor)
      drive[rotor.motor->drive] = rotor.motor->initial_torque;
  return drive;
}

double RotorSet::highest_frequency() const {
  double highest = 0;
  for (const Rotor &rotor : rotors_) {
    highest = std::max(highest, std::abs(rotor.initial_speed));
    if (rotor.motor)
      highest = std::max({highest, std::abs(rotor.motor->starting_torque / rotor.motor->slope),
                          1 / rotor.motor->time_constant});
  }
  return highest;
}

void RotorSet::add_torques(ConstVectorView drive, VectorView f) const {
  for (const Rotor &rotor : rotors_)
    if (rotor.motor)
      f[rotor.angle] += drive[rotor.motor->drive];
}

void RotorSet::drive_rates(ConstVectorView velocity, ConstVectorView drive,
                           VectorView rates) const {
  for (const Rotor &rotor : rotors_)
    if (rotor.motor)
      rates[rotor.motor->drive] =
          rotor.motor->torque_rate(drive[rotor.motor->drive], velocity[rotor.angle]);
}

// H: velocity of the centres of mass = H v.
Matrix RotorSet::centre_rows(ConstVectorView q) const {
  Matrix rows;
  fill_centre_rows(q, rows);
  return rows;
}

const RotorSet::Turn &RotorSet::turn(std::size_t rotor, ConstVectorView q) const {
  scratch_.turns.resize(rotors_.size());
  Turn &known = scratch_.turns[rotor];
  const double angle = q[rotors_[rotor].angle];
  if (angle != known.angle)
    known = {.angle = angle, .sine = std::sin(angle), .cosine = std::cos(angle)};
  return known;
}

void RotorSet::fill_centre_rows(ConstVectorView q, Matrix &rows) const {
  rows.resize(2 * static_cast<Index>(rotors_.size()), q.size());
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor &rotor = rotors_[i];
    const auto first = 2 * static_cast<Index>(i);
    rows.row(first) = rotor.first.row;
    rows.row(first + 1) = rotor.second.row;
    const Turn &now = turn(i, q);
    rows(first, rotor.angle) -= rotor.eccentricity * now.sine;
    rows(first + 1, rotor.angle) += rotor.eccentricity * now.cosine;
  }
}

// H' v = -e phi'^2 (cos phi, sin phi)
Vector RotorSet::curvature(ConstVectorView q, ConstVectorView velocity) const {
  Vector values(2 * static_cast<Index>(rotors_.size()));
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor &rotor = rotors_[i];
    const double speed = velocity[rotor.angle];
    const auto first = 2 * static_cast<Index>(i);
    values[first] = -rotor.eccentricity * speed * speed * std::cos(q[rotor.angle]);
    values[first + 1] = -rotor.eccentricity * speed * speed * std::sin(q[rotor.angle]);
  }
  return values;
}

// 1/m + H D^-1 H^T
Matrix RotorSet::schur(const Vector &mass, const Matrix &rows) const {
  Matrix matrix = rows * mass.cwiseInverse().asDiagonal() * rows.transpose();
  for (std::size_t i = 0; i < rotors_.size(); ++i)
    matrix.diagonal().segment(2 * static_cast<Index>(i), 2).array() += 1 / rotors_[i].mass;
  return matrix;
}

void RotorSet::couple(const Vector &mass, ConstVectorView q, ConstVectorView velocity,
                      const Vector &frame, VectorView acceleration) const {
  Scratch &s = scratch_;
  fill_centre_rows(q, s.rows);
  const Index count = s.rows.rows();
  s.weighted.resize(count, s.rows.cols());
  s.schur.setZero(count, count);
  s.reaction.resize(count);
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor &rotor = rotors_[i];
    const auto first = 2 * static_cast<Index>(i);
    const Turn &now = turn(i, q);
    const double outward = rotor.eccentricity * velocity[rotor.angle] * velocity[rotor.angle];
    s.reaction[first] = outward * now.cosine - frame[first];
    s.reaction[first + 1] = outward * now.sine - frame[first + 1];
    s.schur(first, first) = s.schur(first + 1, first + 1) = 1 / rotor.mass;
  }
  for (Index j = 0; j < s.rows.cols(); ++j) {
    const double *row = s.rows.col(j).data();
    double *weighted = s.weighted.col(j).data();
    for (Index a = 0; a < count; ++a) {
      weighted[a] = row[a] / mass[j];
      s.reaction[a] -= row[a] * acceleration[j];
      for (Index b = 0; b <= a; ++b)
        s.schur(a, b) += weighted[a] * row[b];
    }
  }
  solve_in_place(s.schur, s.reaction);
  for (Index j = 0; j < s.rows.cols(); ++j)
    for (Index a = 0; a < count; ++a)
      acceleration[j] += s.weighted(a, j) * s.reaction[a];
}

// With S = 1/m + H D^-1 H^T and R = -S^-1 (H a + c), a = D^-1 F:
//   d(q'') = (I - D^-1 H^T S^-1 H) da + D^-1 dH^T R - D^-1 H^T S^-1 (dH (a + D^-1 H^T R) + H D^-1
//   dH^T R + dc)
// where dH and dc come from the angles and their rates alone.
void RotorSet::couple_jacobian(const Vector &mass, ConstVectorView q, ConstVectorView velocity,
                               const Vector &frame, const Vector &uncoupled_acceleration,
                               Eigen::Ref<Matrix> columns) const {
  const Index n = q.size();
  const Matrix rows = centre_rows(q);
  const Vector inverse_mass = mass.cwiseInverse();
  const Eigen::LDLT<Matrix> factor = schur(mass, rows).ldlt();
  const Vector reaction =
      factor.solve(-(rows * uncoupled_acceleration + frame + curvature(q, velocity)));
  const Vector acceleration =
      uncoupled_acceleration + inverse_mass.cwiseProduct(rows.transpose() * reaction);
  const Matrix back = inverse_mass.asDiagonal() * rows.transpose(); // D^-1 H^T
  columns -= back * factor.solve(rows * columns);
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor &rotor = rotors_[i];
    const auto first = 2 * static_cast<Index>(i);
    const double speed = velocity[rotor.angle];
    const double e = rotor.eccentricity;
    const double cosine = std::cos(q[rotor.angle]);
    const double sine = std::sin(q[rotor.angle]);
    // dH/dphi has the one column -e (cos, sin) at the angle.
    const double moment = -e * (cosine * reaction[first] + sine * reaction[first + 1]);
    const double angular = acceleration[rotor.angle];
    Vector by_angle = rows.col(rotor.angle) * (moment * inverse_mass[rotor.angle]);
    by_angle[first] += -e * cosine * angular + e * speed * speed * sine;
    by_angle[first + 1] += -e * sine * angular - e * speed * speed * cosine;
    columns.col(rotor.angle) -= back * factor.solve(by_angle);
    columns(rotor.angle, rotor.angle) += moment * inverse_mass[rotor.angle];
    Vector by_speed = Vector::Zero(rows.rows());
    by_speed[first] = -2 * e * speed * cosine;
    by_speed[first + 1] = -2 * e * speed * sine;
    columns.col(n + rotor.angle) -= back * factor.solve(by_speed);
  }
}

double RotorSet::kinetic_energy(ConstVectorView q, ConstVectorView velocity) const {
  const Vector centre_velocity = centre_rows(q) * velocity;
  double energy = 0;
  for (std::size_t i = 0; i < rotors_.size(); ++i)
    energy +=
        0.5 * rotors_[i].mass * centre_velocity.segment(2 * static_cast<Index>(i), 2).squaredNorm();
  return energy;
}

double RotorSet::input_power(ConstVectorView q, ConstVectorView velocity, ConstVectorView drive,
                             const Vector &frame) const {
  double power = 0;
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor &rotor = rotors_[i];
    const auto first = 2 * static_cast<Index>(i);
    const double turning = rotor.eccentricity * velocity[rotor.angle];
    const Turn &now = turn(i, q);
    const double along_first = rotor.first.row.dot(velocity) - turning * now.sine;
    const double along_second = rotor.second.row.dot(velocity) + turning * now.cosine;
    power -= rotor.mass * (frame[first] * along_first + frame[first + 1] * along_second);
    if (rotor.motor)
      power += drive[rotor.motor->drive] * velocity[rotor.angle];
  }
  return power;
}

} // namespace vibroimpact::model
