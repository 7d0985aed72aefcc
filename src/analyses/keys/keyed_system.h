// The system of an analysis at any values of some keys, and its neighbours along each.
#pragma once

#include "analyses/analysis.h"
#include "analyses/keys/swept_parameter.h"
#include "motion/variation/key_tangent.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Index of the excitation that gives an analysis its period: `name`, or the only one that repeats
/// when the name is empty. InputError when there is none, or one without a frequency. `who` needs
/// it: "A stepped sweep".
std::size_t sweep_source(const System &system, const std::string &name,
                         const std::string &who = "A stepped sweep");

/// The same for periodic motions; none where no excitation is named and none changes with time: the
/// period is then to be found.
std::optional<std::size_t> period_source(const System &system, const std::string &name,
                                         const std::string &who);

/// Four neighbours of the system at `value` of the key [its unit], a thousandth of the value apart
/// (of the largest of its values where it is zero), on both sides or, where the system cannot be
/// built on one of them (a clearance below zero, a restitution above one), on the other. InputError
/// when it cannot be built on either.
std::vector<motion::KeyNeighbour> key_neighbours(const SweptParameter &key, double value,
                                                 const SystemSource &build);

/// The same for the frequency [Hz] of an excitation that has one, which changes nothing else. The
/// given quantity keeps its amplitude and, at t = 0, its phase.
std::vector<motion::KeyNeighbour> frequency_neighbours(const std::shared_ptr<const System> &system,
                                                       std::size_t source);

class KeyedSystem {
public:
  /// Keeps references. A frequency is set in `system` itself; for other keys the systems are built
  /// by `context`. `excitation` and `who` as for sweep_source().
  KeyedSystem(std::vector<SweptParameter> keys, std::string excitation, std::string who,
              System &system, const LineContext &context);

  /// True when another system has been built, so that what belongs to the last one must go.
  /// InputError when it cannot be built, NumericalError at a frequency that is not positive.
  bool move_to(const Vector &values);

  /// Of the last move_to(), at first that of the analysis. Whoever refers to it keeps the pointer.
  const std::shared_ptr<System> &system() const { return present_; }
  /// The excitation that gives the period.
  std::size_t source() const { return sweep_source(*present_, excitation_, who_); }
  const std::vector<SweptParameter> &keys() const { return keys_; }
  /// Of the present system, which is that at `values`, along one key. InputError.
  std::vector<motion::KeyNeighbour> neighbours(const Vector &values, Index key) const;

private:
  std::vector<parameters::Override> overrides(const Vector &values) const;
  void set_frequency(System &system, const Vector &values) const;

  std::vector<SweptParameter> keys_;
  std::string excitation_, who_;
  const LineContext &context_;
  std::shared_ptr<System> present_;
  std::vector<parameters::Override> built_with_;
};

} // namespace vibroimpact::analyses
