// Equations of motion of all bodies together, as dense data, before any contact:
//
//   diag(mass) q'' + C q' + K q = sum over sources [load s + rate_load s' + inertial_load s'']
//                                 - forces of cubic springs + H^T R of rotors
//
// Coordinates of a body count relative to the base it stands on; a moving base enters through the
// inertial load and carries its points along. Connections add to K and C, and where one end moves
// with a base to the loads. Motors of rotors bring first-order states of their own, `drive`. Bodies
// that turn at a constant speed add gyroscopic terms to C, which is then not symmetric, and
// circulatory ones to K where their damping turns with them; along a ramp of the speed these are
// forces that change in time. Bearings whose coefficients join two directions do so likewise.
#pragma once

#include "common/linear_algebra.h"
#include "model/motion_axis.h"
#include "model/projection.h"
#include "model/rotor.h"
#include "model/spin.h"
#include "model/time_function.h"
#include "reduction/reduced_body.h"

#include <array>
#include <concepts>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::model {

/// A matrix, diagonal where the bodies are modal and uncoupled.
struct LinearForm {
  Vector diagonal;
  Matrix coupling; ///< off-diagonal part; 0 x 0 when there is none

  /// y = A x. Called for every stage of every step, where beginning a general product costs more
  /// than a small one itself.
  void apply(ConstVectorView x, Vector &y) const {
    constexpr Index small = 8;
    const Index n = diagonal.size();
    if (n >= small) {
      apply_to_many(x, y);
      return;
    }
    y.resize(n);
    const double *entry = coupling.data();
    for (Index i = 0; i < n; ++i)
      y[i] = diagonal[i] * x[i];
    for (Index j = 0; j < coupling.cols(); ++j, entry += n)
      for (Index i = 0; i < n; ++i)
        y[i] += entry[i] * x[j];
  }
  /// A += factor row^T row
  void add(double factor, const RowVector &row);
  void add(const Matrix &matrix);
  Matrix dense() const;

private:
  void apply_to_many(ConstVectorView x, Vector &y) const;
};

/// One time history that acts on the model.
struct Source {
  std::string name;
  std::shared_ptr<const TimeFunction> function;
  Vector load;          ///< n: multiplies s(t)
  Vector rate_load;     ///< n: multiplies s'(t); only dashpots to a moving base have one
  Vector inertial_load; ///< n: multiplies s''(t)
};

/// A spring and a dashpot along a direction; tension k e + k3 e^3 + c e' pulls the ends together.
/// Or about a direction: e is then a relative rotation, the tension a torque.
struct Connection {
  std::string name;
  std::string side_a, side_b; ///< "body.point"; side_b may be "base" or "ground"
  Projection elongation;      ///< (u_b - u_a) . n [m], of rotations [rad]
  double stiffness = 0;       ///< k [N/m], of rotations [N m/rad]
  double cubic_stiffness = 0; ///< k3 [N/m^3]; none of rotations
  double damping = 0;         ///< c [N s/m], of rotations [N m s/rad]
  bool rotation = false;

  double tension(double elongation_now, double rate) const {
    return stiffness * elongation_now +
           cubic_stiffness * elongation_now * elongation_now * elongation_now + damping * rate;
  }
};

/// Springs and dashpots along two directions at right angles, which they join: with e = u_b - u_a
/// along both, the force K e + C e' pulls the ends together.
struct Bearing {
  std::string name;
  std::string side_a, side_b; ///< as of a connection
  std::array<Projection, 2> elongation;
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero(); ///< K, need not be symmetric [N/m]
  Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();   ///< C, likewise [N s/m]

  Matrix rows() const; ///< 2 x n
};

/// A dashpot on a mode of the whole system: the force c p' acts against the coordinate p of the
/// mode, of modal mass 1 kg, less what bases that move bring about at rest.
struct ModalDashpot {
  Projection coordinate; ///< p [m kg^1/2]
  double damping = 0;    ///< c [1/s], twice the damping ratio times the angular frequency
};

/// A point of a body in the model.
struct PointReference {
  std::size_t body = 0;
  std::size_t point = 0;
};

class Model {
public:
  /// Sources are added afterwards.
  explicit Model(std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies);

