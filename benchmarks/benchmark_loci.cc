// Cost of a locus of folds of 600 points beside the same done by hand with Boost.odeint, in one
// run.
//
//   benchmark_loci [repetitions]
//
// Exit code 1 when the two curves disagree; how fast anything is decides nothing.
#include "analyses/keys/keyed_map.h"
#include "common/error.h"
#include "continuation/locus.h"
#include "fold_by_hand.h"
#include "isolator_case.h"
#include "measurement.h"
#include "periodic/orbit_problem.h"
#include "petsc_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace vibroimpact::benchmarks {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int count = 600;
constexpr double distance = 0.002; ///< of neighbours, in (y, v, lambda, mu)
constexpr double wanted = 1e-8;    ///< of lambda at equal mu

const FoldPoint &start() {
  static const FoldPoint point{
      .state = {-0.0522658133518, -1.25248675663}, .frequency = 1.23127927195557, .stiffness = 2};
  return point;
}

/// Builds isolators of other stiffnesses.
class Isolators : public analyses::LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult /*result*/) override {}
  void skip() override {}
  analyses::System build(const std::vector<parameters::Override> &overrides) const override {
    return isolator_system(start().frequency, std::stod(overrides.front().value));
  }
};

std::vector<analyses::SweptParameter> keys() {
  return {{.path = {}, .values = {0.5 / (2 * pi), 2 / (2 * pi)}},
          {.path = "mu", .unit = "1", .values = {0.5, 3}}};
}

/// The program's own, without recorders.
continuation::Locus own_folds() {
  const Isolators context;
  analyses::System system = isolator_system(start().frequency);
  analyses::KeyedMap maps(keys(), "", system, context,
                          {.scale = Vector::Ones(2), .tolerance = 1e-10}, 1);
  periodic::OrbitProblem problem(maps, 1, Eigen::Vector4d(1, 1, 1 / (2 * pi), 1));
  continuation::Settings settings;
  settings.longest_step = settings.first_step = distance;
  settings.most_points = count;
  continuation::LocusStart from{
      .kind = continuation::LocusKind::fold, .point = {}, .graze = {}, .forward = false};
  from.point.state = start().state;
  from.point.keys = Eigen::Vector2d(start().frequency / (2 * pi), start().stiffness);
  return follow_locus(problem, from, settings);
}

// Cubic between two points of the locus, by their tangents; its error is below 1e-12.
double frequency_at(const continuation::Locus &locus, double mu) {
  for (std::size_t i = 1; i < locus.points.size(); ++i) {
    const continuation::LocusPoint &a = locus.points[i - 1], &b = locus.points[i];
    const double from = a.point.keys[1], length = b.point.keys[1] - from;
    const double x = (mu - from) / length, rest = 1 - x;
    if (x < 0 || x > 1)
      continue;
    const auto slope = [length](const continuation::LocusPoint &at) {
      return at.tangent[2] / at.tangent[3] * length;
    };
    return (1 + 2 * x) * rest * rest * 2 * pi * a.point.keys[0] + x * rest * rest * slope(a) +
           x * x * (3 - 2 * x) * 2 * pi * b.point.keys[0] - x * x * rest * slope(b);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double error_of(const std::vector<FoldPoint> &points, const continuation::Locus &truth) {
  double error = 0;
  int compared = 0;
  for (const FoldPoint &point : points)
    if (const double there = frequency_at(truth, point.stiffness); !std::isnan(there)) {
      error = std::max(error, std::abs(point.frequency - there));
      ++compared;
    }
  return compared > 9 * count / 10 ? error : std::numeric_limits<double>::infinity();
}

std::vector<FoldPoint> by_hand(double tolerance) {
  return folds_by_hand(start(), count, distance, tolerance);
}

// The loosest that brings the frequencies of all points to what is wanted.
double loosest_tolerance(const continuation::Locus &truth) {
  for (int third = -18; third >= -36; --third) {
    const double tolerance = std::pow(10.0, third / 3.0);
    try {
      const double error = error_of(by_hand(tolerance), truth);
      std::printf("odeint at tolerance %.1e: error %.1e\n", tolerance, error);
      if (error <= wanted)
        return tolerance;
    } catch (const NumericalError &) { // too loose for Newton's method to end
    }
  }
  throw NumericalError("odeint does not come to the same folds");
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void run(int repetitions) {
  const continuation::Locus truth = own_folds();
  if (static_cast<int>(truth.points.size()) != count)
    throw NumericalError("the locus ends early: " + truth.reason);
  const double tolerance = loosest_tolerance(truth);
  std::vector<double> own, theirs, ratios;
  for (int i = 0; i < repetitions; ++i) {
    own.push_back(cpu_time_of([&] { own_folds(); }));
    theirs.push_back(cpu_time_of([&] { by_hand(tolerance); }));
    ratios.push_back(theirs.back() / own.back());
  }
  std::printf("%d points: vibroimpact %.3g ms, odeint %.3g ms, times as fast %.3g\n", count,
              1e3 * median(own), 1e3 * median(theirs), median(ratios));
}

} // namespace

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  using namespace vibroimpact::benchmarks;
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 5;
  if (argc > 2 || repetitions < 1) {
    std::fprintf(stderr, "usage: benchmark_loci [repetitions]\n");
    return 2;
  }
  try {
    const PetscSession petsc("benchmark_loci");
    run(repetitions);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
