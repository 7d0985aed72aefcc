// Walks that go on from the steps of an earlier run: from wherever it was cut off they evaluate
// what is left, and come to the same numbers.
#include "continuation/locus.h"
#include "piecewise.h"
#include "support/steps_in_memory.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace resumed_walks_tests {

using testing::first_of;
using testing::StepsInMemory;

/// Counts what is asked of a problem.
class Counted : public Problem {
public:
  explicit Counted(Problem &problem) : problem_{problem} {}
  Vector scales() const override { return problem_.scales(); }
  Evaluation evaluate(const Point &point) override { return ++calls, problem_.evaluate(point); }
  bool is_map() const override { return problem_.is_map(); }
  std::vector<ShorterReturn> shorter_returns(const Point &point) override {
    return ++calls, problem_.shorter_returns(point);
  }
  double best_chart(const Point &point) override { return ++calls, problem_.best_chart(point); }
  Transfer transfer(const Point &point, double chart) override {
    return ++calls, problem_.transfer(point, chart);
  }
  std::vector<Graze> grazes_near(const Point &point) override {
    return ++calls, problem_.grazes_near(point);
  }
  Extension extend(const Point &point, const Graze &graze) override {
    return ++calls, problem_.extend(point, graze);
  }

  int calls = 0;

private:
  Problem &problem_;
};

std::vector<double> numbers(const BranchPoint &point) {
  std::vector<double> all(point.point.state.begin(), point.point.state.end());
  all.insert(all.end(), point.point.keys.begin(), point.point.keys.end());
  all.insert(all.end(), point.tangent.begin(), point.tangent.end());
  for (const auto &mu : point.multipliers)
    all.insert(all.end(), {mu.real(), mu.imag()});
  for (const int number : point.pattern)
    all.push_back(number);
  all.insert(all.end(), {point.point.chart, point.residual, point.arclength,
                         static_cast<double>(point.unstable)});
  return all;
}

std::vector<double> numbers(const Branch &branch) {
  std::vector<double> all{static_cast<double>(branch.end)};
  for (const BranchPoint &point : branch.points)
    for (const double number : numbers(point))
      all.push_back(number);
  for (const SpecialPoint &special : branch.special) {
    for (const double number : numbers(special.at))
      all.push_back(number);
    all.insert(all.end(), special.vector.data(), special.vector.data() + special.vector.size());
    all.insert(all.end(), {static_cast<double>(special.kind), static_cast<double>(special.after),
                           special.slope, special.angle, static_cast<double>(special.graze ? 1 : 0),
                           static_cast<double>(special.unstable_before),
                           static_cast<double>(special.unstable_after)});
  }
  return all;
}

std::vector<double> numbers(const Locus &locus) {
  std::vector<double> all{static_cast<double>(locus.end)};
  const auto add = [&](const LocusPoint &point) {
    for (const Vector *part :
         {&point.point.state, &point.point.keys, &point.tangent, &point.defect})
      all.insert(all.end(), part->begin(), part->end());
    all.insert(all.end(), point.by_state.data(), point.by_state.data() + point.by_state.size());
    all.insert(all.end(), {point.point.chart, point.residual, point.angle, point.arclength,
                           static_cast<double>(point.side)});
  };
  for (const LocusPoint &point : locus.points)
    add(point);
  for (const SpecialLocusPoint &special : locus.special) {
    add(special.at);
    all.insert(all.end(), {static_cast<double>(special.kind), static_cast<double>(special.after)});
  }
  return all;
}

/// Follows once and then again behind every number of steps; `follow` takes problem and record.
template <class Follow> void expect_goes_on_anywhere(Problem &problem, const Follow &follow) {
  Counted plain(problem), whole(problem);
  const std::vector<double> expected = numbers(follow(plain, nullptr));
  StepsInMemory all;
  std::vector<int> calls{0}; // that led to each number of steps
  all.kept = [&] { calls.push_back(whole.calls); };
  EXPECT_EQ(numbers(follow(whole, &all)), expected);
  EXPECT_EQ(whole.calls, plain.calls);
  ASSERT_GT(all.fresh.size(), 10u);
  for (std::size_t kept = 0; kept <= all.fresh.size(); ++kept) {
    Counted rest(problem);
    StepsInMemory record(first_of(all.fresh, kept));
    EXPECT_EQ(numbers(follow(rest, &record)), expected) << kept;
    EXPECT_TRUE(record.spent());
    EXPECT_EQ(rest.calls, whole.calls - calls[kept]) << kept;
    EXPECT_EQ(record.fresh.size(), all.fresh.size() - kept);
  }
}