  /// The base of `bodies` (indices) moves by s(t) along `direction` (unit vector).
  void add_base_motion(const std::string &name, std::shared_ptr<const TimeFunction> function,
                       const std::vector<std::size_t> &bodies, const Vector3 &direction);
  /// The field s(t) [m/s^2] pulls at all masses of `bodies` along `direction` (unit vector).
  void add_gravity(const std::string &name, std::shared_ptr<const TimeFunction> function,
                   const std::vector<std::size_t> &bodies, const Vector3 &direction);
  /// The force s(t) [N] acts at a point along an axis, or the torque s(t) [N m] about it.
  void add_force(const std::string &name, std::shared_ptr<const TimeFunction> function,
                 const PointReference &at, const MotionAxis &axis);

  /// The unbalance [kg m] at a point of a body with a Spin axis turns with its spin: from `phase`
  /// [rad] at time zero, counted from `first`, a unit vector across the axis. Two sources, the
  /// second of them at right angles.
  void add_unbalance(const std::string &name, double unbalance, const SpinSpeed &speed,
                     const PointReference &at, const Vector3 &first, double phase);

  /// Sources must be complete before connections and rotors are added.
  void add_connection(Connection connection);
  void add_bearing(Bearing bearing);
  void add_modal_dashpot(ModalDashpot dashpot);
  /// Its bodies have a Spin axis; those in the rotating frame need a constant speed. Before
  /// connections, for centrifugal forces are a source.
  void add_spin(const Spin &spin);
  /// Fills the rotor's projections: it turns about `at` in the plane of two unit vectors.
  void add_rotor(Rotor rotor, const PointReference &at, const Vector3 &first,
                 const Vector3 &second);

  /// The model at another excitation frequency. std::logic_error when the source has none.
  void set_frequency(std::size_t source, double angular_frequency);
  /// This share of the damping of bodies, connections and bearings is left, and a force pushes each
  /// mass by `self_excitation` times its momentum [1/s]: C becomes share C - self_excitation M, in
  /// the bodies too.
  void change_damping(double share, double self_excitation);

  Index size() const { return mass_.size(); }
  const std::vector<std::shared_ptr<const reduction::ReducedBody>> &bodies() const {
    return bodies_;
  }
  /// First coordinate of a body.
  Index offset(std::size_t body) const { return offsets_[body]; }
  const Vector &mass() const { return mass_; }
  /// Symmetric but for circulatory().
  const LinearForm &stiffness() const { return stiffness_; }
  /// The skew part of the stiffness, n x n; 0 x 0 without circulatory forces. They have no energy
  /// and do work: what turns the shaft puts it in.
  const Matrix &circulatory() const { return circulatory_; }
  /// Also along a run-up?
  bool has_circulatory_forces() const;
  /// Their power -v . circulatory q [W].
  double circulatory_power(ConstVectorView q, ConstVectorView velocity) const;
  /// Symmetric but for the gyroscopic terms of constant speeds, which do no work.
  const LinearForm &damping() const { return damping_; }
  const std::vector<Source> &sources() const { return sources_; }
  const std::vector<Connection> &connections() const { return connections_; }
  const std::vector<Bearing> &bearings() const { return bearings_; }
  const std::vector<ModalDashpot> &modal_dashpots() const { return modal_dashpots_; }
  const RotorSet &rotors() const { return rotors_; }
  /// First-order states of the motors [N m].
  Index n_drive() const { return rotors_.n_drive(); }
  /// True when the equations of motion without contacts are linear.
  bool linear() const { return cubic_.empty() && rotors_.empty() && run_ups_.empty(); }
  const std::vector<Spin> &spins() const { return spins_; }
  /// What multiplies the speed of a spin: n x n, skew, of velocities and of displacements; and its
  /// square: symmetric.
  Matrix gyroscopic(std::size_t spin) const;
  Matrix circulation(std::size_t spin) const;
  Matrix centrifugal(std::size_t spin) const;

  /// f(t), n entries.
  void load(double time, Vector &f) const;
  /// Likewise, from s, s', s'' of the sources: source(index, derivative).
  template <std::invocable<std::size_t, std::size_t> Values>
  void load(const Values &source, Vector &f) const {
    f.resize(size());
    for (Index i = 0; i < f.size(); ++i)
      f[i] = 0;
    for (const Drive &drive : drives_) {
      const Vector &load = sources_[drive.source].*drive.load;
      const double factor = source(drive.source, drive.derivative);
      for (Index i = 0; i < f.size(); ++i)
        f[i] += factor * load[i];
    }
  }

