// Unbalanced rotors that turn at a point of a body, each with a motor of limited power.
//
// The centre of mass of rotor i stands at the point's displacement plus e (n cos phi, sin phi) in
// the plane of the directions d1, d2; phi is the coordinate of the rotor's own body, counted from
// d1 towards d2. With the velocity of the centre H(phi) v, H two rows per rotor, the coupled
// equations
//
//   (D + H^T m H) q'' = F + H^T m (e phi'^2 (cos phi, sin phi) - frame)
//
// (D diagonal mass without the rotors' masses, F all other forces, frame the acceleration of the
// base less gravity) are solved by eliminating the force R that the centre of mass exerts, so that
// D stays as it is:
//
//   (1/m + H D^-1 H^T) R = -(H D^-1 F + frame - e phi'^2 (cos phi, sin phi)),  q'' = D^-1 (F + H^T
//   R)
//
// The torque M of a motor is a state of its own, tau M' + M = M_Z - k_M phi' (Lampart & Zapomel
// 2014): M_Z starting torque [N m], k_M slope of the characteristic [N m s/rad], tau
// electromagnetic time constant [s]; its current is M / k_p.
#pragma once

#include "model/projection.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::model {

struct Motor {
  double starting_torque = 0; ///< M_Z [N m]
  double slope = 0;           ///< k_M > 0 [N m s/rad]
  double time_constant = 0;   ///< tau > 0 [s]
  double torque_constant = 1; ///< k_p [N m/A]
  double initial_torque = 0;  ///< [N m]
  Index drive = 0;            ///< its torque among the drive states
  double torque_rate(double torque, double speed) const {
    return (starting_torque - slope * speed - torque) / time_constant;
  }
};

struct Rotor {
  std::string name;         ///< of its body
  std::string at;           ///< "body.point" that carries it
  Index angle = 0;          ///< its coordinate [rad]
  double mass = 0;          ///< m > 0 [kg], all of it at the centre of mass
  double eccentricity = 0;  ///< e >= 0 [m]
  double initial_angle = 0; ///< [rad]
  double initial_speed = 0; ///< [rad/s]
  Projection first, second; ///< absolute displacement of the point along d1, d2
  std::vector<double> field_first, field_second; ///< gravity along d1, d2 per unit of each source
  std::optional<Motor> motor{};
};

class RotorSet {
public:
  /// Numbers the motor's state.
  void add(Rotor rotor);

  bool empty() const { return rotors_.empty(); }
  const std::vector<Rotor> &list() const { return rotors_; }
  Index n_drive() const { return n_drive_; }
  Vector initial_drive() const;
  /// Largest no-load speed of the motors and initial speed [rad/s]; 0 without rotors.
  double highest_frequency() const;

  /// f += torques of the motors.
  void add_torques(ConstVectorView drive, VectorView f) const;
  /// M' of all motors.
  void drive_rates(ConstVectorView velocity, ConstVectorView drive, VectorView rates) const;

  /// Turns D^-1 F into q''. `mass`: D; `frame`: 2 per rotor, see frame() of the model.
  void couple(const Vector &mass, ConstVectorView q, ConstVectorView velocity, const Vector &frame,
              VectorView acceleration) const;
  /// The same for the Jacobian: rows D^-1 dF/d(q, v, ...) become dq''/d(...). `columns` holds the
  /// derivatives by q in its first n columns and by v in the next n.
  void couple_jacobian(const Vector &mass, ConstVectorView q, ConstVectorView velocity,
                       const Vector &frame, const Vector &uncoupled_acceleration,
                       Eigen::Ref<Matrix> columns) const;

  /// Of the rotors' masses [J].
  double kinetic_energy(ConstVectorView q, ConstVectorView velocity) const;
  /// Work per time done by motors, moving bases and gravity [W].
  double input_power(ConstVectorView q, ConstVectorView velocity, ConstVectorView drive,
                     const Vector &frame) const;

private:
  struct Turn {
    double angle = std::numeric_limits<double>::quiet_NaN();
    double sine = 0, cosine = 0;
  };
  const Turn &turn(std::size_t rotor, ConstVectorView q) const;
  void fill_centre_rows(ConstVectorView q, Matrix &rows) const;
  Matrix centre_rows(ConstVectorView q) const;
  Vector curvature(ConstVectorView q, ConstVectorView velocity) const;
  Matrix schur(const Vector &mass, const Matrix &rows) const;

  std::vector<Rotor> rotors_;
  Index n_drive_ = 0;

  /// Scratch of couple(), which runs in every evaluation of the equations.
  struct Scratch {
    Matrix rows, weighted, schur; ///< H, H D^-1, 1/m + H D^-1 H^T
    Vector reaction;
    std::vector<Turn> turns; ///< of each rotor, where it was asked last
  };
  mutable Scratch scratch_;
};

} // namespace vibroimpact::model
