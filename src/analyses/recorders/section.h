// Sections of the motion: states of chosen points at the ends of forcing periods (stroboscopic,
// Poincare points), at the onset of contacts, and at extrema of displacements and gaps.
#pragma once

#include "analyses/recorders/observables.h"
#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct SectionSettings {
  std::vector<Observable> observed{};     ///< displacements and velocities; none: of all points
  std::vector<std::size_t> onsets{};      ///< contacts whose onset is a section
  std::vector<std::size_t> gap_extrema{}; ///< contacts whose gap's extrema are
  bool extrema = false;                   ///< whether those of each displacement are
  std::size_t maximum_samples = 0;        ///< of each section
};

class SectionRecorder : public Recorder {
public:
  /// The system must outlive it.
  SectionRecorder(const System &system, SectionSettings settings);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  void add_fields(const FieldWriter &result) const override;

private:
  // The samples of one section.
  struct Samples {
    std::string name;      ///< path below "section/"
    std::string dimension; ///< "sample_period"
    std::string description;
    std::vector<double> time;
    std::vector<std::vector<double>> values; ///< [observable][sample]
    long left_out = 0;

    void clear();
  };
  // A surface through zeros of a rate, inside the steps or jumped over between them.
  struct RateSection {
    std::size_t samples = 0;      ///< index of its Samples
    double last_rate = 0;         ///< at the end of the step before
    std::size_t displacement = 0; ///< index of the observable; not of gaps
  };

  std::size_t new_section(const std::string &name, const std::string &dimension,
                          const std::string &description);
  bool full(Samples &samples) const;
  void add_state(Samples &samples, double time, const Vector &state) const;
  void add_point(Samples &samples, const motion::StepView &view, double tau) const;
  void add_zeros(RateSection &section, const motion::StepView &view, const motion::Bernstein &rate);
  void add_samples(const FieldWriter &result, const Samples &samples) const;

  const model::Model &model_;
  SectionSettings settings_;
  std::vector<Observable> observables_; ///< displacements and velocities
  double start_ = 0, period_ = 0;
  motion::StateLayout layout_;
  std::vector<Samples> sections_; ///< period ends, onsets, extrema of gaps, of displacements
  std::vector<RateSection> gap_rates_, displacement_rates_;
};

} // namespace vibroimpact::analyses
