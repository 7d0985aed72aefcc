// Periodic motions of a system that no excitation times, by their energy: nonlinear modes.
//
//   M q'' + (C - xi M) q' + K q + contact forces = f,   x(T) = x(0),   H(x(0)) = E
//
// Without losses xi = 0, and such motions are not isolated: there is one for each energy E
// (Rosenberg 1966; Kerschen, Peeters, Golinval & Vakakis 2009). With losses the self-excitation xi
// makes good what they take in a period (extended periodic motions, Krack 2015). The period is
// found by a plane across the motion (free_period.h), xi(x) by
//
//   H(y) = H(x),   y = P(x; xi)     =>   dxi = (g_x - g_y P_x) dx / (g_y P_xi),   g = dH/dx
//
// and the energy by moving along its own gradient, S the scales of the state:
//
//   Q(x; E) = y + d (E - H(x)) / (g_x d),   d = S^-2 g_x^T
//
// Fixed points of Q are motions of the energy E, and these only: from Q(x) = x follows H(x) = H(y)
// = H(x - c d), where H grows along d, and so c = 0. There g_x Q_x = 0, so that the eigenvalues of
// Q_x are the multipliers of motions of the same energy, with a 0 in the place of the 1 that
// belongs to the neighbours of other energies, beside that of the shift in time.
#pragma once

#include "periodic/orbit_problem.h"

#include <functional>
#include <memory>
#include <optional>

namespace vibroimpact::periodic {

/// Kinetic and stored energy less the work of constant loads, with its derivative by the state.
struct MechanicalEnergy {
  double value = 0; ///< [J]
  RowVector by_state{};
};

/// At a state; `sizes` of its entries, by which the derivative is a central difference, exact for
/// linear forces.
MechanicalEnergy mechanical_energy(const StroboscopicMap &map, const Vector &state,
                                   const Vector &sizes);

/// Where two multipliers of one meet, rounding moves each by its root.
constexpr double neutral = 1e-6;

enum class Losses {
  none,    ///< NumericalError where energy is lost
  balanced ///< by self-excitation
};

/// What is known of the last motions, by their states and energies: where those begin that are
/// near.
class EnergyMemory {
public:
  /// `sizes` as of EnergyOrbits::Rule; about the first motion.
  EnergyMemory(std::shared_ptr<FreePeriod> period, const Vector &sizes);

  double period() const { return period_->period(); }
  double excitation() const { return excitation_.period(); } ///< [1/s]
  void set_excitation(double rate) { excitation_.set_period(rate); }
  /// The present ones are those of this motion.
  void note(const Vector &motion);
  /// Takes those of the nearest one.
  void recall(const Vector &motion);
  std::vector<double> numbers() const;
  void restore(const std::vector<double> &numbers);

private:
  std::shared_ptr<FreePeriod> period_;
  FreePeriod excitation_{0}; ///< the same of another number
};

/// The key is the energy above that at rest.
class EnergyOrbits : public continuation::Problem {
public:
  struct Rule {
    Losses losses = Losses::none;
    double rest = 0; ///< energy at rest [J]
    Vector sizes{};  ///< what counts as one of each entry of the state and of the energy, n + 1
  };
  /// Keeps a reference. The key of the maps is the self-excitation [1/s]; without losses they are
  /// asked for zero only, and need no derivative by it. They must leave the period alone.
  EnergyOrbits(MapAlongKeys &maps, std::shared_ptr<EnergyMemory> memory, long halves, Rule rule);

  /// That of a motion [1/s].
  double self_excitation(const continuation::Point &point);
  long halves() const { return orbits_.halves(); }
  /// The motion, its image that by Q.
  Orbit orbit(const continuation::Point &point);
  /// That over which two half periods of the map go [s].
  double period(const continuation::Point &point);
  /// At its self-excitation, with its period; valid until the next call.
  const StroboscopicMap &map(const continuation::Point &point);

  Vector scales() const override { return rule_.sizes; }
  double neutral_margin() const override { return rule_.losses == Losses::none ? neutral : 0; }
  continuation::Evaluation evaluate(const continuation::Point &point) override;
  std::vector<continuation::ShorterReturn>
  shorter_returns(const continuation::Point &point) override;
  std::unique_ptr<continuation::Problem> doubled() override;
  double best_chart(const continuation::Point &point) override;
  /// With losses the energy is that at the section, so that it is another one there.
  continuation::Transfer transfer(const continuation::Point &point, double chart) override;
  std::vector<continuation::Graze> grazes_near(const continuation::Point &point) override;
  continuation::Extension extend(const continuation::Point &point,
                                 const continuation::Graze &graze) override;
  /// Periods of motions, and the last self-excitation.
  std::vector<double> remembered() const override;
  void remember(const std::vector<double> &numbers) override;

private:
  using Evaluate = std::function<continuation::Evaluation(const continuation::Point &excited)>;
  /// What a self-excitation that is off by a little changes to first order.
  struct Correction {
    double change = 0;
    RowVector by_state; ///< of the self-excitation, n
  };
  MechanicalEnergy energy(const Vector &state);
  continuation::Point excited(const continuation::Point &point);
  Correction missing(const continuation::Evaluation &at, const continuation::Point &point,
                     const MechanicalEnergy &begin);
  continuation::Evaluation at_returned_energy(const continuation::Point &point,
                                              const MechanicalEnergy &begin,
                                              const Evaluate &evaluate, Correction &last);
  void refuse_losses(const continuation::Evaluation &at, const continuation::Point &point,
                     const MechanicalEnergy &begin);
  void add_energy(continuation::Evaluation &at, const continuation::Point &point,
                  const MechanicalEnergy &begin) const;
  void take(const continuation::Point &point);
  Vector unknowns(const continuation::Point &point) const;

  MapAlongKeys &maps_;
  std::shared_ptr<EnergyMemory> memory_;
  OrbitProblem orbits_;
  Rule rule_;
  std::optional<continuation::Point> at_; ///< the last motion
};

} // namespace vibroimpact::periodic
