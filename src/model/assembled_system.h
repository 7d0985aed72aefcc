// The whole linear system: all bodies with their connections, springs and supports, no contact
// closed.
//
//   M q'' + C q' + K q = f,   G q = 0
//
// M is diagonal; the rows of G are those of sides that are tied together, none by default. With the
// columns of T a basis of what G leaves free, T^T M T = 1 and q = T p,
//
//   p'' + T^T C T p' + T^T K T p = T^T f
//
// Its undamped modes are T times the eigenvectors of the symmetric part of T^T K T. Where T^T C T
// is not diagonal in them, or circulatory forces make K unsymmetric, the damped motions have
// complex shapes: eigenvectors of the state [p, p'].
#pragma once

#include "common/linear_algebra.h"
#include "model/model.h"

#include <string>
#include <vector>

namespace vibroimpact::model {

class AssembledSystem {
public:
  /// `tied`: G, k x n; dependent rows count once. Throws NumericalError when nothing can move.
  explicit AssembledSystem(const Model &model, const Matrix &tied = {});

  Index size() const { return basis_.cols(); }
  const Matrix &basis() const { return basis_; } ///< T, n x size [kg^-1/2]
  Matrix stiffness() const;                      ///< T^T K T, its symmetric part [1/s^2]

private:
  const Model &model_;
  Matrix basis_;
};

/// Modes by rising frequency; all of modal mass 1 kg.
struct AssembledModes {
  Matrix shapes;      ///< n x m, coordinates per unit of each mode
  Vector stiffness;   ///< m, squared angular frequencies [1/s^2]; 0 of rigid modes
  Matrix damping;     ///< m x m, shapes^T C shapes with gyroscopic terms [1/s]
  Matrix circulatory; ///< m x m, skew, likewise of K [1/s^2]; 0 x 0 without
  Index rigid = 0;    ///< the first of them, which store no energy
  /// No damping, gyroscopic or circulatory force between modes: the shapes are those of the damped
  /// motions too.
  bool modal_damping = true;

  Vector angular_frequency() const { return stiffness.array().max(0.0).sqrt(); } ///< [rad/s]
  /// Of the diagonal of the damping; 0 of rigid modes.
  Vector damping_ratio() const;
};
AssembledModes assembled_modes(const Model &model, const AssembledSystem &system);

/// Damped motions exp(lambda t), by rising |lambda|: one of each pair that vibrates, and those that
/// only decay or stand still.
struct DampedModes {
  ComplexVector eigenvalues; ///< [1/s], imaginary part >= 0
  ComplexMatrix shapes;      ///< n x m, the largest component real and 1
};
/// NumericalError when the eigenvalues do not converge.
DampedModes damped_modes(const AssembledModes &modes);

/// Which points a motion without strain moves most, for messages: "pinion.hub about z and wheel.hub
/// about z". One point for each body that has a hundredth of the kinetic energy or more.
std::string moved_points(const Model &model, const Vector &shape);

/// For the end of a message about what cannot be found where something is free to move: "; no
/// spring holds the whole system against the motion of a.hub about z"; empty where all is held.
std::string unheld_motions(const Model &model);

} // namespace vibroimpact::model
