#include "analyses/design/fit_evaluations.h"

#include "analyses/design/single_outcomes.h"
#include "analyses/results/fields.h"
#include "common/error.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

/// Data of one analysis need one run of it.
std::vector<std::string> analyses_of(const std::vector<DataSet> &data) {
  std::vector<std::string> names;
  for (const DataSet &set : data)
    if (std::find(names.begin(), names.end(), set.analysis()) == names.end())
      names.push_back(set.analysis());
  return names;
}

void add_set(const FieldWriter &point, const FittedSet &fitted, const DataSet &data) {
  const auto add = [&](const std::string &group, const std::vector<double> &values,
                       const std::string &unit, const std::string &description) {
    point.series(group + "/" + data.name(), "datum_of_" + data.name(), values, unit, description);
  };
  add("abscissa", fitted.abscissa, fitted.abscissa_unit, "where the data were measured");
  add("measured", fitted.measured, fitted.unit, "measured " + data.quantity());
  add("model", fitted.model, fitted.unit, data.quantity() + " at the abscissae of the data");
  add("residual", fitted.residual, "1",
      "model less measurement, in standard deviations or else in the root mean square of the data, "
      "times the root of the weight");
}

} // namespace

Vector FitValue::residuals() const {
  std::vector<double> all;
  for (const FittedSet &set : sets)
    all.insert(all.end(), set.residual.begin(), set.residual.end());
  return Eigen::Map<const Vector>(all.data(), static_cast<Index>(all.size()));
}

FitValue FitEvaluations::compute(const std::vector<parameters::Override> &overrides) const {
  FitValue value;
  value.sets.resize(data_.size());
  const std::vector<std::string> analyses = analyses_of(data_);
  const auto total = static_cast<double>(analyses.size());
  for (std::size_t a = 0; a < analyses.size(); ++a)
    try {
      std::vector<std::string> quantities;
      for (const DataSet &set : data_)
        if (set.analysis() == analyses[a])
          quantities.push_back(set.quantity());
      const Evaluated evaluated =
          context().outcomes().evaluate(analyses[a], overrides, quantities, [&](double share) {
            context().note_progress((static_cast<double>(a) + share) / total);
          });
      std::size_t next = 0;
      for (std::size_t s = 0; s < data_.size(); ++s)
        if (data_[s].analysis() == analyses[a])
          value.sets[s] = data_[s].compare(evaluated.outcomes[next++]);
    } catch (const NumericalError &error) {
      return {.failure = error.what()};
    }
  return value;
}

void try_data(const Outcomes &outcomes, const std::vector<parameters::Override> &overrides,
              const std::vector<DataSet> &data) {
  for (const std::string &analysis : analyses_of(data)) {
    std::vector<const DataSet *> sets;
    std::vector<WantedQuantity> quantities;
    for (const DataSet &set : data)
      if (set.analysis() == analysis) {
        sets.push_back(&set);
        quantities.push_back({set.quantity(), set.place()});
      }
    try_quantities(outcomes, analysis, overrides, quantities,
                   [&](std::size_t i, const Outcome &outcome) { sets[i]->check(outcome); });
  }
}

PointResult fit_point(const std::vector<std::size_t> &index, const FitEvaluation &evaluation,
                      const std::vector<DesignKey> &keys, const std::vector<DataSet> &data) {
  PointResult point{.index = index};
  add_keys(point, keys, evaluation.coordinates);
  if (evaluation.value.failed()) {
    point.status = Status::failed;
    point.reason = evaluation.value.failure;
    return point;
  }
  FieldWriter(point).number("sum_of_squares", evaluation.value.residuals().squaredNorm(), "1",
                            "of all residuals");
  for (std::size_t s = 0; s < data.size(); ++s)
    add_set(point, evaluation.value.sets[s], data[s]);
  return point;
}

PointResult FitEvaluations::point(const std::vector<std::size_t> &index,
                                  const FitEvaluation &evaluation) const {
  return fit_point(index, evaluation, fit_keys_, data_);
}

FitValue FitEvaluations::read(const PointResult &point) const {
  if (point.status == Status::failed)
    return {.failure = stored_failure(point)};
  FitValue value;
  for (const DataSet &data : data_) {
    FittedSet &set = value.sets.emplace_back();
    const auto stored = [&](const std::string &group, std::vector<double> &values) {
      const Field &field = field_of(point, group + "/" + data.name());
      values = field.values;
      return field.unit();
    };
    set.abscissa_unit = stored("abscissa", set.abscissa);
    set.unit = stored("measured", set.measured);
    stored("model", set.model);
    stored("residual", set.residual);
  }
  return value;
}

} // namespace vibroimpact::analyses
