// Event log: every impact of every contact with the figures an engineer asks for.
#pragma once

#include "motion/interval/extremum.h"
#include "motion/interval/observer.h"

#include <vector>

namespace vibroimpact::motion {

/// From the instant the two sides meet to the one at which they part.
struct Impact {
  double start_time = 0;          ///< [s]
  double duration = 0;            ///< [s]
  double approach_speed = 0;      ///< -gap_rate at the start [m/s]
  double separation_speed = 0;    ///< gap_rate at the end [m/s]
  double peak_force = 0;          ///< [N]; a rigid impact itself has an impulse, but no force
  double peak_time = 0;           ///< of the largest force [s]; NaN when instants are not kept
  double impulse = 0;             ///< integral of the force [N s]
  double maximum_penetration = 0; ///< [m]
  double dissipated_energy = 0;   ///< by the contact law [J]
  double angle = nan;             ///< of a circular gap: where the sides met, from a_1 [rad]
  double chatter_duration = 0;    ///< of further impacts that were completed at once [s]
  /// False: the sides were still together where the record ended. Duration, peak, impulse, overlap
  /// and energy are those up to then, and there is no separation speed (NaN).
  bool finished = true;
  Extremum force{}, overlap{}; ///< where extrema are kept; nothing seen of rigid impacts

  /// separation_speed / approach_speed; NaN when there is none
  double restitution_coefficient() const;
};

/// Samples of the force while a contact lasts, as dense as the time steps. NaN separates impacts.
struct Pulses {
  std::vector<double> time;  ///< [s]
  std::vector<double> force; ///< [N]
  std::vector<double> gap;   ///< [m]
};

class ImpactLog : public Observer {
public:
  /// Keeps the force samples of the first `pulses` impacts of each contact and, where `instants`,
  /// the instant of the largest force of all.
  ImpactLog(const contact::ContactSet &contacts, std::size_t pulses, bool instants = false);

  void outputs(const Equations &equations, std::vector<Output> &list) override;
  /// For force samples, instants and extrema.
  bool sees_steps(const Equations & /*equations*/) const override {
    return pulse_limit_ > 0 || instants_ || extrema_;
  }
  void step(const StepView &view) override;
  void interval(const Interval &interval) override;
  void event(const ContactEvent &event) override;
  /// From now on of all impacts.
  void keep_extrema() { extrema_ = true; }
  /// The record ends here: impacts that last are listed behind the finished ones, as far as they
  /// have come.
  void end_record(double time, const Vector &state, const StateLayout &layout);
  /// Forgets finished impacts; one that lasts goes on.
  void clear();
  /// Forgets everything: as if it had just been made.
  void start_afresh();

  /// Impacts of a contact in the order of time: the finished ones and, behind end_record(), the one
  /// that lasts.
  const std::vector<Impact> &impacts(std::size_t contact) const { return tracks_[contact].done; }
  const Pulses &pulses(std::size_t contact) const { return tracks_[contact].pulses; }
  /// Impacts begun since the start or the last clear(), finished or not.
  std::size_t begun(std::size_t contact) const { return tracks_[contact].begun; }

private:
  struct Track {
    std::vector<Impact> done;
    Pulses pulses;
    std::size_t begun = 0;
    std::size_t pulses_begun = 0;
    bool complete = false; ///< its beginning was seen
    Impact current;
    ValueRange force, gap; ///< of the present impact
  };
  struct Forms {
    OutputForm force, gap;
  };
  bool in_contact(std::size_t contact, int mode) const;
  static void take_ranges(Track &track);
  void begin(Track &track, const ContactEvent &event) const;
  void finish(Track &track, const ContactEvent &event) const;
  void note_step(Track &track, const StepView &view, std::size_t contact) const;
  void record_pulse(Track &track, const StepView &view, std::size_t contact) const;

  const contact::ContactSet &contacts_;
  std::size_t pulse_limit_;
  bool instants_;
  bool extrema_ = false;
  std::vector<Track> tracks_;
  std::vector<Forms> forms_; ///< of each contact
};

} // namespace vibroimpact::motion
