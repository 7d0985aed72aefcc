// The phases that a motion in closed form comes through, with the changes that lead from one to the
// next, the contacts between them that are solved as a whole, and what is observed of them.
#pragma once

#include "motion/episode/contact_outputs.h"
#include "motion/episode/contact_work.h"
#include "motion/interval/observer.h"
#include "motion/path/exact_outputs.h"
#include "motion/phase/exact_change.h"
#include "motion/phase/exact_phases.h"
#include "motion/phase/friction_routes.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

/// Made for the present observers and for those before: a search for the steady motion and the
/// recorders of a window take turns.
template <class Observed> struct ForObservers {
  std::unique_ptr<Observed> present{}, before{};

  /// For these, which are the present ones from now on; nullptr: not made yet.
  Observed *find(const Observers &observers) {
    if (!present || present->observers != observers.identity())
      std::swap(present, before);
    return present && present->observers == observers.identity() ? present.get() : nullptr;
  }
  std::size_t bytes() const {
    return (present ? present->bytes() : 0) + (before ? before->bytes() : 0);
  }
};

/// What is observed of a phase.
struct ObservedPhase {
  std::size_t bytes() const { return outputs ? bytes_of(forms.rows) + outputs->bytes() : 0; }

  long observers = -1; ///< their identity
  Audience in_steps, as_whole;
  LinearOutputs forms{};                   ///< of those who see it as a whole
  std::unique_ptr<ExactOutputs> outputs{}; ///< none where there are no forms
  long excitation = -1;                    ///< that these are for
};

/// What is observed of a contact that is solved as a whole.
struct ObservedContact {
  std::size_t bytes() const { return outputs ? outputs->bytes() : 0; }

  long observers = -1; ///< their identity
  Audience all;
  bool in_steps = false; ///< somebody must see it so
  LinearOutputs forms{};
  std::unique_ptr<ContactOutputs> outputs{}; ///< once asked for
};

/// A contact that is solved as a whole.
struct ContactPart {
  std::size_t bytes() const;

  std::unique_ptr<PhaseEpisode> contact;
  std::unique_ptr<ContactWork> work{}; ///< none until the integrals are asked for
  ForObservers<ObservedContact> observed{};
};

struct KnownPhase;

/// From a phase through one of its guards.
struct Transition {
  std::size_t bytes() const;

  KnownPhase *target = nullptr;   ///< none: left to others
  std::vector<double> proportion; ///< of the guards of the target to the one passed
  std::unique_ptr<ExactChange> change{};
  long excitation = -1; ///< that the change is for
  /// Of targets that are not linear, by the mode; none: left to others.
  std::map<int, std::unique_ptr<ContactPart>> contacts{};
  std::unique_ptr<FrictionRoutes> routes{}; ///< of a contact with friction
  /// The linear phase behind a contact, by the mode that it ends in; of one with friction by the
  /// route.
  std::map<std::size_t, std::unique_ptr<Transition>> behind{};
};

/// What depends on the excitation is renewed when it is asked for under another one.
struct KnownPhase : PhasePart {
  explicit KnownPhase(LinearPhase &of) : linear(of), transitions(guards().size()) {}
  std::size_t bytes() const override;
  void forget(const LinearPhase &other) override;

  const std::vector<PhaseGuard> &guards() const { return linear.forms().guards(); }
  ExactPhase &phase() const { return linear.phase(); }
  const PhaseView &view() const { return linear.phase().view(); }

  LinearPhase &linear;
  std::vector<std::unique_ptr<Transition>> transitions;
  ForObservers<ObservedPhase> observed{};
};

class KnownPhases {
public:
  /// Keeps references. `tolerance`: relative, of contacts.
  KnownPhases(Equations &equations, ExactPhases &phases, double tolerance)
      : equations_(equations), phases_(phases), tolerance_(tolerance) {}

  /// Are the present modes of the equations linear, with guards that the kernel can judge?
  bool known() const;
  /// Of the present modes of the equations, under the present excitation; nullptr: not known().
  KnownPhase *present();
  /// To the phase beyond a guard. None where it is left to others: impacts and rest are for several
  /// contacts together.
  Transition *transition(KnownPhase &from, std::size_t guard);
  /// What a contact that begins at a guard is solved by, behind transition(), from the amplitudes
  /// there; nullptr: it is left to others. Leaves the equations in the modes of the phase.
  ContactPart *contact_beyond(KnownPhase &from, std::size_t guard, double time,
                              const double *amplitudes);
  /// Where the law cuts its force off while the sides still overlap, the phase behind the contact
  /// is another one than that before. nullptr: the same.
  Transition *behind(KnownPhase &from, std::size_t guard, const PhaseEpisode &contact);
  /// The same as transition() of a contact with friction, by the amplitudes at the guard, each
  /// known to `rounding`; `route` is that which was taken.
  Transition *friction_transition(KnownPhase &from, std::size_t guard, const double *amplitudes,
                                  const double *rounding, const FrictionRoutes::Route *&route);
  /// The equations take the modes of a phase.
  void set_modes_of(const KnownPhase &phase) { set_modes(phase.linear.forms().contact_modes()); }

private:
  void set_modes(const std::vector<int> &modes);
  bool begins_friction(const KnownPhase &from, const PhaseGuard &passed) const;
  int mode_beyond(KnownPhase &from, std::size_t guard, double time, const double *amplitudes);
  void renew(KnownPhase &from, Transition &transition,
             const std::vector<PhaseForms::Reset> &resets);
  Transition find_transition(const KnownPhase &from, const PhaseGuard &passed);
  Transition lead_to(const KnownPhase &from, std::size_t contact, int mode);
  FrictionRoutes &friction_routes(KnownPhase &from, std::size_t guard);

  Equations &equations_;
  ExactPhases &phases_;
  double tolerance_;
  Vector state_; ///< at a touch
};

} // namespace vibroimpact::motion
