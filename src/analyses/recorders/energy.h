// Where the energy of a motion goes in a window: work of the loads, what each body, connection and
// contact dissipates, and what the balance leaves over.
//
// Kinetic energy and the work of a moving base count in the frame of the base. Over whole periods
// of a steady motion that work equals the one in space: F_base s' and -B s'' v differ by the rate
// of B v s' + M s'^2/2, which repeats.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <vector>

namespace vibroimpact::analyses {

class Energy : public Recorder {
public:
  explicit Energy(const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void end(const motion::Trajectory &trajectory) override;
  /// energy/input_work, /damping_work, /contact_work, /stored_change, /residual (stored change less
  /// input plus losses), dissipated_energy of every body, connection, bearing and contact and of
  /// the system damping, and motor_work of every rotor [J]; all works also per period where the
  /// window has periods.
  void add_fields(const FieldWriter &result) const override;

private:
  /// A work and its mean per period.
  struct WorkLabels {
    WorkLabels(const std::string &path, const std::string &meaning);
    Label whole, per_period;
  };
  void add_work(const FieldWriter &result, const WorkLabels &labels, double work) const;
  double energy_beyond(const motion::Trajectory &trajectory) const;
  double stored_energy(const motion::Trajectory &trajectory) const;
  double lost_in_dashpot(double damping, const model::Projection &elongation,
                         const motion::StepView &view);
  double lost_in_bearing(const model::Bearing &bearing, const motion::StepView &view);

  const System &system_;
  /// Of contacts, bodies, connections, bearings, rotors and system damping, in this order.
  std::vector<WorkLabels> part_labels_;
  Window window_;
  Vector first_state_, last_state_;
  double first_energy_ = 0, last_energy_ = 0;
  std::vector<double> by_body_, by_connection_, by_bearing_, by_motor_; ///< [J]
  std::vector<double> by_system_; ///< of the system damping, if there is one [J]
  /// What dashpots and springs to a moving base take in beyond the input work of the equations,
  /// which counts only the motion relative to the base [J].
  double base_work_ = 0;
};

} // namespace vibroimpact::analyses
