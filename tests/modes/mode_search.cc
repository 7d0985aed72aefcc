// The search for the lowest modes where every eigenvalue is known: restarts, multiple eigenvalues,
// masses that are missing, and modes that a search has missed.
#include "modes/mode_search.h"

#include "modes/small_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace mode_search_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;
using modes::CompletePairs;
using modes::ModeSearch;

namespace {

void expect_eigenvalues(const CompletePairs &found, const std::vector<double> &exact,
                        std::size_t count, double tolerance = 1e-13) {
  ASSERT_EQ(found.pairs.values.size(), static_cast<Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    EXPECT_NEAR(found.pairs.values[static_cast<Index>(j)] / exact[j], 1, tolerance) << j;
    EXPECT_LE(found.pairs.values[static_cast<Index>(j)] / exact[j] - 1,
              found.error_bounds[static_cast<Index>(j)] + 1e-14)
        << j;
  }
}

std::vector<double> squares(int size) {
  std::vector<double> values(size);
  for (int i = 0; i < size; ++i)
    values[i] = (i + 1.0) * (i + 1.0);
  return values;
}

/// Approximate vectors of the lowest eigenvalues of single masses, without the `missing` ones.
modes::LowestVectors without(const SmallProblem &masses, const std::vector<double> &eigenvalues,
                             int count, const std::vector<int> &missing) {
  ModeSearch search(masses.problem());
  const CompletePairs all = search.lowest(count);
  std::vector<Index> kept;
  for (Index j = 0; j < all.pairs.values.size(); ++j)
    if (std::find(missing.begin(), missing.end(), j) == missing.end())
      kept.push_back(j);
  return {all.pairs.vectors(Eigen::all, kept), eigenvalues[count]};
}

} // namespace

TEST(ModeSearch, FindsTheModesOfAChain) {
  const int size = 400;
  const SmallProblem masses = chain(size);
  ModeSearch search(masses.problem());
  const CompletePairs found = search.lowest(15);
  std::vector<double> exact;
  for (int j = 0; j < 15; ++j)
    exact.push_back(chain_eigenvalue(size, j));
  expect_eigenvalues(found, exact, 15, 1e-11); // K itself has round-off of 1e-16 of the largest
  EXPECT_LT(found.error_bounds.maxCoeff(), 1e-11);
}

// 1000, 1001, ...: the first one is hardly nearer to the shift than the others, and the search
// restarts again and again.
TEST(ModeSearch, RestartsUntilClosePairsHaveConverged) {
  std::vector<double> eigenvalues(900);
  std::iota(eigenvalues.begin(), eigenvalues.end(), 1000.0);
  const SmallProblem masses = single_masses(eigenvalues);
  ModeSearch search(masses.problem());
  expect_eigenvalues(search.lowest(2), eigenvalues, 2);
}

// More equal ones than a block has columns: the search alone cannot tell how many there are.
TEST(ModeSearch, FindsAllOfSixAndOfTwentyEqualEigenvalues) {
  for (const int equal : {6, 20}) {
    std::vector<double> eigenvalues = squares(300);
    std::fill(eigenvalues.begin() + 3, eigenvalues.begin() + 3 + equal, 16.5);
    std::sort(eigenvalues.begin(), eigenvalues.end());
    const SmallProblem masses = single_masses(eigenvalues);
    ModeSearch search(masses.problem());
    const CompletePairs found = search.lowest(5);
    expect_eigenvalues(found, eigenvalues, 3 + equal);
  }
}

// Few different eigenvalues: the space of the start is exhausted before every copy is there.
TEST(ModeSearch, BeginsAnewWhereTheSpaceIsExhausted) {
  std::vector<double> eigenvalues(90);
  for (int i = 0; i < 90; ++i)
    eigenvalues[i] = 1.0 + i / 30;
  const SmallProblem masses = single_masses(eigenvalues);
  ModeSearch search(masses.problem());
  expect_eigenvalues(search.lowest(31), eigenvalues, 60);
}

TEST(ModeSearch, MassesThatAreMissingBearNoModes) {
  std::vector<double> eigenvalues = squares(60);
  SmallProblem masses = single_masses(eigenvalues);
  masses.mass = band_matrix(60, 0, [](int i, int) { return i < 8 ? 1.0 + i % 3 : 0.0; });
  masses.mass_rank = 8;
  ModeSearch search(masses.problem());
  expect_eigenvalues(search.lowest(4), eigenvalues, 4);
  expect_eigenvalues(search.lowest(8), eigenvalues, 8);
}

TEST(ModeSearch, CountsWhatIsBelow) {
  const std::vector<double> eigenvalues = squares(50);
  const SmallProblem masses = single_masses(eigenvalues);
  ModeSearch search(masses.problem());
  for (const double below : {0.5, 17.0, 90.0, 2400.0, 3.0})
    EXPECT_EQ(search.count_below(below),
              std::count_if(eigenvalues.begin(), eigenvalues.end(),
                            [&](double value) { return value < below; }));
}

TEST(ModeSearch, CopiesOfAProblemShareTheirFactorisation) {
  const std::vector<double> eigenvalues = squares(50);
  const SmallProblem masses = single_masses(eigenvalues);
  const modes::EigenProblem problem = masses.problem();
  const modes::EigenProblem copy = problem;
  const modes::Factorisation *first = &problem.factorised_at(0);
  EXPECT_EQ(copy.factorised_at(90).eigenvalues_below(), 9);
  EXPECT_EQ(&copy.factorised_at(0), first);
  const modes::Layout layout(problem.stiffness);
  const modes::Block ones = modes::Block::Ones(layout.own, 1);
  const modes::Block solution = problem.factorised_at(0).solve(ones);
  for (Index i = 0; i < layout.own; ++i) {
    const auto row = static_cast<int>(layout.own_begin + i);
    EXPECT_NEAR(solution(i, 0) * eigenvalues[row] * (1 + row % 3), 1, 1e-14);
  }
}

TEST(ModeSearch, FindsAMissingMode) {
  const std::vector<double> eigenvalues = squares(200);
  const SmallProblem masses = single_masses(eigenvalues);
  for (const std::vector<int> &missing : {std::vector<int>{0}, {7}, {11}, {2, 3, 9}}) {
    ModeSearch search(masses.problem());
    expect_eigenvalues(search.completed(without(masses, eigenvalues, 12, missing)), eigenvalues,
                       12);
  }
}

TEST(ModeSearch, FindsTheMissingOnesOfEqualEigenvalues) {
  std::vector<double> eigenvalues = squares(200);
  std::fill(eigenvalues.begin() + 4, eigenvalues.begin() + 10, 30.0);
  const SmallProblem masses = single_masses(eigenvalues);
  ModeSearch search(masses.problem());
  expect_eigenvalues(search.completed(without(masses, eigenvalues, 12, {5, 6, 8})), eigenvalues,
                     12);
}

TEST(ModeSearch, LeavesCompletePairsAlone) {
  const std::vector<double> eigenvalues = squares(100);
  const SmallProblem masses = single_masses(eigenvalues);
  ModeSearch search(masses.problem());
  expect_eigenvalues(search.completed(without(masses, eigenvalues, 10, {})), eigenvalues, 10);
}

} // namespace mode_search_tests
