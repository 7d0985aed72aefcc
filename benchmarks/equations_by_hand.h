// The systems as one would write them for a general solver: fixed arrays, no calls that the
// compiler cannot see through.
//
// Each has modes, one per contact, that whoever locates the contact changes switches by pass().
// guard(i) is positive while the present mode of contact i holds. What is recorded is a
// displacement, recorded_rate() its time derivative.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vibroimpact::benchmarks {

/// Unit mass between two massless bumpers that creep back by themselves, on a shaken base. State:
/// q, v, compression of the right and the left bumper.
struct Bumpers {
  static constexpr std::size_t size = 4, contacts = 2;
  using State = std::array<double, size>;
  enum Mode { open, touching, leaving };
  double xi = 0, gamma = 0, lambda = 0, delta = 0, beta = 0;
  std::array<Mode, contacts> modes{};
  std::array<long, contacts> begun{};
  long evaluations = 0;

  static double sign(std::size_t side) { return side == 0 ? 1 : -1; }
  double dashpot() const { return 2 * xi * gamma; }
  double base() const { return 2 * xi * std::sqrt(1 - xi * xi); }
  double omega() const { return beta; }
  double highest_frequency() const { return std::max(beta, std::sqrt(1 + lambda)); }
  double force(std::size_t i, const State &x) const {
    return lambda * (sign(i) * x[0] - delta) + dashpot() * sign(i) * x[1];
  }
  bool is_touching(std::size_t i) const { return modes[i] == touching; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[1]; }
  double guard(std::size_t i, const State &x) const {
    if (modes[i] == touching)
      return force(i, x);
    return modes[i] == open ? delta + x[2 + i] - sign(i) * x[0]
                            : -dashpot() * sign(i) * x[1] - lambda * x[2 + i];
  }
  void pass(std::size_t i, State &x) {
    begun[i] += modes[i] == open;
    if (modes[i] != leaving)
      x[2 + i] = sign(i) * x[0] - delta;
    modes[i] = modes[i] == leaving ? open : static_cast<Mode>(modes[i] + 1);
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    dxdt[0] = x[1];
    dxdt[1] = -2 * xi * x[1] - x[0] - base() * std::sin(beta * time);
    for (std::size_t i = 0; i < contacts; ++i)
      if (modes[i] == touching) {
        dxdt[1] -= sign(i) * force(i, x);
        dxdt[2 + i] = sign(i) * x[1];
      } else {
        dxdt[2 + i] = -lambda / dashpot() * x[2 + i];
      }
  }
};

/// Unit mass between two stops at |y| = 1, each a spring and a dashpot. State: y, y'.
struct Isolator {
  static constexpr std::size_t size = 2, contacts = 2;
  using State = std::array<double, size>;
  double zeta0 = 0, zeta1 = 0, mu = 0, amplitude = 0, forcing = 0;
  std::array<bool, contacts> touching{};
  std::array<long, contacts> begun{};
  long evaluations = 0;

  static double sign(std::size_t side) { return side == 0 ? 1 : -1; }
  double omega() const { return forcing; }
  double highest_frequency() const { return std::max(forcing, std::sqrt(1 + mu)); }
  bool is_touching(std::size_t i) const { return touching[i]; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[1]; }
  double guard(std::size_t i, const State &x) const {
    const double gap = 1 - sign(i) * x[0];
    return touching[i] ? -gap : gap;
  }
  void pass(std::size_t i, State & /*x*/) {
    touching[i] = !touching[i];
    begun[i] += touching[i];
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    dxdt[0] = x[1];
    dxdt[1] = amplitude * std::sin(forcing * time) - 2 * zeta0 * x[1] - x[0];
    for (std::size_t i = 0; i < contacts; ++i)
      if (touching[i])
        dxdt[1] -= mu * (x[0] - sign(i)) + 2 * zeta1 * x[1];
  }
};

/// Two masses on a shaken table that meet across a gap. State: both displacements relative to the
/// table, their rates.
struct Bilinear {
  static constexpr std::size_t size = 4, contacts = 1;
  using State = std::array<double, size>;
  std::array<double, 2> mass{}, damping{}, stiffness{};
  double penalty = 0, gap = 0, base = 0, forcing = 0;
  bool touching = false;
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const {
    return std::max(forcing, std::sqrt(penalty / mass[0] + penalty / mass[1]));
  }
  double distance(const State &x) const { return gap + x[1] - x[0]; }
  bool is_touching(std::size_t /*i*/) const { return touching; }
  double recorded(const State &x, double time) const {
    return x[0] + base * std::sin(forcing * time);
  }
  double recorded_rate(const State &x, double time) const {
    return x[2] + base * forcing * std::cos(forcing * time);
  }
  double guard(std::size_t /*i*/, const State &x) const {
    return touching ? -distance(x) : distance(x);
  }
  void pass(std::size_t i, State & /*x*/) {
    touching = !touching;
    begun[i] += touching;
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    const double inertial = base * forcing * forcing * std::sin(forcing * time);
    const double force = touching ? -penalty * distance(x) : 0;
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = inertial - (damping[0] * x[2] + stiffness[0] * x[0] + force) / mass[0];
    dxdt[3] = inertial - (damping[1] * x[3] + stiffness[1] * x[1] - force) / mass[1];
  }
};

