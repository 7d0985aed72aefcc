// The model and its contacts at one value of a key as the equations of a harmonic balance: linear
// where no contact and no cubic spring acts, and these as its elements.
#pragma once

#include "contact/contact_set.h"
#include "continuation/harmonic_balance.h"
#include "periodic/harmonic_grid.h"

#include <map>
#include <memory>

namespace vibroimpact::periodic {

/// Grids by their number of harmonics, with intervals in proportion.
class HarmonicGrids {
public:
  HarmonicGrids(Index harmonics, Index intervals) : harmonics_{harmonics}, intervals_{intervals} {}
  const HarmonicGrid &at(Index harmonics);

private:
  Index harmonics_, intervals_;
  std::map<Index, HarmonicGrid> grids_;
};

/// Intervals of a period for H harmonics: 4 H, at least 16.
Index default_intervals(Index harmonics);

/// InputError for what harmonic balance cannot express: rotors, rigid contacts, a source that does
/// not repeat itself after the period of `source` or has harmonics above H, bodies that can move
/// without any force, and nothing but a linear model.
void check_harmonic(const model::Model &model, const contact::ContactSet &contacts,
                    std::size_t source, Index harmonics);

class HarmonicModel {
public:
  /// Keeps references.
  HarmonicModel(const model::Model &model, const contact::ContactSet &contacts, std::size_t source,
                HarmonicGrids &grids, Index harmonics);

  /// The elements are the contacts, with their gaps less the clearances, and the cubic springs.
  continuation::HarmonicEquations equations() const;
  continuation::ForceSeries force(Index element, const RowVector &displacement, bool slopes) const;
  /// A projection of the motion with the bases that move, 2 H + 1.
  RowVector observed(const model::Projection &projection, const Matrix &coordinates) const;
  double frequency() const; ///< [rad/s]

private:
  continuation::ForceSeries contact_force(std::size_t contact, const RowVector &opening,
                                          bool slopes) const;
  continuation::ForceSeries spring_force(const model::Connection &spring,
                                         const RowVector &elongation) const;

  const model::Model &model_;
  const contact::ContactSet &contacts_;
  std::size_t source_;
  HarmonicGrids &grids_;
  Index harmonics_;
  Matrix sources_; ///< series of s(t): sources x (2 H + 1)
  std::vector<const model::Connection *> cubic_;
};

} // namespace vibroimpact::periodic
