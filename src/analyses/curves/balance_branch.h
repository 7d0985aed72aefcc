// Harmonic balance: motions as Fourier series of H harmonics of the forcing, followed along a key
// through their folds. An approximation to what a branch finds exactly; with H = 1 it is
// first-order averaging. The arrays are those of a branch.
#pragma once

#include "analyses/analysis.h"
#include "analyses/keys/branch_keys.h"

namespace vibroimpact::analyses {

class BalanceBranch : public Analysis {
public:
  struct Settings {
    SweptParameter parameter; ///< with the two ends as values
    double start_value = 0;   ///< of the key, unless it is a frequency [its unit]
    Directions directions = Directions::both;
    continuation::Settings continuation{};
    Index harmonics = 1;
    long samples = 0;          ///< of a period; 0: as many as `harmonics` need
    std::vector<double> guess; ///< coefficients by coordinates; empty: the linear response
    std::string excitation;    ///< whose period is that of the forcing; empty: the only one
    std::optional<parameters::Values> section{}; ///< for messages
  };
  explicit BalanceBranch(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "harmonic balance"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  std::vector<std::vector<parameters::Override>> variants() const override {
    return end_variants(settings_.parameter);
  }
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  Index intervals() const;
  void check_guess(const System &system) const;
  Matrix guess(Index coordinates) const;
  PointResult compute(System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
