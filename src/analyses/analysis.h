// What an analysis is: outer axes, independent lines of work, and for each line a chain of points.
//
// An analysis consumes a System and hands PointResults to its line context; it never writes files.
// Lines can run on different ranks in any order; the points of a line run one after the other and
// may carry a state on. A new analysis is one file pair and one line in analyses.cc.
#pragma once

#include "analyses/run/system.h"
#include "common/result_sink.h"
#include "common/signals.h"
#include "common/step_record.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

class Outcomes;

/// Where a line finds what is already done and leaves what it has computed.
class LineContext {
public:
  virtual ~LineContext() = default;
  /// The point of an earlier, resumed run, or nullptr.
  virtual const PointResult *find(const std::vector<std::size_t> &index) const = 0;
  /// Makes the point durable. Throws Interrupted after that when the run is to stop.
  virtual void store(PointResult result) = 0;
  /// The share (0 to 1) of the point at hand that is done, at least; called now and then in a long
  /// motion. Throws Interrupted when the run is to stop: the point is then left unfinished.
  virtual void note_progress(double /*share*/) {}
  /// What the steps towards a point gave in an earlier run that did not get to it, and where those
  /// of this run are kept; null where nothing is kept.
  virtual std::unique_ptr<StepRecord> steps(const std::vector<std::size_t> & /*index*/) {
    return nullptr;
  }
  /// The point was found finished: only the progress counts on.
  virtual void skip() = 0;
  /// Leaves what lines after this one may ask for: at most Analysis::message_size() bytes.
  virtual void leave_message(std::size_t /*line*/, const std::string & /*note*/) {}
  /// That of a line before this one, for which it waits; an empty one where no notes are kept.
  /// Throws Interrupted when the run is to stop.
  virtual std::string message_of(std::size_t /*line*/) const { return {}; }
  /// The system of this line with other values of some keys. InputError.
  virtual System build(const std::vector<parameters::Override> & /*overrides*/) const {
    throw std::logic_error("no other systems can be built here");
  }
  /// Of the analysis that this one evaluates.
  virtual const Outcomes &outcomes() const {
    throw std::logic_error("no other analysis can be evaluated here");
  }
};

struct BestOf {
  std::string field;
  bool largest = false; ///< not the smallest
};

class Analysis {
public:
  virtual ~Analysis() = default;

  virtual std::string type() const = 0;
  virtual std::vector<Axis> axes() const = 0;
  virtual std::size_t lines() const { return 1; }
  /// InputError when the system and the analysis do not fit, before anything runs.
  virtual void check(const System &system) const = 0;
  /// Values of keys at which run_line() will build other systems, known beforehand so that their
  /// bodies are reduced and their sizes compared before anything runs.
  virtual std::vector<std::vector<parameters::Override>> variants() const { return {}; }
  /// Name of the analysis that this one evaluates at other values of keys; empty when there is
  /// none.
  virtual std::string evaluated() const { return {}; }
  /// The field by which the best of several starts of a search is chosen; empty where there are no
  /// starts.
  virtual BestOf best_of() const { return {}; }
  /// Paths of the keys that the analysis changes itself.
  virtual std::vector<std::string> changed_keys() const {
    const auto changes = variants();
    return changes.empty() ? std::vector<std::string>{}
                           : std::vector<std::string>{changes.front().front().path};
  }
  /// InputError when the other analysis cannot be evaluated as this one will, before anything runs.
  virtual void check_outcomes(const Outcomes & /*outcomes*/) const {}
  /// InputError when the other analysis does not have the quantities that this one needs. Runs a
  /// part of it, for some seconds at most, on one rank.
  virtual void try_outcomes(const Outcomes & /*outcomes*/) const {}
  /// Room for the note of a line [bytes]; 0: none leaves one.
  virtual std::size_t message_size() const { return 0; }
  /// InputError when systems with other values of keys do not fit, which `build` makes, before
  /// anything runs.
  virtual void check_built(const SystemSource & /*build*/) const {}
  /// Computes the points of one line. A NumericalError inside a point belongs into its result. The
  /// lines of one rank share the analysis, which may keep what does not change any result.
  virtual void run_line(std::size_t line, System &system, LineContext &context) const = 0;
};

/// Declares the kind "Analysis" with the sections of every type.
void declare_analyses(parameters::Section &root);

/// Does the analysis of a section, or the one that it repeats as a grid, evaluate another one?
bool evaluates_another(const parameters::Values &analysis);

/// The analysis a section chooses; `parameter grid` is resolved before (grid.h).
std::shared_ptr<const Analysis> create_analysis(const parameters::Values &analysis);

} // namespace vibroimpact::analyses
