// A contact law at many instants of one contact, as a function of penetration and its rate.
#pragma once

#include "contact/contact_law.h"

#include <array>
#include <vector>

namespace vibroimpact::motion {

/// Nodes of a step, and its end.
constexpr int most_targets = 36;

/// One entry per instant.
struct ForceValues {
  std::array<double, most_targets> force{};          ///< pushes apart [N]
  std::array<double, most_targets> by_penetration{}; ///< [N/m]
  std::array<double, most_targets> by_rate{};        ///< by the rate of penetration [N s/m]
  std::array<double, most_targets> dissipated{};     ///< power [W]
};

class ContactForce {
public:
  virtual ~ContactForce() = default;
  /// At `count` <= most_targets instants; penetration [m] > 0 inside, rate [m/s] its derivative.
  /// Where the sides do not overlap all values are zero.
  virtual void evaluate(int count, const double *penetration, const double *rate,
                        ForceValues &values) const = 0;
  /// k, n of the elastic part k u^n, for the first guess of a contact.
  virtual contact::ElasticForce elastic() const = 0;
};

/// Of a contact law in one of its modes, with internal states that stay what they are in it.
class LawForce : public ContactForce {
public:
  /// Keeps a reference to the law, which has an elastic force.
  LawForce(const contact::ContactLaw &law, int mode);

  void set_internal(std::vector<double> internal) { internal_ = std::move(internal); }
  void evaluate(int count, const double *penetration, const double *rate,
                ForceValues &values) const override;
  contact::ElasticForce elastic() const override { return *law_.elastic_force(); }

private:
  const contact::ContactLaw &law_;
  int mode_;
  std::vector<double> internal_;
  mutable contact::LawResponse response_;
};

} // namespace vibroimpact::motion