  /// Of the sources that do not vary in time, and the weight of rotors on the points that carry
  /// them: n entries.
  Vector static_load() const;

  /// Value of a projection and its rate at a state.
  double value(const Projection &projection, double time, ConstVectorView q) const;
  double rate(const Projection &projection, double time, ConstVectorView velocity) const;

  /// f -= forces of the cubic parts of the connections. Returns the power that moving bases put
  /// into them [W].
  double add_cubic_forces(double time, ConstVectorView q, VectorView f) const;
  /// Their derivative: stiffness += 3 k3 e^2 row^T row, n x n.
  void add_cubic_stiffness(double time, ConstVectorView q, Matrix &stiffness) const;
  /// Energy stored in them [J].
  double cubic_energy(double time, ConstVectorView q) const;

  /// f -= gyroscopic and circulatory forces at the speeds of run-ups. Returns the power of the
  /// latter [W].
  double add_run_up_forces(double time, ConstVectorView q, ConstVectorView velocity,
                           VectorView f) const;
  /// Their derivatives: stiffness += Omega(t) N, damping += Omega(t) G, n x n.
  void add_run_up_stiffness(double time, Matrix &stiffness) const;
  void add_run_up_damping(double time, Matrix &damping) const;

  /// Index of a body or of a source by name; size of the list when there is none.
  std::size_t find_body(const std::string &name) const;
  std::size_t find_source(const std::string &name) const;
  /// Resolves "body.point". Returns false when there is no such point.
  bool find_point(const std::string &name, PointReference &reference) const;
  /// "body.point" of every point, for messages.
  std::vector<std::string> point_names() const;
  std::string point_name(const PointReference &reference) const;

  /// Displacement of a point along an axis, absolute (with the base) or relative to the base; or
  /// its rotation about the axis, for no base turns.
  Projection displacement(const PointReference &point, const MotionAxis &axis, bool absolute) const;

  /// Does the source move the base of a body, or an end of a connection?
  bool moves_base(std::size_t source) const;
  /// Base displacement of a body at a time: 3 components [m].
  Vector3 base_displacement(std::size_t body, double time) const;
  /// Its rate [m/s].
  Vector3 base_velocity(std::size_t body, double time) const;

  /// Acceleration of the base less gravity at each rotor's point, along its two directions: 2 per
  /// rotor [m/s^2].
  void rotor_frame(double time, Vector &frame) const;

  /// Highest natural angular frequency of the uncoupled coordinates and the sources [rad/s].
  double highest_frequency() const;

  /// First instant > time [s] at which a source is not smooth; +infinity when there is none.
  double next_break(double time) const;

private:
  /// A source and one of its loads that is not zero. The displacement of a moving base is no load,
  /// and may be expensive to find.
  struct Drive {
    std::size_t source = 0;
    Vector Source::*load = nullptr;
    std::size_t derivative = 0; ///< of s, that multiplies it
  };
  void list_drives();
  void add_body_damping();
  void add_dashpot(double damping, const Projection &elongation);
  void add_load(const std::string &name, std::shared_ptr<const TimeFunction> function,
                const Vector &load);
  struct RunUp {
    SpinSpeed speed;
    Matrix gyroscopic;
    Matrix circulatory; ///< 0 x 0 without internal damping
  };
  void add_circulatory(const Matrix &skew);

  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies_;
  std::vector<Index> offsets_;
  Vector mass_;
  LinearForm stiffness_;
  LinearForm damping_;
  std::vector<Source> sources_;
  std::vector<Drive> drives_;
  std::vector<Connection> connections_;
  std::vector<std::size_t> cubic_; ///< connections with a cubic part
  std::vector<ModalDashpot> modal_dashpots_;
  RotorSet rotors_;
  std::vector<Spin> spins_;
  std::vector<RunUp> run_ups_;                ///< of the spins whose speed changes
  std::vector<std::vector<Vector3>> carried_; ///< per source, per body: base direction or zero
  std::vector<std::vector<Vector3>> field_;   ///< per source, per body: gravity direction or zero
  std::vector<Bearing> bearings_;
  Matrix circulatory_; ///< contained in the stiffness; 0 x 0 without
};

} // namespace vibroimpact::model