/// A damper of mass m2 on a driven floor of mass m1, with Hertz contact on both sides. State: both
/// displacements, their rates.
struct Absorber {
  static constexpr std::size_t size = 4, contacts = 2;
  using State = std::array<double, size>;
  double m1 = 0, k1 = 0, c1 = 0, m2 = 0, k2 = 0, c2 = 0;
  std::array<double, contacts> clearance{}; // left, right
  double hertz = 0, amplitude = 0, forcing = 0;
  std::array<bool, contacts> touching{};
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const { return std::max(forcing, std::sqrt(k2 / m2)); }
  double distance(std::size_t i, const State &x) const {
    return clearance[i] + (i == 0 ? x[1] - x[0] : x[0] - x[1]);
  }
  bool is_touching(std::size_t i) const { return touching[i]; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[2]; }
  double guard(std::size_t i, const State &x) const {
    return touching[i] ? -distance(i, x) : distance(i, x);
  }
  void pass(std::size_t i, State & /*x*/) {
    touching[i] = !touching[i];
    begun[i] += touching[i];
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    double on_damper = k2 * (x[0] - x[1]) + c2 * (x[2] - x[3]);
    for (std::size_t i = 0; i < contacts; ++i)
      if (touching[i]) {
        const double u = std::max(0.0, -distance(i, x));
        on_damper += (i == 0 ? 1 : -1) * hertz * u * std::sqrt(u);
      }
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = (amplitude * std::cos(forcing * time) - k1 * x[0] - c1 * x[2] - on_damper) / m1;
    dxdt[3] = on_damper / m2;
  }
};

/// Hertz contact with Hunt-Crossley damping.
struct HertzHeads {
  double hertz = 0, dissipation = 0;
  double operator()(double penetration, double rate) const {
    const double u = std::max(0.0, penetration);
    return hertz * u * std::sqrt(u) * std::max(0.0, 1 + dissipation * rate);
  }
};

struct LinearSpring {
  double stiffness = 0;
  double operator()(double penetration, double /*rate*/) const { return stiffness * penetration; }
};

/// Damped beams in n modal coordinates of unit modal mass, a force at the tip of the first, which
/// has the first `n_driven` of them; one contact at the tips, gap = clearance + row . q.
template <std::size_t n, std::size_t n_driven, class Law> struct ModalBeams {
  static constexpr std::size_t size = 2 * n, contacts = 1;
  using State = std::array<double, size>;
  std::array<double, n> squared_frequency{}, damping{}, row{};
  Law law{};
  double clearance = 0, amplitude = 0, forcing = 0;
  bool touching = false;
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const {
    return std::sqrt(*std::max_element(squared_frequency.begin(), squared_frequency.end()));
  }
  bool is_touching(std::size_t /*i*/) const { return touching; }
  // The motion of the driven beam closes the gap.
  static double driven(const std::array<double, n> &row, const double *q) {
    double sum = 0;
    for (std::size_t j = 0; j < n_driven; ++j)
      sum -= row[j] * q[j];
    return sum;
  }
  double recorded(const State &x, double /*time*/) const { return driven(row, x.data()); }
  double recorded_rate(const State &x, double /*time*/) const { return driven(row, x.data() + n); }
  double product(const double *q) const {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += row[j] * q[j];
    return sum;
  }
  double guard(std::size_t /*i*/, const State &x) const {
    const double gap = clearance + product(x.data());
    return touching ? -gap : gap;
  }
  void pass(std::size_t i, State & /*x*/) {
    touching = !touching;
    begun[i] += touching;
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    const double force = touching ? law(-clearance - product(x.data()), -product(x.data() + n)) : 0;
    const double load = amplitude * std::sin(forcing * time);
    for (std::size_t j = 0; j < n; ++j) {
      dxdt[j] = x[n + j];
      dxdt[n + j] = force * row[j] - damping[j] * x[n + j] - squared_frequency[j] * x[j];
    }
    for (std::size_t j = 0; j < n_driven; ++j)
      dxdt[n + j] -= load * row[j];
  }
};

} // namespace vibroimpact::benchmarks
