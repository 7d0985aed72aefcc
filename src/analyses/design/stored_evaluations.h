// The evaluations of one start of a search: each is a point of the analysis, found again when a run
// is resumed, and none is computed twice.
#pragma once

#include "analyses/analysis.h"
#include "analyses/design/design_keys.h"
#include "analyses/results/field_writer.h"

#include <deque>
#include <map>

namespace vibroimpact::analyses {

/// All evaluations that a start may take are done.
struct EvaluationsSpent {};

template <class Value> struct EvaluationOf {
  std::size_t number = 0; ///< from 1
  Vector coordinates;
  Value value;
};

/// `Value` is what an evaluation gives.
template <class Value> class StoredEvaluations {
public:
  using Evaluation = EvaluationOf<Value>;

  /// Keeps references. The points have the indices (line, number).
  StoredEvaluations(const std::vector<DesignKey> &keys, std::size_t line, std::size_t most,
                    LineContext &context)
      : keys_(keys), line_(line), most_(most), context_(context) {}
  virtual ~StoredEvaluations() = default;
  StoredEvaluations(const StoredEvaluations &) = delete;
  StoredEvaluations &operator=(const StoredEvaluations &) = delete;

  /// Throws EvaluationsSpent, and what compute() and LineContext::store() do. Coordinates beyond a
  /// bound are those of the bound, so that the values of the keys decide what is known.
  const Evaluation &at(const Vector &coordinates) {
    const auto [place, is_new] = known_.try_emplace(values_at(keys_, coordinates), all_.size());
    if (!is_new)
      return all_[place->second];
    if (all_.size() == most_) {
      known_.erase(place);
      throw EvaluationsSpent{};
    }
    all_.push_back(find_or_compute(coordinates));
    return all_.back();
  }
  /// In the order in which they were asked for.
  const std::deque<Evaluation> &all() const { return all_; }

protected:
  LineContext &context() const { return context_; }

private:
  virtual Value compute(const std::vector<parameters::Override> &overrides) const = 0;
  virtual PointResult point(const std::vector<std::size_t> &index,
                            const Evaluation &evaluation) const = 0;
  virtual Value read(const PointResult &point) const = 0;

  Evaluation find_or_compute(const Vector &coordinates) {
    Evaluation evaluation{.number = all_.size() + 1, .coordinates = coordinates, .value = {}};
    const std::vector<std::size_t> index{line_, evaluation.number};
    if (const PointResult *known = context_.find(index)) {
      evaluation.value = read(*known);
      context_.skip();
    } else {
      evaluation.value = compute(overrides_at(keys_, coordinates));
      context_.store(point(index, evaluation));
    }
    return evaluation;
  }

  const std::vector<DesignKey> &keys_;
  std::size_t line_, most_;
  LineContext &context_;
  std::deque<Evaluation> all_;
  std::map<std::vector<double>, std::size_t> known_; ///< positions in all_ by the keys' values
};

/// Passes over what a start did not need, so that the progress comes to its end. `points` of the
/// start are done.
void skip_the_rest(std::size_t most, std::size_t points, LineContext &context);
/// The axes start and evaluation; evaluation 0 is the result.
Axis evaluation_axis(std::size_t most);
std::vector<Axis> search_axes(std::size_t starts, std::size_t most);
/// The fields key/NAME.
void add_keys(const FieldWriter &point, const std::vector<DesignKey> &keys,
              const Vector &coordinates);
/// -1 where the value is at the lower bound within `tolerance` of the coordinate, 1 at the upper
/// one, else 0.
double bound_at(const DesignKey &key, double value, double tolerance);
/// Why a point failed; never empty.
std::string stored_failure(const PointResult &point);

} // namespace vibroimpact::analyses
