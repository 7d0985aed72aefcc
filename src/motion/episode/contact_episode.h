// A contact episode, from the touch to the end of its force, in one step.
//
// Two sides of a linear system x' = S x + b f meet at t0, where the penetration u(x) is zero and
// rises, and the force ends at t0 + T, where an affine form c of u and u' falls to zero: u where
// they part, another where the law cuts its force off. The force f = F(u, u') is t^alpha (T -
// t)^beta times a polynomial (force_family.h), so that u is a sum of integrals of its values f_j
// (forced_flow.h), with theta = T max|exponent|:
//
//   u(X)  = sum d_k (theta X)^k + T sum over k > 0 of g_k theta^k (I_k f)(X)
//   u'(X) = sum k d_k theta^k X^(k-1) / T + sum over k > 0 of g_k theta^k (I_(k-1) f)(X)
//
// Newton's method solves F(u_i, u_i') - f_i = 0 at the nodes and c(1) = 0 for f_j and ln T. With
// forces in units of S = m v / T (m = -1 / (g_1 max|exponent|) the mass that meets, v its speed)
// and lengths in v T the matrix has no dimension, and contacts of all speeds have nearly the same:
// its inverse is kept from contact to contact, as are the forces f T / (m v) and the length T
// v^((n-1)/(n+1)), exact for a power law between free bodies, as the first guess of the next one.
//
// The error is estimated from the tail a of f / w in the orthonormal polynomials of the family.
// Gauss nodes square it, unless what the force meets varies within the step:
//
//   error = a max(0.1 a, s),  s >= 0.1 of forces with roots of time or a cut-off, else
//   s = min(1, product over k = 1..m of h / (2 k - 1)),
//   h = T/2 max(dx/dxi) sqrt(max|exponent|^2 + 2 max(f/u) / m)
//
// s bounds the Legendre coefficient of order m of the kernel of the integral. The two factors 0.1
// are no bounds but found by trial: with them durations and release speeds of power laws, of
// Hunt-Crossley's and of Tsuji's law keep ten tolerances and less
// (tests/motion/contact_episode.cc). Gauss collocation and its order: Hairer, Norsett and Wanner
// 1993, section II.7. Between the nodes the force is a off, and the penetration, two integrals of
// what oscillates like the next polynomial, a / m^2.
//
// Where the normal turns, motion and force have two directions, those of the touch
// (forced_motion.h): f_j are vectors, F is one of both components of u and u', and the condition at
// the end sees the penetration, which is no component. In the frame of the touch what was learned
// serves at every place of the circumference.
#pragma once

#include "motion/episode/force_tools.h"
#include "motion/episode/forced_motion.h"

#include "contact/contact_law.h"

#include <array>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// Why a contact was not solved as a whole.
enum class Refusal {
  none,
  no_approach,   ///< the sides do not move together
  too_long,      ///< it would last beyond the instant given
  too_fast,      ///< the system turns too far within it for a Taylor series
  no_solution,   ///< Newton's method does not converge
  too_coarse,    ///< the error is too large with the most nodes
  several_humps, ///< the force may be zero before its end: that is not the first zero
  no_release,    ///< the sides do not move apart at its end
};

/// The form of penetration u [m] and its rate [m/s] that falls to zero where a force ends.
struct EndCondition {
  double constant = 0, by_penetration = 1, by_rate = 0;

  double operator()(double u, double rate) const {
    return constant + by_penetration * u + by_rate * rate;
  }
  bool at_release() const { return by_rate == 0; }
};

/// How long two free bodies of the effective mass [kg] touch that meet at `speed` [m/s], under an
/// elastic force [s].
double free_contact_duration(const contact::ElasticForce &elastic, double mass, double speed);

class ContactEpisode {
public:
  /// Coefficients of Taylor series that are made use of at most.
  static constexpr int most_terms = ForcedMotion::most_terms;

  /// What earlier contacts have taught; it may outlive what solves them.
  struct Taught {
    int nodes = 12, fewest_nodes = 8; ///< the latter were not too few
    int good_steps = 0;               ///< in a row, far below the tolerance
    bool has_shape = false, has_inverse = false;
    std::vector<double> shape{}; ///< f T / (m v)
    double length_scale = 0;     ///< T v^((n-1)/(n+1))
    Matrix inverse{};
  };

  /// Keeps references. Outputs have most_terms coefficients; `begin`, `end`: how the force begins
  /// and ends; `tolerance`: relative, of the impulse.
  ContactEpisode(const ForcedMotion &motion, const ContactForce &force,
                 const contact::ForceEdge &begin, const contact::ForceEdge &end, double tolerance,
                 std::shared_ptr<Taught> taught = std::make_shared<Taught>());

