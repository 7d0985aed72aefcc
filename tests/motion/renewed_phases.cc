// A phase of exact propagation under another excitation than before: what is renewed must be what a
// phase has that never knew another one, to the last bit.
#include "motion/path/exact_outputs.h"
#include "motion/phase/exact_change.h"
#include "motion/phase/exact_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vibroimpact::motion {
namespace renewed_phases_tests {

using model::ExponentialForm;

// Two masses between springs and dampers, the first on a stop that creeps: y = [q, v, stop].
Matrix system_matrix() {
  Matrix a = Matrix::Zero(5, 5);
  a.block(0, 2, 2, 2).setIdentity();
  a.row(2) << -3, 1, -0.1, 0.05, 0;
  a.row(3) << 1, -2, 0.05, -0.2, 0;
  a.row(4) << 0, 0, 0, 0, -0.7;
  return a;
}

std::vector<LinearSystem::Load> loads() {
  LinearSystem::Load load{
      .value = Vector::Zero(5), .rate = Vector::Zero(5), .acceleration = Vector::Zero(5)};
  load.value << 0, 0, 2, 0.5, 0.3;
  load.rate << 0, 0, 0.4, 0, 0;
  load.acceleration << 0, 0, -1, -1, 0;
  return {load};
}

GuardForms guards() {
  GuardForms forms{.rows = Matrix::Zero(2, 8), .constants = Vector::Zero(2)};
  forms.rows.row(0) << 1, -1, 0, 0, 0, 0.2, 0, 0;
  forms.rows.row(1) << 0, 1, 0.3, 0, 1, 0, 0.1, 0;
  forms.constants << 1, 2;
  return forms;
}

// A decaying vibration, a decay, and a parabola.
std::vector<ExponentialForm> sources(double frequency, double rate) {
  return {{.origin = 0,
           .terms = {{.amplitude = {1, 0.5}, .exponent = {rate, frequency}},
                     {.amplitude = 0.3, .exponent = 3 * rate}},
           .polynomial = {0.1, 0.2, 0.05}}};
}

std::unique_ptr<ExactPhase> make_phase() {
  const Vector constant = (Vector(5) << 0, 0, 1, -1, 0.2).finished();
  return std::make_unique<ExactPhase>(system_matrix(), constant, loads(), guards(), 4.0);
}

constexpr int levels[] = {0, 3, 8};

void make_levels(const ExactPhase &phase) {
  for (const int k : levels)
    if (!phase.view().levels[k].turn)
      phase.view().make_level(phase.view().owner, k);
}

std::vector<double> contents(const double *list, std::size_t count) { return {list, list + count}; }

void expect_same(const ExactPhase &one, const ExactPhase &other) {
  const PhaseView &a = one.view();
  const PhaseView &b = other.view();
  const auto n = static_cast<std::size_t>(a.n_padded);
  ASSERT_EQ(a.n_padded, b.n_padded);
  EXPECT_EQ(one.columns(), other.columns());
  EXPECT_EQ(a.fastest, b.fastest);
  EXPECT_EQ(a.constant_weight, b.constant_weight);
  EXPECT_EQ(contents(a.rate, n), contents(b.rate, n));
  EXPECT_EQ(contents(a.frequency, n), contents(b.frequency, n));
  EXPECT_EQ(contents(a.rows, 16 * n), contents(b.rows, 16 * n));
  EXPECT_EQ(contents(a.sizes, 2 * n), contents(b.sizes, 2 * n));
  EXPECT_EQ(contents(a.second, 2 * n), contents(b.second, 2 * n));
  EXPECT_EQ(contents(a.third, 2 * n), contents(b.third, 2 * n));
  EXPECT_EQ(contents(a.weights, 2 * n), contents(b.weights, 2 * n));
  const auto table = 16 * static_cast<std::size_t>(a.n_groups + a.n_pairs);
  for (const int k : levels) {
    SCOPED_TRACE(k);
    EXPECT_EQ(contents(a.levels[k].turn, 2 * n), contents(b.levels[k].turn, 2 * n));
    EXPECT_EQ(contents(a.levels[k].growth, n), contents(b.levels[k].growth, n));
    EXPECT_EQ(contents(a.levels[k].table, table), contents(b.levels[k].table, table));
    EXPECT_EQ(contents(a.levels[k].bounds, 6 * n), contents(b.levels[k].bounds, 6 * n));
  }
}

TEST(RenewedPhasesTest, EqualPhasesThatAreNew) {
  Excitation changing;
  const auto renewed = make_phase();
  for (const double frequency : {0.5, 0.9, 2.0}) {
    changing.take(sources(frequency, -0.05 * frequency));
    renewed->take(changing);
    make_levels(*renewed);
    Excitation fresh;
    fresh.take(sources(frequency, -0.05 * frequency));
    const auto made = make_phase();
    made->take(fresh);
    make_levels(*made);
    expect_same(*renewed, *made);
  }
}

// A level that is not asked for under one excitation must have it all under the next but one.
TEST(RenewedPhasesTest, LevelsMissAnExcitation) {
  Excitation changing;
  const auto renewed = make_phase();
  for (const double frequency : {0.5, 0.9, 2.0}) {
    changing.take(sources(frequency, -0.1));
    renewed->take(changing);
    if (frequency != 0.9)
      make_levels(*renewed);
  }
  const auto made = make_phase();
  made->take(changing);
  make_levels(*made);
  expect_same(*renewed, *made);
}

// A Y + B = Y S: what an input drives goes on as its response says.
TEST(RenewedPhasesTest, ResponsesSolveTheEquations) {
  Excitation excitation;
  const auto phase = make_phase();
  for (const double frequency : {0.5, 2.0}) {
    excitation.take(sources(frequency, -0.1));
    phase->take(excitation);
    std::vector<double> x(static_cast<std::size_t>(excitation.size()));
    excitation.coordinates(0.3, x.data());
    const ExponentialForm source = sources(frequency, -0.1)[0];
    const auto response = [&](double time) {
      excitation.coordinates(time, x.data());
      Vector rows = Vector::Zero(8);
      for (std::size_t k = 0; k < x.size(); ++k)
        rows += x[k] * phase->columns().col(5 + static_cast<Index>(k));
      return rows;
    };
    const Vector rows = response(0.3);
    EXPECT_NEAR(rows[5], source.value(0.3), 1e-14);
    EXPECT_NEAR(rows[6], source.rate(0.3), 1e-14);
    EXPECT_NEAR(rows[7], source.acceleration(0.3), 1e-14);
    const LinearSystem::Load load = loads()[0];
    const Vector constant = (Vector(5) << 0, 0, 1, -1, 0.2).finished();
    const Vector rates = system_matrix() * rows.head(5) + constant + load.value * rows[5] +
                         load.rate * rows[6] + load.acceleration * rows[7];
    constexpr double h = 1e-3; // differences of order h^4
    const Vector differences = (8 * (response(0.3 + h) - response(0.3 - h)) -
                                (response(0.3 + 2 * h) - response(0.3 - 2 * h))) /
                               (12 * h);
    EXPECT_LT((differences.head(5) - rates).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(RenewedPhasesTest, ChangesBetweenThemEqualNewOnes) {
  const auto from = make_phase();
  const auto to =
      std::make_unique<ExactPhase>(1.5 * system_matrix(), Vector::Zero(5), loads(), guards(), 4.0);
  PhaseForms::Reset reset{.entry = 4, .form = {.row = RowVector::Zero(8), .constant = 0.1}};
  reset.form.row << 1, 0, 0, 0, 0, 0.5, 0, 0;
  const std::vector<PhaseForms::Reset> resets = {reset};
  Excitation excitation;
  std::unique_ptr<ExactChange> renewed;
  for (const double frequency : {0.5, 2.0}) {
    excitation.take(sources(frequency, -0.1));
    from->take(excitation);
    to->take(excitation);
    if (renewed)
      renewed->renew();
    else
      renewed = std::make_unique<ExactChange>(*from, resets, *to);
  }
  const ExactChange made(*from, resets, *to);
  const auto n = static_cast<std::size_t>(made.view().n_padded);
  const auto count = static_cast<std::size_t>(made.view().n_columns);
  // What rounding is measured by is no less than what it is the rounding of.
  for (std::size_t j = 0; j < n; ++j)
    EXPECT_GE(made.view().constant_sizes[j],
              std::max(std::abs(made.view().constant[j]), std::abs(made.view().constant[n + j])));
  EXPECT_EQ(contents(renewed->view().columns, 2 * n * count),
            contents(made.view().columns, 2 * n * count));
  EXPECT_EQ(contents(renewed->view().magnitudes, n * count),
            contents(made.view().magnitudes, n * count));
}

// Only an excitation of another structure takes a new arrangement.
TEST(RenewedPhasesTest, KeepTheirArrangement) {
  Excitation changing;
  const auto phase = make_phase();
  changing.take(sources(0.5, -0.05));
  phase->take(changing);
  const long arrangement = phase->arrangement();
  changing.take(sources(0.9, -0.09));
  phase->take(changing);
  EXPECT_EQ(phase->arrangement(), arrangement);
  changing.take({{.origin = 0, .terms = {{.amplitude = 1, .exponent = {0, 2}}}, .polynomial = {}}});
  phase->take(changing);
  EXPECT_NE(phase->arrangement(), arrangement);
}

} // namespace renewed_phases_tests
} // namespace vibroimpact::motion
