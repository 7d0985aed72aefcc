// What a motion shows while it is integrated: smooth steps with dense output, and contact changes.
#pragma once

#include "motion/interval/bernstein.h"
#include "motion/interval/output_monitor.h"
#include "motion/system/equations.h"

#include <algorithm>
#include <vector>

namespace vibroimpact::motion {

/// What a contact's law sees during a step.
struct ContactCurves {
  Bernstein gap;
  Bernstein gap_rate;
  std::vector<Bernstein> internal;
  Bernstein normal_force; ///< in modes that hold the gap
};

/// One accepted step, smooth inside. Valid only during the call.
class StepView {
public:
  StepView(const Equations &equations, const EndPoint &start, const EndPoint &end)
      : equations_(&equations), start_(&start), end_(&end) {}

  double start() const { return start_->time; }
  double end() const { return end_->time; }
  double length() const { return end_->time - start_->time; }
  const Equations &equations() const { return *equations_; }
  const Vector &start_state() const { return start_->state; }
  const Vector &end_state() const { return end_->state; }

  /// Displacement seen by a projection, as a polynomial in tau = (t - start)/length: a quintic, or
  /// of degree 9 where the method knows higher derivatives at the ends.
  Bernstein displacement(const model::Projection &projection) const;
  /// Its time derivative, exact at both ends.
  Bernstein velocity(const model::Projection &projection) const;
  /// Its second time derivative, from the equations at both ends and the displacement between.
  Bernstein acceleration(const model::Projection &projection) const;
  /// One coordinate.
  Bernstein coordinate(Index j) const;

  Bernstein gap(std::size_t contact) const { return position(contact, 0); }
  /// Time derivative of the gap.
  Bernstein gap_rate(std::size_t contact) const { return rate(contact, 0); }
  /// Along a direction of a contact: the gap (0) or a slip, and its rate.
  Bernstein position(std::size_t contact, int direction) const;
  Bernstein rate(std::size_t contact, int direction) const;
  Bernstein internal(Index i) const;
  /// Torque of a motor.
  Bernstein drive(Index i) const;
  /// The force that holds a direction of a contact in its present mode; zero in other modes.
  Bernstein constraint_force(std::size_t contact, int direction = 0) const;
  Bernstein indicator(std::size_t contact, const contact::AffineForm &form) const;

  ContactCurves contact_curves(std::size_t contact) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, const ContactCurves &curves, double tau) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, double tau) const;

private:
  Bernstein first_order_state(Index place) const;

  const Equations *equations_;
  const EndPoint *start_;
  const EndPoint *end_;
};

/// A jump of the velocities by impulses of rigid contacts, for those who need more of it than one
/// contact sees.
struct Collision {
  std::vector<int> modes_before, modes_after; ///< of all contacts
  /// The contacts that take an impulse.
  std::vector<std::size_t> contacts;
  Matrix rows;            ///< their gap rows, contacts x n
  Matrix response;        ///< M^-1 rows^T, n x contacts
  Matrix impulse_by_rate; ///< derivative of the impulses by the gap rates before it
  bool unique = true;     ///< a single contact has set it off
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
  const Vector *state = nullptr;
  const Vector *before = nullptr;        ///< the state before resets and jumps
  const contact::Guard *guard = nullptr; ///< that was passed
  const StateLayout *layout = nullptr;   ///< of the state
  const Collision *collision = nullptr;  ///< of the first event of each collision
};

class Observer {
public:
  virtual ~Observer() = default;
  virtual void step(const StepView &view) = 0;
  virtual void event(const ContactEvent & /*event*/) {}
  /// Where a motion is known in closed form, some can do with extreme values and events instead of
  /// steps: what they want to see there. None: it must see steps there too.
  virtual OutputMonitor *output_monitor() { return nullptr; }
  /// Who must see steps where a motion is known in closed form; nullptr: nobody.
  virtual Observer *step_observer() { return output_monitor() ? nullptr : this; }
  /// False: the integrals of work and impulses in the state do not matter to it.
  virtual bool wants_integrals() const { return true; }
};

/// Passes everything on to several observers.
class Observers : public Observer, private OutputMonitor {
public:
  explicit Observers(std::vector<Observer *> list);
  void step(const StepView &view) override {
    for (Observer *observer : list_)
      observer->step(view);
  }
  void event(const ContactEvent &event) override {
    for (Observer *observer : list_)
      observer->event(event);
  }
  OutputMonitor *output_monitor() override { return monitors_.empty() ? nullptr : this; }
  Observer *step_observer() override { return stepped_.list.empty() ? nullptr : &stepped_; }
  bool wants_integrals() const override {
    return std::any_of(list_.begin(), list_.end(),
                       [](const Observer *observer) { return observer->wants_integrals(); });
  }

private:
  class Stepped : public Observer {
  public:
    void step(const StepView &view) override {
      for (Observer *observer : list)
        observer->step(view);
    }
    std::vector<Observer *> list;
  };
  void add_forms(const Equations &equations, std::vector<MonitoredForm> &forms) override;
  void part_begins(const Equations &equations, double start, const Vector &state) override;
  void part_done(const Equations &equations, double start, double end,
                 const Vector &state) override;
  bool takes_contacts() const override;

  std::vector<Observer *> list_;
  std::vector<OutputMonitor *> monitors_;
  Stepped stepped_;
};

} // namespace vibroimpact::motion
