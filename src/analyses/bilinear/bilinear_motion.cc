#include "analyses/bilinear/bilinear_motion.h"

#include "common/decompositions.h"
#include "common/zero.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr double zero = 1e-9; // of gaps and forces beside their largest values
constexpr double same = 1e-7; // angles of one motion [rad]
constexpr double determinant_rounding =
    1e-13;                   // of determinants beside the products they are made of
constexpr int halvings = 20; // of the first and the last cell of the grid

Matrix propagator(const Matrix &generator, double angle) { return exponential(generator * angle); }

/// The two conditions a + B [sin; cos] = 0 at one sigma, and the state before closing by u.
struct Conditions {
  Eigen::Matrix<double, 2, 3> by_phase; ///< [a B]; NaN where no motion is periodic
  Matrix before;                        ///< [X; I], size x 3

  double determinant() const { return by_phase.rightCols<2>().determinant(); }
  /// -adj(B) a
  Eigen::Vector2d solution() const {
    Eigen::Matrix2d adjugate;
    adjugate << by_phase(1, 2), -by_phase(0, 2), -by_phase(1, 1), by_phase(0, 1);
    return -adjugate * by_phase.col(0);
  }
};

/// Where x = F [x; u] repeats itself for each u: [X; I], or NaN.
Matrix fixed_points(const Matrix &map, Index states) {
  const Index size = map.rows();
  Matrix all(size, 3);
  all.bottomRows(3).setIdentity();
  const Matrix equations = Matrix::Identity(states, states) - map.topLeftCorner(states, states);
  const LuFactors<Matrix> factors(equations);
  if (factors.reciprocal_condition() > std::numeric_limits<double>::epsilon())
    all.topRows(states) = factors.solve(Matrix(map.topRightCorner(states, 3)));
  else
    all.topRows(states).setConstant(std::numeric_limits<double>::quiet_NaN());
  return all;
}

Conditions conditions(const TiedSystem &system, const Matrix &closed, const Matrix &open) {
  const Matrix tied = closed * system.closing();
  // u goes around once; its rows of the map are the identity.
  Conditions found{.by_phase = {}, .before = fixed_points(open * tied, system.states())};
  found.by_phase.row(0) = system.gap() * found.before;
  found.by_phase.row(1) = system.force() * tied * found.before;
  return found;
}

Conditions conditions(const TiedSystem &system, double sigma) {
  return conditions(system, propagator(system.closed(), sigma),
                    propagator(system.open(), full_turn - sigma));
}

/// det B + sign |adj(B) a|; zero where it is round-off.
double equation(const Conditions &at, int sign) {
  const double value = at.determinant() + sign * at.solution().norm();
  const double size = at.by_phase.row(0).norm() * at.by_phase.row(1).norm();
  return std::abs(value) > determinant_rounding * size ? value : 0;
}

struct Node {
  double sigma = 0;
  double plus = 0, minus = 0; ///< the two equations

  double of(int sign) const { return sign > 0 ? plus : minus; }
};

Node node(double sigma, const Conditions &at) {
  return {.sigma = sigma, .plus = equation(at, 1), .minus = equation(at, -1)};
}

/// Equal cells, the first and the last of them halved again and again towards the ends, since the
/// contact is short where it begins.
std::vector<Node> grid(const TiedSystem &system, std::size_t cells) {
  const double h = full_turn / static_cast<double>(cells);
  const Matrix open_step = propagator(system.open(), h);
  const Matrix closed_step = propagator(system.closed(), h);
  std::vector<Matrix> open{Matrix::Identity(system.size(), system.size())};
  while (open.size() < cells)
    open.push_back(open_step * open.back());
  std::vector<Node> nodes;
  for (int k = halvings; k > 0; --k)
    nodes.push_back(node(std::ldexp(h, -k), conditions(system, std::ldexp(h, -k))));
  Matrix closed = closed_step;
  for (std::size_t i = 1; i < cells; ++i) {
    nodes.push_back(node(static_cast<double>(i) * h, conditions(system, closed, open[cells - i])));
    closed = closed_step * closed;
  }
  for (int k = 1; k <= halvings; ++k)
    nodes.push_back(
        node(full_turn - std::ldexp(h, -k), conditions(system, full_turn - std::ldexp(h, -k))));
  return nodes;
}

