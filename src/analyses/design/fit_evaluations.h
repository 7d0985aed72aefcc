// The evaluations of a fit: each gives the residuals of all sets of data.
#pragma once

#include "analyses/design/measured_data.h"
#include "analyses/design/stored_evaluations.h"

namespace vibroimpact::analyses {

struct FitValue {
  std::string failure{};         ///< why there are no residuals; else empty
  std::vector<FittedSet> sets{}; ///< one for each set of data

  bool failed() const { return !failure.empty(); }
  Vector residuals() const; ///< of all sets, one behind the other
};

using FitEvaluation = EvaluationOf<FitValue>;

class FitEvaluations : public StoredEvaluations<FitValue> {
public:
  /// Keeps references.
  FitEvaluations(const std::vector<DesignKey> &keys, const std::vector<DataSet> &data,
                 std::size_t line, std::size_t most, LineContext &context)
      : StoredEvaluations(keys, line, most, context), fit_keys_(keys), data_(data) {}

private:
  FitValue compute(const std::vector<parameters::Override> &overrides) const override;
  PointResult point(const std::vector<std::size_t> &index,
                    const FitEvaluation &evaluation) const override;
  FitValue read(const PointResult &point) const override;

  const std::vector<DesignKey> &fit_keys_;
  const std::vector<DataSet> &data_;
};

/// Refuses data whose quantities are not there or do not fit them, as far as
/// Outcomes::try_first_point() shows. InputError.
void try_data(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides,
              const std::vector<DataSet> &data);

/// The fields of an evaluation with this index, to which more may be added.
PointResult fit_point(const std::vector<std::size_t> &index, const FitEvaluation &evaluation,
                      const std::vector<DesignKey> &keys, const std::vector<DataSet> &data);

} // namespace vibroimpact::analyses
