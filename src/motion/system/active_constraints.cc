#include "motion/system/active_constraints.h"

#include "common/decompositions.h"

#include <algorithm>

namespace vibroimpact::motion {

Matrix gap_rows(const contact::ContactSet &contacts, const std::vector<std::size_t> &list,
                Index n) {
  Matrix rows(static_cast<Index>(list.size()), n);
  for (std::size_t k = 0; k < list.size(); ++k)
    rows.row(static_cast<Index>(k)) = contacts.pairs()[list[k]].gap.row;
  return rows;
}

// The two rates are of the size of the model's own, which any step resolves, and differ between the
// contacts, so that none is repeated.
ActiveConstraints::ActiveConstraints(const model::Model &model, const contact::ContactSet &contacts,
                                     const std::vector<int> &modes) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const contact::ContactPair &pair = contacts.pairs()[c];
    const contact::Mode &mode = pair.law->modes()[static_cast<std::size_t>(modes[c])];
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
  set_response(model.mass().cwiseInverse().asDiagonal() * rows_.transpose());
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
  factor_ = std::make_shared<const LeastNorm>(rows_ * response_);
}

Matrix ActiveConstraints::forces(const Matrix &missing) const { return factor_->solve(missing); }

} // namespace vibroimpact::motion