Settings within(Range first, Range second = {}) {
  Settings settings;
  settings.first_key = first;
  settings.second_key = second;
  return settings;
}

TEST(ResumedWalksTest, OfACircleThatCloses) {
  Algebraic circle(
      [](const Point &at) {
        const double x = at.state(0), p = at.keys(0);
        return scalar(x * x + p * p - 1, 2 * x, 2 * p);
      },
      vector({1, 1}));
  expect_goes_on_anywhere(circle, [](Problem &problem, StepRecord *record) {
    Branch branch = follow(problem, {{vector({-1}), vector({0})}, {}, true}, {}, {}, record);
    EXPECT_EQ(branch.end, End::closed);
    return branch;
  });
}

// Of the period 2 from its middle down to the flip of period 1, where it ends, and up to a bound
// behind its own flip.
TEST(ResumedWalksTest, OfAMapWithFlips) {
  PowerOfMap squared(logistic_map, vector({1, 1}), 2);
  for (const bool forward : {false, true})
    expect_goes_on_anywhere(squared, [forward](Problem &problem, StepRecord *record) {
      // x = (r + 1 + sqrt((r + 1) (r - 3))) / (2 r)
      const double r = 3.3, x = (r + 1 + std::sqrt((r + 1) * (r - 3))) / (2 * r);
      Branch branch = follow(problem, {{vector({x}), vector({r})}, {}, forward},
                             within({2.5, 3.52}), {}, record);
      EXPECT_EQ(branch.end, forward ? End::upper_bound : End::shorter_return) << branch.reason;
      return branch;
    });
}

// x = p + x / 2 + c f(x), across the corner and the square root at x = 0.
TEST(ResumedWalksTest, ThroughGrazes) {
  for (const Touch touch : {Touch::corner, Touch::square_root}) {
    PiecewiseMap map = scalar_map(0.5, -0.3, touch);
    expect_goes_on_anywhere(map, [](Problem &problem, StepRecord *record) {
      Branch branch = follow(problem, {{vector({-1}), vector({-0.5})}, {}, true}, within({-1, 0.4}),
                             {}, record);
      EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
      EXPECT_GE(branch.special.size(), 1u);
      return branch;
    });
  }
}

// x^3 - b x - a = 0 through the cusp at a = b = 0.
TEST(ResumedWalksTest, OfFoldsThroughACusp) {
  Algebraic problem(
      [](const Point &at) {
        const double x = at.state(0), a = at.keys(0), b = at.keys(1);
        return Evaluation{
            vector({x * x * x - b * x - a}), vector({3 * x * x - b}), RowVector{{-1, -x}}, {}};
      },
      vector({1, 1, 1}));
  expect_goes_on_anywhere(problem, [](Problem &counted, StepRecord *record) {
    const double x = 0.8;
    Locus locus = follow_locus(
        counted, {LocusKind::fold, {vector({x}), vector({-2 * x * x * x, 3 * x * x})}, {}, false},
        within({-5, 5}, {-1, 3}), {}, record);
    EXPECT_EQ(locus.special.size(), 1u);
    return locus;
  });
}

TEST(ResumedWalksTest, OfNeimarkSackerPoints) {
  PowerOfMap map(
      [](const Vector &x, const Vector &keys) {
        const double a = keys(0), c = keys(1);
        Image image{vector({a * x(0) * (1 - x(1)) + c * x(0) * x(0), x(0)}), Matrix(2, 2),
                    Matrix::Zero(2, 2)};
        image.by_state << a * (1 - x(1)) + 2 * c * x(0), -a * x(0), 1, 0;
        image.by_keys.row(0) << x(0) * (1 - x(1)), x(0) * x(0);
        return image;
      },
      vector({1, 1, 1, 1}));
  expect_goes_on_anywhere(map, [](Problem &problem, StepRecord *record) {
    return follow_locus(
        problem, {LocusKind::neimark_sacker, {vector({0.5, 0.5}), vector({2, 0})}, {}, false},
        within({0, 10}, {-8, 2}), {}, record);
  });
}

TEST(ResumedWalksTest, OutcomesOfAnotherProgramAreRefused) {
  PowerOfMap map(logistic_map, vector({1, 1}));
  const Start start{{vector({0.5}), vector({2})}, {}, true};
  StepsInMemory all;
  follow(map, start, within({1.5, 2.5}), {}, &all);
  std::vector<std::string> others = all.fresh;
  ASSERT_GT(others.size(), 3u);
  std::swap(others[1], others[2]);
  StepsInMemory record(others);
  EXPECT_THROW(follow(map, start, within({1.5, 2.5}), {}, &record), std::runtime_error);
}

} // namespace resumed_walks_tests
} // namespace vibroimpact::continuation