double refined(const TiedSystem &system, const Node &a, const Node &b, int sign) {
  return zero_between([&](double sigma) { return equation(conditions(system, sigma), sign); },
                      a.sigma, b.sigma);
}

/// The unit vectors [sin; cos] that solve both conditions at a root: the solution of the linear
/// equations, or where they have none but zero both directions of the null space of B.
std::vector<Eigen::Vector2d> phases(const Conditions &at) {
  const Eigen::Vector2d solution = at.solution() / at.determinant();
  if (std::abs(solution.norm() - 1) < 1e-6)
    return {solution.normalized()};
  const SingularValues of = singular_values(at.by_phase.rightCols<2>());
  const Eigen::Vector2d free = of.right.col(1);
  const double size = at.by_phase.cwiseAbs().maxCoeff();
  if (of.values[1] < zero * size && at.by_phase.col(0).cwiseAbs().maxCoeff() < zero * size)
    return {free, -free};
  return {};
}

/// The unit vectors [sin; cos] at which the gap alone is zero, at most two.
std::vector<Eigen::Vector2d> phases_of_zero_gap(const Conditions &at) {
  const Eigen::Vector2d normal = at.by_phase.row(0).tail<2>();
  const double size = normal.norm(), distance = -at.by_phase(0, 0) / size;
  if (!(std::abs(distance) < 1))
    return {};
  const Eigen::Vector2d across = normal / size, along(-across[1], across[0]);
  const double half = std::sqrt(1 - distance * distance);
  return {distance * across + half * along, distance * across - half * along};
}