  /// Of the contacts to come; before, that is u = 0.
  void set_end(const EndCondition &condition) { condition_ = condition; }
  const EndCondition &end() const { return condition_; }

  /// Of the contact to come, where the normal turns.
  void turn_to(const TouchFrame &frame);

  /// Forgets what earlier contacts taught.
  void forget() { *taught_ = {}; }

  /// From x, where the penetration is zero but for rounding. `longest`: what the contact may last
  /// [s].
  Refusal solve(const double *x, double longest);

  // Of the contact solved last:
  double duration() const { return duration_; }                                  ///< T [s]
  double approach_speed() const { return speed_; }                               ///< v > 0 [m/s]
  double release_speed() const { return -rates_[static_cast<std::size_t>(n_)]; } ///< > 0 [m/s]
  double mass() const { return mass_; }   ///< that meets [kg]
  double error() const { return error_; } ///< estimated, over what is allowed
  int sweeps() const { return sweeps_; }  ///< evaluations of the law at all nodes
  int terms() const { return terms_; }    ///< Taylor coefficients used, from order 0
  int nodes() const { return n_; }
  ForceTools &tools() const { return *tools_; }
  /// f_j along a direction [N]
  const double *forces(int direction = 0) const {
    return forces_[static_cast<std::size_t>(direction)].data();
  }
  const double *penetrations() const {
    return penetrations_.data();
  }                                                               ///< at the nodes and the end [m]
  const double *rates() const { return rates_.data(); }           ///< the same [m/s]
  const Motions &motions() const { return motions_; }             ///< the same
  const ForceValues &law() const { return law_; }                 ///< at the nodes
  double impulse() const;                                         ///< of the normal force [N s]
  double pulling_impulse() const;                                 ///< of what pulls, >= 0 [N s]
  double dissipated() const { return integral(law_.dissipated); } ///< by the law [J]
  /// Of what begins and ends like the force, by its values at the nodes.
  double integral(const Instants &values) const;
  int n_directions() const { return d_; }
  /// (I_k f) along each direction, of each target for k < terms(), k running fastest: what
  /// ForcedFlow::add() takes.
  std::vector<double> moments(ForceOperators &operators) const;
  /// The same of the end alone.
  std::vector<double> end_moments() const;

private:
  using Responses = ByDirection<ByDirection<ForcedMotion::Coefficients>>;

  Refusal solve_with_present_nodes(double longest);
  bool begin(double longest);
  void read_free_motion(int terms);
  void guess();
  void guess_anew();
  void guess_by_path(const std::vector<Motions> &path, double step);
  Refusal iterate(double longest);
  bool choose_terms(double theta);
  bool series_ends() const;
  void evaluate();
  void add_free_motion();
  void add_forced_motion();
  void renew_higher_terms();
  void see_overlaps();
  void find_residual();
  void differentiate();
  void factorise();
  void add_law(Matrix &matrix) const;
  void add_end(Matrix &matrix) const;
  double correct();
  const double *normal_force() const { return d_ == 1 ? forces_[0].data() : law_.normal.data(); }
  int highest_count() const;
  Refusal judge();
  bool is_rough() const;
  bool ends_first() const;
  bool overlaps() const;
  double end_scale() const;
  void find_error();
  void choose_nodes(int nodes);
  void use_nodes(int nodes);
  void learn();

  ForcedMotion motion_;
  const int d_; ///< directions
  const ContactForce &force_;
  contact::ForceEdge begin_, end_;
  EndCondition condition_;
  double tolerance_, tolerance_of_newton_;
  double exponent_; ///< n

  ForceTools *tools_ = nullptr;
  int n_ = 0;
  std::shared_ptr<Taught> taught_;

  const double *start_ = nullptr;
  double speed_ = 0, mass_ = 0, duration_ = 0;
  double error_ = 0, error_between_ = 0; ///< over what is allowed
  int sweeps_ = 0, terms_ = 0, known_coefficients_ = 0;
  ByDirection<ForcedMotion::Coefficients> coefficients_{}; ///< d_k
  Responses powers_{};                                     ///< g_k theta^k
  Motions motions_;
  ByDirection<Instants> forces_{}, free_rates_{}, free_accelerations_{};
  Instants penetrations_{}, rates_{};
  Overlap end_overlap_;
  ByDirection<Instants> higher_{}, higher_rates_{}; ///< of the force, k > 1
  double changed_ = 0;      ///< by corrections since the higher terms were renewed
  double higher_share_ = 1; ///< of the higher terms in the motion
  ForceValues law_;
  Vector residual_, correction_, weighted_;
  ByDirection<ByDirection<Matrix>> by_force_, rate_by_force_; ///< [of][by], (nodes + 1) x nodes
  ByDirection<Vector> by_length_, rate_by_length_;            ///< by ln T, at fixed parts of it
};

} // namespace vibroimpact::motion
