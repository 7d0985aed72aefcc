// What a motion shows while it is integrated: its smooth parts, each once it is over, and contact
// changes.
//
// Where the motion is known in closed form (linear phases, contacts that are solved as a whole) a
// part can be long, and the extreme values over it are known too. An observer that must look into
// it asks for steps; elsewhere there are steps alone.
#pragma once

#include "common/scalar.h"
#include "motion/interval/output.h"

#include <vector>

namespace vibroimpact::motion {

/// A jump of the velocities by impulses of rigid contacts, for those who need more of it than one
/// contact sees.
struct Collision {
  std::vector<int> modes_before, modes_after; ///< of all contacts
  /// The contacts that take an impulse, those with friction twice.
  std::vector<std::size_t> contacts;
  std::vector<int> directions; ///< of each: 0 the normal, 1 the tangential one
  Matrix rows;                 ///< their gap or slip rows, contacts x n
  Matrix response;             ///< M^-1 rows^T, n x contacts
  Matrix impulse_by_rate;      ///< derivative of the impulses by these rates before it
  bool unique = true;          ///< a single contact has set it off
};

/// A contact that changed its mode, or had an impact and parts again at once.
struct ContactEvent {
  double time = 0;
  std::size_t contact = 0;
  int from = 0;
  int to = 0;
  bool onset = false;          ///< the two sides have met: an impact begins
  double gap = 0;              ///< [m]
  double gap_rate = 0;         ///< just before [m/s]
  double gap_rate_after = 0;   ///< the same unless velocities jumped [m/s]
  double chatter_duration = 0; ///< time in which further impacts, infinitely many, would come to
                               ///< rest; they are replaced by rest at once [s]
  double angle = nan;          ///< of a circular gap: from a_1 to where the sides are closest [rad]
  const Vector *state = nullptr;
  const Vector *before = nullptr;        ///< the state before resets and jumps
  const contact::Guard *guard = nullptr; ///< that was passed
  const StateLayout *layout = nullptr;   ///< of the state
  const Collision *collision = nullptr;  ///< of the first event of each collision
};

class Observer {
public:
  virtual ~Observer() = default;
  /// Adds ranges that are to grow by the motion in the present modes of the equations, always
  /// before the part by which they grow is shown.
  virtual void outputs(const Equations & /*equations*/, std::vector<Output> & /*list*/) {}
  /// Must it see steps in the present modes where the motion is known in closed form? Then its
  /// ranges grow by their polynomials, too. So it does, asked or not, where one of its outputs is
  /// not linear in the motion. In a contact that is solved as a whole all see steps
  /// as soon as one does.
  virtual bool sees_steps(const Equations & /*equations*/) const { return true; }
  /// Does it follow the equations of each phase itself? Then it sees steps wherever the motion is
  /// not known in closed form.
  virtual bool follows_phases() const { return false; }
  virtual void step(const StepView &view) { interval(view); }
  /// A part that is not shown in steps.
  virtual void interval(const Interval & /*interval*/) {}
  virtual void event(const ContactEvent & /*event*/) {}
  /// False: the integrals of work and impulses in the state do not matter to it.
  virtual bool wants_integrals() const { return true; }
};

/// Some of the observers of a motion, and the ranges that they want to grow.
struct Audience {
  std::vector<Observer *> list{};
  std::vector<Output> outputs{};

  /// In the present modes of the equations.
  void ask(const Equations &equations);
  /// The ranges grow by it first.
  void show(const StepView &view) const;
  /// By which the ranges have grown.
  void show(const Interval &interval) const;
};

/// All who observe a motion. What they ask for in a phase is asked once and holds for all motions
/// that the same object, or a copy, observes.
class Observers {
public:
  Observers(std::vector<Observer *> list);
  Observers(Observer &only) : Observers(std::vector{&only}) {}

  bool empty() const { return list_.empty(); }
  const std::vector<Observer *> &list() const { return list_; }
  /// No two have the same.
  long identity() const { return identity_; }
  bool want_integrals() const;
  void event(const ContactEvent &event) const;
  /// Those that see steps in the present modes of the equations, or do not; asked.
  Audience in_steps(const Equations &equations) const { return those(true, equations); }
  Audience as_whole(const Equations &equations) const { return those(false, equations); }

private:
  Audience those(bool in_steps, const Equations &equations) const;

  std::vector<Observer *> list_;
  long identity_;
};

} // namespace vibroimpact::motion
