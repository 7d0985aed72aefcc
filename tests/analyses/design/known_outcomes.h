// Outcomes that are known functions of the keys, and a context that keeps what searches on them
// store.
#pragma once

#include "analyses/run/outcomes.h"
#include "common/error.h"
#include "common/signals.h"
#include "simulation.h"
#include "support/points.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace vibroimpact::analyses {

using Arguments = std::map<std::string, double>;
/// Values of the quantities "f" and "g" at values of keys.
using Known = std::function<std::vector<double>(const Arguments &)>;

class KnownOutcomes : public Outcomes {
public:
  explicit KnownOutcomes(Known known) : known_(std::move(known)) {}

  void check(const std::string &, const std::vector<parameters::Override> &) const override {}
  Evaluated evaluate(const std::string &, const std::vector<parameters::Override> &overrides,
                     const std::vector<std::string> &names,
                     const std::function<void(double)> &progress) const override {
    ++calls;
    progress(0.5);
    Arguments arguments;
    for (const parameters::Override &change : overrides)
      arguments[change.path.substr(change.path.find('/') + 1)] = std::stod(change.value);
    const std::vector<double> values = known_(arguments);
    Evaluated evaluated;
    for (std::size_t i = 0; i < names.size(); ++i)
      evaluated.outcomes.push_back({.unit = "m",
                                    .one = parameters::evaluate("1 m", {}),
                                    .description = "",
                                    .axes = {},
                                    .axis_ones = {},
                                    .values = {values.at(i)}});
    return evaluated;
  }
  mutable int calls = 0;

private:
  Known known_;
};

class SearchPoints : public testing::Points {
public:
  explicit SearchPoints(const Outcomes &outcomes) : outcomes_(outcomes) {}
  const Outcomes &outcomes() const override { return outcomes_; }
  void store(PointResult result) override {
    if (left-- == 0)
      throw Interrupted{};
    testing::Points::store(std::move(result));
  }
  void skip() override { ++skipped; }
  void leave_message(std::size_t line, const std::string &note) override { notes_[line] = note; }
  std::string message_of(std::size_t line) const override { return notes_.at(line); }
  int left = -1; ///< points that may be stored
  int skipped = 0;

private:
  const Outcomes &outcomes_;
  std::map<std::size_t, std::string> notes_;
};

/// A run that is cut off behind `count` points, and one that goes on: together they evaluate once
/// more than a whole one. `outcomes` count their calls.
struct CutRun {
  SearchPoints cut, resumed;

  template <class Counted>
  CutRun(const Counted &outcomes, int whole_calls, int count,
         const std::function<void(SearchPoints &)> &run)
      : cut(outcomes), resumed(outcomes) {
    outcomes.calls = 0;
    cut.left = count;
    EXPECT_THROW(run(cut), Interrupted);
    for (const auto &[index, point] : cut.all())
      resumed.know(point);
    run(resumed);
    EXPECT_EQ(outcomes.calls, whole_calls + 1); // the one that was cut off
  }
};

/// The analysis "search" of a file that has the variables x, y, z and the analysis "other".
inline std::shared_ptr<const Analysis> search_analysis(const std::string &section) {
  const std::string text = R"(set Variables = x = 1, y = 1, z = 0
subsection Analysis other
end
subsection Analysis search
)" + section + "end\n";
  const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
  return create_analysis(set->root().instance("Analysis", "search"));
}

/// Runs all lines.
inline void run_all(const Analysis &search, SearchPoints &points) {
  System system{.model = model::Model({}), .contacts = {}, .integration = {}, .initial = {}};
  for (std::size_t line = 0; line < search.lines(); ++line)
    search.run_line(line, system, points);
}

} // namespace vibroimpact::analyses
