// The variational equation along a motion: how small deviations of the state, and changes of keys,
// grow, through every event.
//
// Between events d' = J(x, t) d (+ df/dp for a key p), in closed form where the phase is linear
// (linear_flow) and integrated beside the state elsewhere (joint_integration). Events map
// deviations by their saltation matrices (saltation). Since flow and events are a product of
// matrices, its determinant is that of the whole: exp(int tr J) times the determinants of the
// events.
//
// A key keeps the time, the phase of the sources at t = 0, and the state at the start as they are.
// Where the period T = 2 pi / omega of a stroboscopic map changes with the key, the derivative of
// the map is that of the state at the fixed time plus f dT/dp, f = dx/dt at the end.
#pragma once

#include "motion/variation/joint_integration.h"
#include "motion/variation/linear_flow.h"
#include "motion/variation/saltation.h"
#include "motion/variation/start_projection.h"

#include <limits>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

class Trajectory;

/// A determinant that may be far from one.
struct Determinant {
  double logarithm = 0; ///< of the absolute value; -infinity: zero
  double sign = 1;
  double value() const;
};

/// Carries deviations of the physical state (coordinates, velocities, internal states, torques)
/// along, column by column.
class Variation : public Observer {
public:
  /// From where the trajectory stands, which must not have been moved since its start or be at a
  /// state to start from. Keeps references to the keys. `scale`: physical_size() factors that make
  /// deviations comparable; `tolerance`: error of a step that is not in closed form, relative to
  /// the largest scaled entry of the state and of each column.
  Variation(const Trajectory &trajectory, Vector scale, double tolerance,
            std::vector<KeyTangent *> keys = {});
  /// Begins anew from where the trajectory stands, which must be one of the same model and
  /// contacts. What belongs to the phases of the model is kept.
  void begin(const Trajectory &trajectory, std::vector<KeyTangent *> keys = {});

  /// Deviations at the start: physical_size() rows, any number of columns. They are projected onto
  /// those with which the motion can start (start_projection).
  void set_columns(const Matrix &columns);
  /// Those that they have become.
  Matrix columns() {
    catch_up();
    return columns_.leftCols(columns_.cols() - n_keys());
  }
  /// Derivatives of the state by the keys, at the present time and for the state at the start:
  /// physical_size() x keys.
  Matrix key_columns() {
    catch_up();
    return columns_.rightCols(n_keys());
  }
  /// Makes the scaled columns of deviations orthonormal so that the first k span what they did, by
  /// a QR decomposition. Returns ln |R_kk|, by which the volume of k columns was larger than that
  /// of k - 1; -infinity where a column depends on those before it, up to rounding.
  Vector orthonormalise();

  /// Linear phases pass as a whole, unless a key makes them something else; through nonlinear
  /// contacts keys ask for short parts.
  bool sees_steps(const Equations &equations) const override;
  bool follows_phases() const override { return true; }
  void step(const StepView &view) override;
  void interval(const Interval &interval) override;
  void event(const ContactEvent &event) override;
  bool wants_integrals() const override { return false; }

  /// What deviations at the start were projected by, and what that gives to the derivatives.
  const LinearMap &projection() const { return projection_; }
  /// Of the map from the start to here, behind the projection.
  const Determinant &determinant() {
    catch_up();
    return determinant_;
  }
  /// Events without a derivative: the guard had no rate, though something jumped; several contacts
  /// met or jumped at one instant, which deviating motions do one after the other.
  long tangential_events() const { return tangential_events_; }

private:
  struct Instant {
    double time = -std::numeric_limits<double>::infinity();
    std::vector<LowRankMap> maps; ///< of the events so far
    RowVector delay;
    bool jumps = false;
  };

  /// The last part that was integrated.
  struct LastPart {
    SmoothPart part;
    Matrix columns;       ///< at its start
    double logarithm = 0; ///< of the determinant, at its start
  };

  bool keys_keep_linear() const;
  Index n_keys() const { return static_cast<Index>(keys_.size()); }
  void follow(const Equations &motion, double time, const Vector &state);
  void pass_break(const Vector &state, double time, double next);
  bool pass_linear(double time, const Vector &state, double h);
  LinearFlow *free_flow();
  void join(const StepView &view);
  void catch_up();
  void forget_parts();
  double turn_of_waiting() const;
  void check(double time) const;
  bool contradicts(const Saltation &saltation, double time);

  Equations equations_; ///< a copy: its modes follow the motion
  std::vector<KeyTangent *> keys_;
  VariationAccuracy accuracy_;
  Saltations saltations_;
  ExactPhases phases_;
  bool closed_forms_ = false; ///< of the sources up to their next break; asked for by keys alone
  double start_ = 0;          ///< of the motion [s]
  std::optional<SmoothPart> waiting_; ///< steps that deviations have not been taken through
  int joined_ = 0;                    ///< how many
  std::optional<LastPart> last_part_; ///< none after an event
  Matrix columns_;                    ///< of deviations, then of keys
  LinearMap projection_;
  Determinant determinant_;
  Instant instant_;                                              ///< of the last event
  double last_event_ = -std::numeric_limits<double>::infinity(); ///< of any kind [s]
  long tangential_events_ = 0;
};

} // namespace vibroimpact::motion
