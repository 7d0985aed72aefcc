// A contact law at many instants of one contact, as a function of what the contact sees of the
// motion: the penetration, and in a circular gap the way along the tangent at the touch too.
#pragma once

#include "contact/contact_law.h"

#include <array>
#include <vector>

namespace vibroimpact::motion {

/// Nodes of a step, and its end.
constexpr int most_targets = 36;
/// Directions along which a contact moves and acts.
constexpr int most_axes = 2;

using Instants = std::array<double, most_targets>;
template <class Entry> using ByDirection = std::array<Entry, most_axes>;

/// The motion by directions, one entry per instant. Direction 0 is the penetration, but for the
/// turning of the normal.
struct Motions {
  ByDirection<Instants> places{}; ///< [m]
  ByDirection<Instants> rates{};  ///< [m/s]
};

/// One entry per instant.
struct ForceValues {
  ByDirection<Instants> force{};                 ///< direction 0 pushes apart [N]
  ByDirection<ByDirection<Instants>> by_place{}; ///< [of][by] [N/m]
  ByDirection<ByDirection<Instants>> by_rate{};  ///< [N s/m]
  Instants dissipated{};                         ///< power [W]
  // Where the normal turns:
  Instants normal{}, tangential{}; ///< of the law [N]
  Instants friction_power{};       ///< the part that friction takes [W]
  Instants wear_power{};           ///< normal force times sliding speed [W]
};

/// Penetration u [m] and rate u' [m/s] with their partial derivatives by the motion.
struct Overlap {
  double penetration = 0, rate = 0;
  ByDirection<double> by_place{1, 0}, rate_by_place{}, rate_by_rate{1, 0};
};

class ContactForce {
public:
  virtual ~ContactForce() = default;
  virtual int n_directions() const { return 1; }
  /// At the first `count` <= most_targets instants. Where the sides do not overlap all values are
  /// zero.
  virtual void evaluate(int count, const Motions &at, ForceValues &values) const = 0;
  virtual Overlap overlap(const Motions &at, int instant) const;
  /// k, n of the elastic part k u^n, for the first guess of a contact.
  virtual contact::ElasticForce elastic() const = 0;
};

/// Of a contact law in one of its modes, with internal states that stay what they are in it.
class LawForce : public ContactForce {
public:
  /// Keeps a reference to the law, which has an elastic force.
  LawForce(const contact::ContactLaw &law, int mode);

  void set_internal(std::vector<double> internal) { internal_ = std::move(internal); }
  const std::vector<double> &internal() const { return internal_; }
  void evaluate(int count, const Motions &at, ForceValues &values) const override;
  contact::ElasticForce elastic() const override { return *law_.elastic_force(); }
  /// What the law sees; refers to the internal states.
  virtual contact::LocalState local(const Motions &at, int instant) const;

protected:
  const contact::ContactLaw &law() const { return law_; }
  int mode() const { return mode_; }
  std::vector<double> internal_;
  mutable contact::LawResponse response_;

private:
  const contact::ContactLaw &law_;
  int mode_;
};

} // namespace vibroimpact::motion
