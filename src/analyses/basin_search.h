// Follows motions of one system from many starts, and knows which periodic motions they lead to.
#pragma once

#include "analyses/system.h"
#include "periodic/attractors.h"
#include "periodic/stroboscopic_map.h"

namespace vibroimpact::analyses {

class BasinSearch {
public:
  /// `source`: whose period is that of the forcing. `settings.largest` is set by search().
  /// InputError for rotors.
  BasinSearch(System system, std::size_t source, const periodic::AttractorSettings &settings);
  BasinSearch(const BasinSearch &) = delete;
  BasinSearch &operator=(const BasinSearch &) = delete;

  const System &system() const { return system_; }
  double period() const { return forced_.period(); }

  /// Finds the periodic motions that these starts lead to and sorts them by the size of their
  /// states at phase 0, the smallest first.
  void search(const std::vector<model::InitialState> &starts);
  /// Keeps the first of them only.
  void forget_after(std::size_t count) { attractors_->keep(count); }
  /// Of a start; failed too where no motion can start.
  periodic::Decision follow(const model::InitialState &start);

  const periodic::Attractors &attractors() const { return *attractors_; }
  /// Physical state of an attractor at phase 0.
  Vector state(const periodic::Attractor &attractor) const {
    return attractor.motion.state.cwiseQuotient(map_.scale());
  }

private:
  Vector scaled_start(const model::InitialState &start);
  Vector image(const Vector &scaled);
  std::optional<periodic::FoundMotion> find(const Vector &scaled, long multiple);

  System system_;
  periodic::ForcedSystem forced_;
  periodic::StroboscopicMap map_;
  periodic::AttractorSettings settings_;
  std::optional<periodic::Attractors> attractors_;
};

} // namespace vibroimpact::analyses
