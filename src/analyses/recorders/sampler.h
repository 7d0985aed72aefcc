// Samples of a motion at given instants, from the dense output: the steps are not disturbed.
#pragma once

#include "analyses/recorders/observables.h"
#include "analyses/results/field_writer.h"

#include <vector>

namespace vibroimpact::analyses {

/// Instants first, first + interval, ... up to last, inclusive (within rounding).
std::vector<double> equal_instants(double first, double last, double interval);

/// Instants of the list that lie in a step that ends at `end`, from number `next` on: returns the
/// number of the first one beyond. One at a contact change belongs to the step before it.
std::size_t end_of_step(const std::vector<double> &instants, std::size_t next, double end);

class Sampler : public motion::Observer {
public:
  Sampler() = default;
  /// Ascending instants [s]; one at the very start is included.
  Sampler(std::vector<Observable> observables, std::vector<double> instants);
  /// Samples at start + i interval, i = 0 ... count - 1. NumericalError when there is no memory for
  /// them.
  Sampler(std::vector<Observable> observables, double start, double interval, std::size_t count);

  void step(const motion::StepView &view) override;

  /// Samples of an observable taken so far, and their instants [s].
  const std::vector<double> &values(std::size_t observable) const { return values_[observable]; }
  std::vector<double> times() const;

  /// The instants, as the field `dimension`, and the samples of each observable along it.
  void add_fields(const FieldWriter &result, const std::string &dimension) const;

private:
  std::vector<Observable> observables_;
  std::vector<double> instants_;
  std::size_t next_ = 0;
  std::vector<std::vector<double>> values_;
};

} // namespace vibroimpact::analyses
