// The symmetry of a model under odd forcing: one that vibrates between equal stops, or bodies that
// exchange their parts after half a period.
//
//   sigma x: coordinates and velocities change their sign, or equal bodies exchange theirs with or
//   without a change of sign; contacts exchange their internal states with those of their partner.
//   If sigma x(t + T/2) is a motion whenever x(t) is one, then
//
//   P = H^2,   H = sigma P_(T/2)
//
// with the stroboscopic map P of one period and P_(T/2) of half a period. Multipliers of P are the
// squares of those of H at motions that are symmetric themselves, H x = x. There the loss of
// symmetry is a multiplier -1 of H, like a period doubling, while P, whose multiplier is +1, is
// singular. (Swift & Wiesenfeld 1984: a symmetric motion cannot double its period.)
#pragma once

#include "periodic/forced_system.h"

#include <optional>

namespace vibroimpact::periodic {

class Symmetry {
public:
  /// Nothing where the model has none: a source with an even part, a contact whose gap is not that
  /// of a partner (which may be itself) after sigma, with the same clearance and the same law, or a
  /// motion that contradicts what follows from that. The change of sign alone comes first.
  /// Exchanges are looked for among up to eight bodies. `scale`: factors that make entries of a
  /// state comparable; `size`: of a state times its scale, at which motions and laws are compared.
  static std::optional<Symmetry> find(ForcedSystem &system, const Vector &scale, double size);

  /// sigma applied to each column.
  Matrix apply(const Matrix &columns) const;
  bool operator==(const Symmetry &other) const {
    return taken_from_ == other.taken_from_ && factor_ == other.factor_;
  }
  /// The contact that does half a period later what this one does.
  std::size_t partner(std::size_t contact) const { return partners_[contact]; }

private:
  /// Coordinates of body b become those of body `from[b]` times `sign`.
  Symmetry(const ForcedSystem &system, const std::vector<std::size_t> &from, double sign);
  bool matches(const contact::ContactPair &a, const contact::ContactPair &b) const;
  bool pair_contacts(const ForcedSystem &system, double size);
  bool holds(ForcedSystem &system, const Vector &scale, double size) const;

  std::vector<std::size_t> partners_; ///< by contact
  std::vector<Index> taken_from_;     ///< entry i of sigma x is factor_i x[taken_from_i]
  Vector factor_;
};

} // namespace vibroimpact::periodic
