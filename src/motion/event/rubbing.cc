#include "motion/event/rubbing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

// Both entries of each contact of a list.
std::vector<Index> both_of(const std::vector<Index> &list) {
  std::vector<Index> places;
  for (const Index k : list)
    places.insert(places.end(), {2 * k, 2 * k + 1});
  return places;
}

} // namespace

bool Rubbing::holds(const Equations &equations, const std::vector<std::size_t> &contacts) {
  return std::ranges::any_of(contacts, [&](std::size_t c) {
    return equations.contacts().pairs()[c].law->impact_friction() > 0;
  });
}

Rubbing::Rubbing(const Equations &equations, const std::vector<std::size_t> &contacts, double time,
                 const Vector &state)
    : equations_(equations), contacts_(contacts) {
  const StateLayout &layout = equations.layout();
  const auto size = 2 * static_cast<Index>(contacts.size());
  rows_ = Matrix::Zero(size, layout.n);
  before_ = Vector::Zero(size);
  for (Index k = 0; k < size / 2; ++k) {
    const contact::LocalState local = equations.local_state(
        contacts_[static_cast<std::size_t>(k)], time, ConstVectorView(state.data(), state.size()));
    const contact::ContactLaw &law = *pair(k).law;
    friction_.push_back({.coefficient = law.impact_friction(), .at_rest = law.static_friction()});
    const auto row = [&](int direction) {
      return equations.row_along(contacts_[static_cast<std::size_t>(k)], direction, time,
                                 ConstVectorView(state.data(), state.size()));
    };
    rows_.row(2 * k) = row(0);
    before_[2 * k] = local.gap_rate;
    if (!has_friction(k))
      continue;
    rows_.row(2 * k + 1) = row(1);
    before_[2 * k + 1] = local.tangential.front().slip_rate;
  }
  carried_ = before_ - rows_ * state.segment(layout.velocity(), layout.n);
  response_ = equations.response_to(rows_, time, ConstVectorView(state.data(), state.size()));
  effect_ = rows_ * response_;
  after_ = before_;
  impulses_ = Vector::Zero(size);
  friction_work_ = rubbing_ = Vector::Zero(size / 2);
}

Vector Rubbing::of_normals(const Vector &all) {
  Vector some(all.size() / 2);
  for (Index k = 0; k < some.size(); ++k)
    some[k] = all[2 * k];
  return some;
}

Vector Rubbing::rates(const Vector &state) const {
  const StateLayout &layout = equations_.layout();
  return rows_ * state.segment(layout.velocity(), layout.n) + carried_;
}

void Rubbing::find(const std::vector<Index> &taking_part, const Vector &restitution) {
  const std::vector<Index> places = both_of(taking_part);
  contact::FrictionalImpact impact{.matrix = effect_(places, places),
                                   .rates = before_(places),
                                   .contacts = {},
                                   .restitution = restitution(taking_part),
                                   .hypotheses = {}};
  for (const Index k : taking_part) {
    impact.contacts.push_back(friction_[static_cast<std::size_t>(k)]);
    impact.hypotheses.push_back(pair(k).law->hypothesis());
  }
  const contact::FrictionalImpulses found = contact::frictional_impulses(impact);
  reduced_ = found.reduced;
  impulses_.setZero();
  friction_work_.setZero();
  rubbing_.setZero();
  by_rates_ = Matrix::Zero(before_.size(), before_.size());
  impulses_(places) = found.impulses;
  by_rates_(places, places) = found.by_rates;
  friction_work_(taking_part) = found.friction_work;
  rubbing_(taking_part) = found.rubbing;
  after_ = before_ + effect_ * impulses_;
  for (std::size_t i = 0; i < places.size(); ++i) // the rule itself, without rounding
    after_[places[i]] = found.after[static_cast<Index>(i)];
}

// The impulses take p . (v before + v after) / 2 from the energy of the bodies, and moving bases
// and surfaces put their share in.
void Rubbing::apply(Vector &state) const {
  const StateLayout &layout = equations_.layout();
  state.segment(layout.velocity(), layout.n) += response_ * impulses_;
  const Vector after = rates(state);
  for (Index k = 0; k < friction_work_.size(); ++k) {
    const auto contact = static_cast<Index>(contacts_[static_cast<std::size_t>(k)]);
    const auto both = Eigen::seqN(2 * k, 2);
    const double carried = -impulses_(both).dot(carried_(both));
    state[layout.impulse(contact)] += impulses_[2 * k];
    state[layout.contact_work(contact)] -= 0.5 * impulses_(both).dot(before_(both) + after(both));
    state[layout.input_work()] += carried;
    state[layout.absolute_input_work()] += std::abs(carried);
    if (!has_friction(k))
      continue;
    state[layout.friction_work(pair(k).sliding_place)] += friction_work_[k];
    state[layout.wear_work(pair(k).sliding_place)] += rubbing_[k];
  }
}

std::vector<int> Rubbing::modes_at_rest(const std::vector<RestingContact> &list,
                                        const Vector &accelerations, const Vector &state) const {
  std::vector<Index> resting;
  std::vector<contact::ContactFriction> friction;
  const Vector rates = this->rates(state);
  const auto mode_of_slip = [&](const RestingContact &of, double sign) {
    return pair(of.place).law->mode_by_slip(of.mode, {.tangential = {{{.slip_rate = sign}}}});
  };
  for (const RestingContact &of : list) {
    resting.push_back(of.place);
    friction.push_back(friction_[static_cast<std::size_t>(of.place)]);
    int &slides = friction.back().slides;
    slides = of.slides;
    if (const double slip = rates[2 * of.place + 1];
        has_friction(of.place) && std::abs(slip) > of.slow)
      slides = slip > 0 ? 1 : -1;
    if (slides != 0)
      refuse_jamming(pair(of.place), friction_share(pair(of.place), mode_of_slip(of, slides)),
                     effect_(2 * of.place, 2 * of.place), effect_(2 * of.place, 2 * of.place + 1));
  }
  const std::vector<Index> places = both_of(resting);
  const contact::FrictionalSolution found =
      contact::solve_frictional(effect_(places, places), accelerations, friction);
  std::vector<int> chosen;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const contact::FrictionalState does = found.states[i];
    if (does == contact::FrictionalState::open || !(found.impulses[2 * static_cast<Index>(i)] > 0))
      chosen.push_back(-1);
    else if (!has_friction(list[i].place) || does == contact::FrictionalState::stick)
      chosen.push_back(list[i].mode);
    else
      chosen.push_back(mode_of_slip(list[i], does == contact::FrictionalState::forward ? 1 : -1));
  }
  return chosen;
}

void Rubbing::record(const std::vector<Index> &list, Collision &record) const {
  std::vector<Index> places;
  for (const Index k : list)
    for (int d = 0; d < (has_friction(k) ? 2 : 1); ++d) {
      places.push_back(2 * k + d);
      record.contacts.push_back(contacts_[static_cast<std::size_t>(k)]);
      record.directions.push_back(d);
    }
  record.rows = rows_(places, Eigen::all);
  record.response = response_(Eigen::all, places);
  record.impulse_by_rate = by_rates_(places, places);
}

} // namespace vibroimpact::motion
