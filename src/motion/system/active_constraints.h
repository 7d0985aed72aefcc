// What the present modes of the contacts hold, as constraints of the equations of motion: gaps, and
// the slip rates of contacts that stick.
//
// With q'' = q''_free + M^-1 W^T F, row k of W that of the k-th held direction of a contact, the
// forces F follow from
//
//   gap'' + (a + b) gap' + a b gap = 0        a, b > 0 two rates of the contact [1/s]
//   slip'' + a slip' = 0                      sides that stick do so where they are
//
// Where a contact is held along its normal and slides, the friction -sigma mu F acts with F: its
// column is that of n - sigma mu t in place of n, and W M^-1 W_F^T is not symmetric.
//
// In a circular gap n and t turn with the place, and so do the rows; gap'' and slip'' have what
// that makes of the velocities (contact/circular_gap.h).
//
// A motion that starts with gap = gap' = 0 keeps both at zero, whatever a and b are; they make what
// rounding leaves die out instead of grow, and the two being different keeps the equations
// diagonalizable. Contacts that hold the same direction twice share the force: equally, or, where
// the limits of all sticks along two directions are constant, by these limits, so that sides which
// the contacts could hold together slip only where the sum of the limits is reached.
#pragma once

#include "common/decompositions.h"
#include "contact/contact_set.h"
#include "model/model.h"

#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// A direction of a contact: 0 the normal, 1, 2 tangential.
struct HeldDirection {
  std::size_t contact = 0;
  int direction = 0;
  double friction = 0; ///< tangential force per unit of the force that holds it
};

class ActiveConstraints {
public:
  ActiveConstraints() = default;
  /// For these modes of the contacts, and the model's constant mass matrix.
  ActiveConstraints(const model::Model &model, const contact::ContactSet &contacts,
                    const std::vector<int> &modes);

  bool empty() const { return held_.empty(); }
  Index size() const { return static_cast<Index>(held_.size()); }
  const HeldDirection &held(Index k) const { return held_[static_cast<std::size_t>(k)]; }
  bool holds(std::size_t contact) const;
  /// The place of a direction among those that are held; size(): it is not.
  Index place(std::size_t contact, int direction) const;

  const Matrix &rows() const { return rows_; }         ///< W
  const Matrix &along() const { return along_; }       ///< W_F
  const Matrix &response() const { return response_; } ///< M^-1 W_F^T
  /// Is there a circular gap among the contacts? Rows are those of the place given last.
  bool turn() const { return turn_; }
  /// `row` of a direction in a circular gap, and what its force acts along.
  void set_rows(Index k, const RowVector &row, const RowVector &along);
  /// Where rows turn or rotors change the mass matrix with the position.
  void set_response(const Matrix &response);

  double by_rate(Index k) const { return rates_(k, 0) + rates_(k, 1); }     ///< a + b [1/s]
  double by_position(Index k) const { return rates_(k, 0) * rates_(k, 1); } ///< a b [1/s^2]

  /// Forces for which the accelerations along what is held change by `missing`, column by column:
  /// (W M^-1 W_F^T)^-1 missing.
  Matrix forces(const Matrix &missing) const;

private:
  void weigh(const contact::ContactSet &contacts, const std::vector<int> &modes);

  std::vector<HeldDirection> held_;
  Matrix rows_, along_, response_;
  bool turn_ = false;
  Vector weights_;                          ///< of the shares in what is held twice, 1 at most
  Matrix rates_;                            ///< held directions x 2; b = 0: held where it is
  std::shared_ptr<const LeastNorm> factor_; ///< of W M^-1 W_F^T, columns weighted
};

/// Tangential force per unit of the force that holds the gap in a mode: of a contact that slides.
double friction_share(const contact::ContactPair &pair, int mode);

/// NumericalError where the force that holds the gap in a mode could not push the sides apart,
/// because the friction that goes with it presses them together (Painleve 1895): the motion has no
/// continuation or several. `alone`: n M^-1 n^T, `coupling`: n M^-1 t^T [1/kg].
void refuse_jamming(const contact::ContactPair &pair, double share, double alone, double coupling);
/// The same where the gap is plane.
void refuse_jamming(const model::Model &model, const contact::ContactPair &pair, int mode);

/// The gap rows of some contacts in plane gaps, one below the other.
Matrix gap_rows(const contact::ContactSet &contacts, const std::vector<std::size_t> &list, Index n);

} // namespace vibroimpact::motion
