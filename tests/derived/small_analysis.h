// An analysis small enough to be known in closed form, and parameter files that derive from it.
#pragma once

#include "derived/derived_quantities.h"
#include "simulation.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// Fields over the axes gap (Variables.gap), frequency in Hz, and direction.
class SmallAnalysis {
public:
  SmallAnalysis(std::vector<double> gaps, std::vector<double> frequencies)
      : axes_{{"Variables.gap", std::move(gaps), {}, "1", "swept key"},
              {"frequency", std::move(frequencies), {}, "Hz", "frequency of the excitation"},
              {"direction", {}, {"forward", "backward"}, "1", "of the sweep"}} {}

  using Value = std::function<double(double gap, double frequency, bool forward)>;

  void add(const std::string &name, const std::string &unit, const Value &value) {
    std::vector<double> &values = values_.emplace_back();
    for (const double gap : axes_[0].values)
      for (const double frequency : axes_[1].values)
        for (const bool forward : {true, false})
          values.push_back(value(gap, frequency, forward));
    const Shape shape{axes_[0].size(), axes_[1].size(), 2};
    arrays_.push_back(
        {name, unit, "", {axes_[0].name, axes_[1].name, axes_[2].name}, shape, nullptr});
  }

  derived::Source source() const {
    derived::Source source{axes_, arrays_};
    for (std::size_t a = 0; a < arrays_.size(); ++a)
      source.arrays[a].values = values_[a].data();
    return source;
  }

  /// Evaluates `Derived` sections given as the lines between subsection and end.
  derived::DerivedQuantities::Result
  derive(const std::vector<std::pair<std::string, std::string>> &sections) const {
    std::string text =
        "set Variables = gap = 1, scale = 4\nsubsection Analysis map\nsubsection Transient\n"
        "set Duration = 1 s\nend\nend\n";
    for (const auto &[name, lines] : sections)
      text += "subsection Derived " + name + "\nset From = map\n" + lines + "\nend\n";
    const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
    derived::DerivedQuantities quantities;
    const analyses::GridKey key{
        .path = "Variables/gap", .values = {}, .followers = {}, .name = "clearance"};
    quantities.add(set->root(), "map", axes_, {key});
    return quantities.evaluate("map", source());
  }

  derived::DerivedArray derive_one(const std::string &lines) const {
    const auto result = derive({{"quantity", lines}});
    for (const std::string &problem : result.problems)
      ADD_FAILURE() << problem;
    return result.arrays.at(0);
  }

  /// The message of a section that cannot be evaluated.
  std::string problem(const std::string &lines) const {
    try {
      const auto result = derive({{"quantity", lines}});
      return result.problems.empty() ? "" : result.problems[0];
    } catch (const InputError &error) {
      return error.what();
    }
  }

private:
  std::vector<Axis> axes_;
  std::vector<std::vector<double>> values_;
  std::vector<derived::LabelledArray> arrays_;
};

/// Equal where both are numbers, and NaN in the same places.
inline void expect_values(const std::vector<double> &values, const std::vector<double> &expected,
                          double tolerance = 1e-12) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(values[i])) << "value " << i << " is " << values[i];
    else
      EXPECT_NEAR(values[i], expected[i], tolerance) << "value " << i;
}

inline void expect_parts(const std::string &message, const std::vector<std::string> &parts) {
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in:\n" << message;
}

} // namespace vibroimpact::testing
