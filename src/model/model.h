// Equations of motion of all bodies together, as dense data, before any contact:
//
//   diag(mass) q'' + C q' + K q = sum over sources [load s(t) + inertial_load s''(t)]
//
// Coordinates of a body count relative to the base it stands on; a moving base enters through the
// inertial load and carries its points along.
#pragma once

#include "common/linear_algebra.h"
#include "model/time_function.h"
#include "reduction/reduced_body.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact {

/// A symmetric matrix, diagonal where the bodies are modal and uncoupled.
struct LinearForm {
  Vector diagonal;
  Matrix coupling; ///< off-diagonal part; 0 x 0 when there is none

  /// y = A x
  void apply(ConstVectorView x, Vector &y) const;
  Matrix dense() const;
};

/// One time history that acts on the model.
struct Source {
  std::string name;
  std::shared_ptr<const TimeFunction> function;
  Vector load;          ///< n: multiplies s(t)
  Vector inertial_load; ///< n: multiplies s''(t)
};

/// A linear observation of the motion: row . q + sum over sources carrier_k s_k(t). With carrier it
/// is absolute, without it relative to the base.
struct Projection {
  RowVector row;               ///< n
  std::vector<double> carrier; ///< one entry per source
};

/// A point of a body in the model.
struct PointReference {
  std::size_t body = 0;
  std::size_t point = 0;
};

class Model {
public:
  /// Sources are added afterwards.
  explicit Model(std::vector<std::shared_ptr<const ReducedBody>> bodies);

  /// The base of `bodies` (indices) moves by s(t) along `direction` (unit vector).
  void add_base_motion(const std::string &name, std::shared_ptr<const TimeFunction> function,
                       const std::vector<std::size_t> &bodies, const Vector3 &direction);
  /// The force s(t) [N] acts at a point along `direction` (unit vector).
  void add_force(const std::string &name, std::shared_ptr<const TimeFunction> function,
                 const PointReference &at, const Vector3 &direction);
  /// The bodies have weight: the acceleration field s(t) [m/s^2] along `direction` (unit vector).
  void add_gravity(const std::string &name, std::shared_ptr<const TimeFunction> function,
                   const std::vector<std::size_t> &bodies, const Vector3 &direction);

  /// The model at another excitation frequency. std::logic_error when the source has none.
  void set_frequency(std::size_t source, double angular_frequency);

  Index size() const { return mass_.size(); }
  const std::vector<std::shared_ptr<const ReducedBody>> &bodies() const { return bodies_; }
  /// First coordinate of a body.
  Index offset(std::size_t body) const { return offsets_[body]; }
  const Vector &mass() const { return mass_; }
  const LinearForm &stiffness() const { return stiffness_; }
  const LinearForm &damping() const { return damping_; }
  const std::vector<Source> &sources() const { return sources_; }

  /// f(t), n entries.
  void load(double time, Vector &f) const;

  /// Index of a body or of a source by name; size of the list when there is none.
  std::size_t find_body(const std::string &name) const;
  std::size_t find_source(const std::string &name) const;
  /// Resolves "body.point". Returns false when there is no such point.
  bool find_point(const std::string &name, PointReference &reference) const;
  /// "body.point" of every point, for messages.
  std::vector<std::string> point_names() const;
  std::string point_name(const PointReference &reference) const;

  /// Displacement of a point along `direction`, absolute (with the base) or relative to the base.
  Projection displacement(const PointReference &point, const Vector3 &direction,
                          bool absolute) const;

  /// Base displacement of a body at a time: 3 components [m].
  Vector3 base_displacement(std::size_t body, double time) const;

  /// Highest natural angular frequency of the uncoupled coordinates and the sources [rad/s].
  double highest_frequency() const;

  /// First instant > time [s] at which a source is not smooth; +infinity when there is none.
  double next_break(double time) const;

private:
  std::vector<std::shared_ptr<const ReducedBody>> bodies_;
  std::vector<Index> offsets_;
  Vector mass_;
  LinearForm stiffness_;
  LinearForm damping_;
  std::vector<Source> sources_;
  std::vector<std::vector<Vector3>> carried_; ///< per source, per body: base direction or zero
};

} // namespace vibroimpact
