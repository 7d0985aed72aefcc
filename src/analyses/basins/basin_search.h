// Follows motions of one system from many starts, and knows which periodic motions they lead to.
#pragma once

#include "analyses/run/system.h"
#include "periodic/attractors.h"
#include "periodic/interpolated_map.h"
#include "periodic/stroboscopic_map.h"

namespace vibroimpact::analyses {

/// How motions are followed until they are decided.
struct BasinSettings {
  periodic::AttractorSettings attractors; ///< `largest` is set from the starts
  std::string excitation; ///< whose period is that of the forcing; empty: the only one
};

void declare_basin_search(parameters::Section &section);
BasinSettings read_basin_search(const parameters::Values &section);

class BasinSearch {
public:
  /// InputError for rotors and without a periodic excitation.
  BasinSearch(System system, const BasinSettings &settings);
  BasinSearch(const BasinSearch &) = delete;
  BasinSearch &operator=(const BasinSearch &) = delete;

  const System &system() const { return system_; }

  /// Of which size starts are. Forgets all motions.
  void begin(const std::vector<model::InitialState> &starts);
  /// Of a start; failed too where no motion can start. A motion that is new joins the attractors.
  periodic::Decision follow(const model::InitialState &start);
  /// Puts the attractors in the order of the size of their states at phase 0, the smallest first.
  /// Returns the place of each one before.
  std::vector<std::size_t> sort();
  /// Keeps the first attractors only.
  void forget_after(std::size_t count) { attractors_->keep(count); }
  const periodic::Attractors &attractors() const { return *attractors_; }

  /// From now on approximate() goes from cell to cell by a map that is interpolated between so many
  /// nodes along each of two states, over 1.35 times the region of the starts. std::logic_error for
  /// other than two states.
  void interpolate(Index nodes);
  Index states() const { return forced_.layout().physical_size(); }
  periodic::Decision approximate(const model::InitialState &start);

  /// Physical state of an attractor at phase 0.
  Vector state(const periodic::Attractor &attractor) const {
    return attractor.motion.state.cwiseQuotient(map_.scale());
  }

private:
  Vector scaled_start(const model::InitialState &start);
  Vector seen_state();
  Vector image(const Vector &scaled);
  std::optional<periodic::FoundMotion> find(const Vector &scaled, long multiple);

  System system_;
  periodic::ForcedSystem forced_;
  periodic::StroboscopicMap map_;
  periodic::AttractorSettings settings_;
  Vector lowest_, highest_; ///< scaled states of the starts
  Vector present_;          ///< scaled state at which the trajectory stands; empty: not known
  long periods_ = 0;        ///< since the start of its motion, until there
  std::optional<periodic::Attractors> attractors_;
  std::optional<periodic::InterpolatedMap> interpolated_;
};

} // namespace vibroimpact::analyses
