// The largest von Mises stress at points of beams, shells and solids.
//
// Each stress component is linear in the motion of a body, so that it is a polynomial along a step;
// its von Mises stress is sought on it. Of the places at a point (fibres of a beam, both surfaces
// of a shell, in every element that meets there) the largest counts.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

class Stresses : public Recorder {
public:
  /// `points`: "body.point"; empty means all whose stress is known.
  Stresses(const std::vector<std::string> &points, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  /// point/BODY.POINT/von_mises_stress/maximum [Pa].
  void add_fields(const FieldWriter &result) const override;

private:
  struct Point {
    Label label;
    std::vector<std::vector<model::Projection>> places; ///< the components of the stress at each
    double largest = 0;                                 ///< square of the von Mises stress
  };

  std::vector<Point> points_;
};

} // namespace vibroimpact::analyses