double spectral_radius(const Matrix &matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

/// Deviations over the period, with those of the instant of closing: at opening the force, and
/// with it y', is continuous, so that its instant changes nothing.
///
///   S = P + (A_closed y+ - P A_open y-) gap / (gap A_open y-)
double largest_multiplier(const TiedSystem &system, const Vector &before,
                          const BilinearMotion &motion) {
  const Vector rate = system.open() * before;
  const Matrix &after = motion.contact_angle > 0 ? system.closed() : system.open();
  Matrix closing = system.closing();
  closing += (after * motion.closed_start - system.closing() * rate) *
             (system.gap() / system.gap().dot(rate));
  const Matrix period = propagator(system.open(), full_turn - motion.contact_angle) *
                        propagator(system.closed(), motion.contact_angle) * closing;
  return spectral_radius(period.topLeftCorner(system.states(), system.states()));
}

std::string objection(const TiedSystem &system, const BilinearMotion &motion, std::size_t samples) {
  if (motion.closes && !(motion.approach_speed > 0))
    return "the sides separate where the contact closes";
  if (motion.closes && motion.contact_angle == 0 && system.force().dot(motion.closed_start) > 0)
    return "the contact opens although it pushes";
  const FormRange gap = ranges(system, motion, {system.gap()}, false, samples)[0];
  if (gap.minimum < -zero * std::max(gap.maximum, -gap.minimum))
    return "the sides overlap while the contact is open";
  const FormRange force = ranges(system, motion, {system.force()}, true, samples)[0];
  if (force.minimum < -zero * std::max(force.maximum, -force.minimum))
    return "the contact pulls while it is tied";
  return {};
}

BilinearMotion motion_at(const TiedSystem &system, double sigma, const Conditions &at,
                         const Eigen::Vector2d &phase) {
  BilinearMotion motion{.closes = true,
                        .contact_angle = sigma,
                        .closing_phase = std::atan2(phase[0], phase[1]),
                        .closed_start = {},
                        .open_start = {}};
  if (motion.closing_phase < 0)
    motion.closing_phase += full_turn;
  const Vector before = at.before * Vector3(1, phase[0], phase[1]);
  motion.closed_start = system.closing() * before;
  motion.open_start = propagator(system.closed(), sigma) * motion.closed_start;
  motion.approach_speed = -system.gap_rate().dot(before) * system.angular_frequency();
  motion.largest_multiplier = largest_multiplier(system, before, motion);
  return motion;
}

bool known(const std::vector<BilinearMotion> &motions, const BilinearMotion &motion) {
  return std::any_of(motions.begin(), motions.end(), [&](const BilinearMotion &other) {
    return std::abs(other.contact_angle - motion.contact_angle) < same &&
           std::abs(std::remainder(other.closing_phase - motion.closing_phase, full_turn)) < same;
  });
}

void add_always_open(const TiedSystem &system, std::vector<BilinearMotion> &motions) {
  const Matrix period = propagator(system.open(), full_turn);
  const Vector y = fixed_points(period, system.states()) * Vector3(1, 0, 1);
  if (y.allFinite())
    motions.push_back({.contact_angle = 0,
                       .closed_start = y,
                       .open_start = y,
                       .largest_multiplier = spectral_radius(
                           period.topLeftCorner(system.states(), system.states()))});
}

// The tied equations keep any constant gap; the one that is zero is asked for beside the period.
void add_always_tied(const TiedSystem &system, std::vector<BilinearMotion> &motions) {
  const Index n = system.states();
  const Matrix period = propagator(system.closed(), full_turn);
  const Vector3 u(1, 0, 1);
  Matrix equations(n + 2, n);
  Vector right(n + 2);
  equations << Matrix::Identity(n, n) - period.topLeftCorner(n, n), system.gap().head(n),
      system.gap_rate().head(n);
  right << period.topRightCorner(n, 3) * u, -system.gap().tail(3).dot(u),
      -system.gap_rate().tail(3).dot(u);
  const PivotedQr factors(equations);
  if (factors.rank() < n)
    return;
  Vector y(n + 3);
  y << factors.solve(right), u;
  const Matrix map = period * system.closing();
  motions.push_back({.contact_angle = full_turn,
                     .closed_start = y,
                     .open_start = y,
                     .largest_multiplier = spectral_radius(map.topLeftCorner(n, n))});
}

void add_bilinear(const TiedSystem &system, std::size_t cells,
                  std::vector<BilinearMotion> &motions) {
  const std::vector<Node> nodes = grid(system, cells);
  for (std::size_t i = 1; i < nodes.size(); ++i)
    for (const int sign : {1, -1})
      if (nodes[i - 1].of(sign) * nodes[i].of(sign) < 0) {
        const double sigma = refined(system, nodes[i - 1], nodes[i], sign);
        const Conditions at = conditions(system, sigma);
        for (const Eigen::Vector2d &phase : phases(at))
          if (BilinearMotion motion = motion_at(system, sigma, at, phase); !known(motions, motion))
            motions.push_back(std::move(motion));
      }
}

void add_parting_at_once(const TiedSystem &system, std::vector<BilinearMotion> &motions) {
  const Conditions at = conditions(system, 0);
  for (const Eigen::Vector2d &phase : phases_of_zero_gap(at))
    motions.push_back(motion_at(system, 0, at, phase));
}

} // namespace

std::vector<BilinearMotion> bilinear_motions(const TiedSystem &system, std::size_t cells,
                                             std::size_t samples) {
  std::vector<BilinearMotion> motions;
  add_bilinear(system, cells, motions);
  add_parting_at_once(system, motions);
  add_always_open(system, motions);
  add_always_tied(system, motions);
  for (BilinearMotion &motion : motions)
    motion.objection = objection(system, motion, samples);
  return motions;
}

} // namespace vibroimpact::analyses
