// What the excitation would do if it were frozen at its peak: the static displacements under it,
// contacts and cubic springs included.
//
// The peak is the instant of the window at which the varying part f of the loads is largest in the
// norm f^T m^-1 f; base motions count by their inertial load, dashpots not at all. The equilibria
// under the constant loads plus f and minus f give the two values of every point.
#pragma once

#include "analyses/recorders/channels.h"
#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <vector>

namespace vibroimpact::analyses {

class QuasiStatic : public Recorder {
public:
  explicit QuasiStatic(const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  /// NumericalError when nothing balances the load.
  void end(const motion::Trajectory &trajectory) override;
  /// point/BODY.POINT/quasi_static_displacement_x/minimum and /maximum, relative to the base [m].
  void add_fields(const FieldWriter &result) const override;

private:
  void consider(double time);
  double size(double time) const;

  const System &system_;
  Window window_;
  double peak_time_ = 0, peak_size_ = -1, longest_step_ = 0;
  std::vector<Vector> displacements_; ///< under both signs
};

} // namespace vibroimpact::analyses
