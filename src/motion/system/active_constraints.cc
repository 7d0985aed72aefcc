#include "motion/system/active_constraints.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vibroimpact::motion {

Matrix gap_rows(const contact::ContactSet &contacts, const std::vector<std::size_t> &list,
                Index n) {
  Matrix rows(static_cast<Index>(list.size()), n);
  for (std::size_t k = 0; k < list.size(); ++k)
    rows.row(static_cast<Index>(k)) = contacts.pairs()[list[k]].gap.row;
  return rows;
}

RowVector holding_row(const contact::ContactPair &pair, const contact::Mode &mode) {
  RowVector row = pair.gap.row;
  for (std::size_t k = 0; mode.affine && k < pair.tangential.size(); ++k)
    if (const double share = mode.affine->tangential_force[k].normal_force; share != 0)
      row += share * pair.tangential[k].slip.row;
  return row;
}

void refuse_jamming(const model::Model &model, const contact::ContactPair &pair,
                    const contact::Mode &mode) {
  if (!mode.holds_gap || mode.friction != contact::Friction::slip)
    return;
  constexpr double least = 1e-9;
  const RowVector mobility = pair.gap.row.cwiseQuotient(model.mass().transpose());
  const double alone = mobility.dot(pair.gap.row);
  if (mobility.dot(holding_row(pair, mode)) > least * alone)
    return;
  const double coupling = mobility.dot(pair.tangential.front().slip.row);
  std::ostringstream text;
  text << "contact " << pair.name << " slides so that its friction presses the rigid sides "
       << "together more than their normal force can part them: the friction coefficient "
       << pair.law->impact_friction() << " is not below " << alone / std::abs(coupling)
       << " (Painleve); the motion has no continuation or several. Use a law with a finite "
       << "stiffness.";
  throw NumericalError(text.str());
}

namespace {

const contact::Mode &mode_of(const contact::ContactSet &contacts, std::size_t contact,
                             const std::vector<int> &modes) {
  return contacts.pairs()[contact].law->modes()[static_cast<std::size_t>(modes[contact])];
}

} // namespace

// The two rates are of the size of the model's own, which any step resolves, and differ between the
// contacts, so that none is repeated.
ActiveConstraints::ActiveConstraints(const model::Model &model, const contact::ContactSet &contacts,
                                     const std::vector<int> &modes) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const contact::ContactPair &pair = contacts.pairs()[c];
    const contact::Mode &mode = mode_of(contacts, c, modes);
    for (int d = 0; d < pair.n_directions(); ++d)
      if (mode.holds(d))
        held_.push_back({.contact = c, .direction = d});
  }
  if (held_.empty())
    return;
  const double highest = model.highest_frequency() > 0 ? model.highest_frequency() : 1;
  const Vector offsets = 0.0713 * Vector::LinSpaced(size(), 0, static_cast<double>(size() - 1));
  rates_.resize(size(), 2);
  rates_ << highest * (0.61 + offsets.array()), highest * (1.27 + offsets.array());
  rows_.resize(size(), model.size());
  for (Index k = 0; k < size(); ++k) {
    rows_.row(k) = contacts.pairs()[held(k).contact].along(held(k).direction).projection->row;
    if (held(k).direction > 0)
      rates_(k, 1) = 0;
  }
  weigh(contacts, modes);
  Matrix along = rows_;
  for (Index k = 0; k < size(); ++k)
    if (held(k).direction == 0)
      along.row(k) =
          holding_row(contacts.pairs()[held(k).contact], mode_of(contacts, held(k).contact, modes));
  set_response(model.mass().cwiseInverse().asDiagonal() * along.transpose());
}

// The least sum of |F_k|^2 / w_k^2 has shares that go as w_k^2. A weight far below the others would
// make what its contact alone holds seem to be held by none.
void ActiveConstraints::weigh(const contact::ContactSet &contacts, const std::vector<int> &modes) {
  constexpr double least = 1e-3;
  weights_.setOnes(size());
  Vector limits = Vector::Zero(size());
  for (Index k = 0; k < size(); ++k) {
    const auto &circle = mode_of(contacts, held(k).contact, modes).limit;
    if (held(k).direction == 0 || !circle)
      continue;
    contact::AffineForm varying = circle->radius;
    varying.constant = 0;
    if (!varying.zero())
      return;
    limits[k] = circle->radius.constant;
  }
  if (limits.size() > 0 && limits.maxCoeff() > 0)
    weights_ =
        (limits.array() > 0).select((limits / limits.maxCoeff()).cwiseSqrt().cwiseMax(least), 1.0);
}

bool ActiveConstraints::holds(std::size_t contact) const {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const HeldDirection &held) { return held.contact == contact; });
}

Index ActiveConstraints::place(std::size_t contact, int direction) const {
  return std::find_if(held_.begin(), held_.end(),
                      [&](const HeldDirection &held) {
                        return held.contact == contact && held.direction == direction;
                      }) -
         held_.begin();
}

void ActiveConstraints::set_response(const Matrix &response) {
  response_ = response;
  factor_ = std::make_shared<const LeastNorm>(rows_ * response_ * weights_.asDiagonal());
}

Matrix ActiveConstraints::forces(const Matrix &missing) const {
  return weights_.asDiagonal() * factor_->solve(missing);
}

} // namespace vibroimpact::motion
