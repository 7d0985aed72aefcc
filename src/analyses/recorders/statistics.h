// Mean, root mean square and root mean square about the mean of a motion over a window.
//
// Integrals over time, by quadrature that is exact for the polynomials of the dense output and
// of ten points per step for contact forces, which may be powers.
#pragma once

#include "analyses/recorders/observables.h"
#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <boost/accumulators/accumulators.hpp>
#include <boost/accumulators/statistics/stats.hpp>
#include <boost/accumulators/statistics/weighted_mean.hpp>
#include <boost/accumulators/statistics/weighted_variance.hpp>

#include <vector>

namespace vibroimpact::analyses {

/// Time averages: values weighted by the time they stand for.
class TimeAverage {
public:
  /// One step of the given length [s].
  void add(const StepFunction &function, double length);
  void add(double value, double weight) { moments_(value, boost::accumulators::weight = weight); }

  double mean() const { return boost::accumulators::weighted_mean(moments_); }
  double mean_square() const;
  double rms() const;
  double rms_about_mean() const;

private:
  boost::accumulators::accumulator_set<
      double,
      boost::accumulators::stats<boost::accumulators::tag::immediate_weighted_mean,
                                 boost::accumulators::tag::weighted_variance>,
      double>
      moments_;
};

/// PATH/mean, /rms, /rms_about_mean of a quantity.
struct AverageLabels {
  AverageLabels(const std::string &path, const std::string &unit);
  Label mean, rms, rms_about_mean;
};

/// All three as scalar fields.
void add_average(const FieldWriter &result, const AverageLabels &labels,
                 const TimeAverage &average);

class Statistics : public Recorder {
public:
  Statistics(const ObservedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void add_fields(const FieldWriter &result) const override;

private:
  std::vector<Observable> observables_;
  std::vector<AverageLabels> labels_;
  std::vector<TimeAverage> averages_;
};

} // namespace vibroimpact::analyses
