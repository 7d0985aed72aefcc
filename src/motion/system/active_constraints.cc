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

// By the derivative that the law has by that force.
double friction_share(const contact::ContactPair &pair, int mode) {
  const contact::Mode &of = pair.law->modes()[static_cast<std::size_t>(mode)];
  if (!of.holds_gap || of.friction != contact::Friction::slip)
    return 0;
  if (of.affine)
    return of.affine->tangential_force[0].normal_force;
  contact::LawResponse response;
  pair.law->evaluate(mode, {.internal = pair.law->initial_internal(), .normal_force = 1}, response);
  return response.tangential[0].by.normal_force;
}

void refuse_jamming(const contact::ContactPair &pair, double share, double alone, double coupling) {
  constexpr double least = 1e-9;
  if (alone + share * coupling > least * alone)
    return;
  std::ostringstream text;
  text << "contact " << pair.name << " slides so that its friction presses the rigid sides "
       << "together more than their normal force can part them: the friction coefficient "
       << pair.law->impact_friction() << " is not below " << alone / std::abs(coupling)
       << " (Painleve); the motion has no continuation or several. Use a law with a finite "
       << "stiffness.";
  throw NumericalError(text.str());
}

void refuse_jamming(const model::Model &model, const contact::ContactPair &pair, int mode) {
  const double share = friction_share(pair, mode);
  if (share == 0)
    return;
  const RowVector mobility = pair.gap.row.cwiseQuotient(model.mass().transpose());
  refuse_jamming(pair, share, mobility.dot(pair.gap.row),
                 mobility.dot(pair.tangential.front().slip.row));
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
        held_.push_back({.contact = c,
                         .direction = d,
                         .friction = d == 0 ? friction_share(pair, modes[c]) : 0});
    turn_ = turn_ || (mode.holds() && pair.circle);
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
  along_ = rows_;
  weigh(contacts, modes);
  for (Index k = 0; k < size(); ++k)
    if (const double share = held(k).friction; share != 0)
      along_.row(k) += share * contacts.pairs()[held(k).contact].tangential.front().slip.row;
  set_response(model.mass().cwiseInverse().asDiagonal() * along_.transpose());
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

void ActiveConstraints::set_rows(Index k, const RowVector &row, const RowVector &along) {
  rows_.row(k) = row;
  along_.row(k) = along;
}

void ActiveConstraints::set_response(const Matrix &response) {
  response_ = response;
  factor_ = std::make_shared<const LeastNorm>(rows_ * response_ * weights_.asDiagonal());
}

Matrix ActiveConstraints::forces(const Matrix &missing) const {
  return weights_.asDiagonal() * factor_->solve(missing);
}

} // namespace vibroimpact::motion
