#include "motion/episode/phase_episode.h"

#include "common/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::ContactLaw;
using contact::LocalState;
using contact::Mode;

namespace {

// A contact that is no single hump is seldom followed by one that is.
constexpr int left_out_after_refusal = 16;

bool is_gap(const AffineForm &form, double sign) {
  return form.constant == 0 && form.gap * sign > 0 && form.gap_rate == 0 &&
         form.normal_force == 0 &&
         std::all_of(form.internal.begin(), form.internal.end(), [](double c) { return c == 0; });
}

bool ends_without_force(const ContactLaw &law, const contact::Guard &guard) {
  const Mode &behind = law.modes()[static_cast<std::size_t>(guard.target)];
  return guard.action == contact::GuardAction::change_mode && guard.reset.empty() &&
         behind.affine && !behind.holds_gap;
}

StepReason reason_of(Refusal refusal) {
  switch (refusal) {
  case Refusal::too_long:
    return StepReason::interrupted;
  case Refusal::too_fast:
    return StepReason::fast;
  case Refusal::no_approach:
  case Refusal::no_release:
    return StepReason::shallow;
  default:
    return StepReason::shape;
  }
}

} // namespace

std::unique_ptr<PhaseEpisode> PhaseEpisode::create(const Equations &equations, LinearPhase &linear,
                                                   std::size_t guard, double tolerance,
                                                   std::shared_ptr<TaughtContact> taught) {
  const PhaseGuard &onset = linear.forms().guards()[guard];
  const ContactLaw &law = *equations.contacts().pairs()[onset.contact].law;
  const int open = linear.forms().contact_modes()[onset.contact];
  const contact::Guard &passed = law.modes()[static_cast<std::size_t>(open)].guards[onset.guard];
  const Mode &mode = law.modes()[static_cast<std::size_t>(onset.target)];
  if (!law.force_pulse(onset.target) || !law.elastic_force() || mode.affine || mode.holds_gap ||
      !equations.holding().empty() || !is_gap(passed.indicator, 1) ||
      passed.action != contact::GuardAction::change_mode)
    return nullptr;
  std::unique_ptr<PhaseEpisode> made(
      new PhaseEpisode(equations, linear, onset, tolerance, std::move(taught)));
  return made->endings_.empty() ? nullptr : std::move(made);
}

PhaseEpisode::PhaseEpisode(const Equations &equations, LinearPhase &linear, const PhaseGuard &onset,
                           double tolerance, std::shared_ptr<TaughtContact> taught)
    : equations_(equations), linear_(linear), onset_(onset), tolerance_(tolerance),
      force_(law(), onset.target), taught_(std::move(taught)) {
  const contact::ForcePulse course = *law().force_pulse(onset.target);
  for (const contact::ForcePulse::End &end : course.ends)
    if (ends_without_force(law(), mode().guards[end.guard]))
      endings_.push_back({.guard = end.guard, .edge = end.edge});
}

const ContactLaw &PhaseEpisode::law() const {
  return *equations_.contacts().pairs()[onset_.contact].law;
}

void TaughtContact::forget() {
  left_out = 0;
  ending = 0;
  for (const std::shared_ptr<ContactEpisode::Taught> &shape : shapes)
    *shape = {};
}

std::size_t PhaseEpisode::bytes() const {
  constexpr std::size_t of_sparse_entry = sizeof(double) + sizeof(int);
  const auto entries = static_cast<std::size_t>(state_rows_.nonZeros() + bent_rows_.nonZeros());
  return (penetration_ ? bytes_of(penetration_->rows()) : 0) + entries * of_sparse_entry +
         bytes_of(before_, after_, reach_, bent_load_);
}

// A form of the rows of the phase, or one of its columns, by places.
Vector PhaseEpisode::in_amplitudes(const RowVector &row) const {
  return by_places(row * linear_.phase().columns());
}

Vector PhaseEpisode::by_places(const RowVector &seen) const {
  const ExactPhase &phase = linear_.phase();
  Vector list = Vector::Zero(static_cast<Index>(phase.n_amplitudes()));
  for (Index k = 0; k < seen.size(); ++k)
    list[phase.places()[static_cast<std::size_t>(k)]] = seen[k];
  return list;
}

std::vector<FlowBlock> PhaseEpisode::blocks() const {
  const ExactPhase &phase = linear_.phase();
  std::vector<FlowBlock> list;
  for (const PhaseGroup &group : phase.groups()) {
    FlowBlock block;
    for (const Index k : group.coordinates)
      block.places.push_back(phase.places()[static_cast<std::size_t>(k)]);
    if (group.kind == BlockKind::dense)
      block.generator = group.generator;
    else if (group.kind == BlockKind::pair)
      block.generator = pair_generator(group.exponent);
    else
      block.generator = Matrix::Constant(1, 1, group.exponent.real());
    list.push_back(std::move(block));
  }
  return list;
}

// Under another excitation the inputs are others, and what the gap sees of them.
void PhaseEpisode::renew() {
  ExactPhase &phase = linear_.phase();
  if (contact_ && generation_ == phase.generation())
    return;
  generation_ = phase.generation();
  if (taught_->generation != generation_)
    taught_->shapes.clear();
  taught_->generation = generation_;
  ++version_;
  const StateLayout &layout = equations_.layout();
  const contact::ContactPair &pair = equations_.contacts().pairs()[onset_.contact];
  Vector unit = Vector::Zero(phase.n_modes());
  unit.segment(layout.velocity(), layout.n) =
      pair.gap.row.transpose().cwiseQuotient(equations_.model().mass());
  const Eigen::Matrix<long double, Eigen::Dynamic, 1> modes =
      phase.modal().long_inverse() * unit.cast<long double>();
  Vector load = Vector::Zero(static_cast<Index>(phase.n_amplitudes()));
  for (Index k = 0; k < modes.size(); ++k)
    load[phase.places()[static_cast<std::size_t>(k)]] = static_cast<double>(modes[k]);
  const LinearRow gap = linear_row(equations_, onset_.contact, AffineForm{.gap = 1});
  for (Ending &ending : endings_)
    ending.contact.reset();
  flow_ = std::make_unique<ForcedFlow>(blocks(), load);
  penetration_ = std::make_unique<ForcedOutput>(*flow_, -in_amplitudes(gap.row), -gap.constant,
                                                ContactEpisode::most_terms);
  set_rows();
  const contact::ForceEdge begin = law().force_pulse(onset_.target)->begin;
  while (taught_->shapes.size() < endings_.size())
    taught_->shapes.push_back(std::make_shared<ContactEpisode::Taught>());
  for (std::size_t i = 0; i < endings_.size(); ++i)
    endings_[i].contact = std::make_unique<ContactEpisode>(
        *penetration_, force_, begin, endings_[i].edge, tolerance_, taught_->shapes[i]);
  contact_ = endings_.front().contact.get();
}

// Modes of one body move few coordinates of others: most entries are zero.
void PhaseEpisode::set_rows() {
  const ExactPhase &phase = linear_.phase();
  const Matrix &columns = phase.columns();
  const Index size = phase.n_modes();
  Matrix values(size, static_cast<Index>(phase.n_amplitudes()));
  Matrix bent =
      Matrix::Zero(columns.rows(), values.cols()); // the rates of coordinates are not asked for
  bent_load_.resize(size);
  for (Index i = 0; i < columns.rows(); ++i) {
    const Vector row = by_places(columns.row(i));
    const Vector turned = flow_->before(row);
    if (i < size) {
      values.row(i) = row.transpose();
      bent_load_[i] = turned.dot(flow_->load());
    }
    if (i >= equations_.layout().velocity())
      bent.row(i) = flow_->before(turned).transpose();
  }
  state_rows_ = values.sparseView(1, 0);
  bent_rows_ = bent.sparseView(1, 0);
}

std::optional<StepReason> PhaseEpisode::pass(const double *amplitudes, double longest) {
  if (taught_->left_out > 0) {
    --taught_->left_out;
    return StepReason::pause;
  }
  renew();
  before_.assign(amplitudes, amplitudes + linear_.phase().n_amplitudes());
  reset_internal();
  const Refusal refusal = solve(longest);
  if (refusal != Refusal::none) {
    if (refusal != Refusal::too_long)
      taught_->left_out = left_out_after_refusal;
    return reason_of(refusal);
  }
  if (!others_stay_away())
    return StepReason::neighbour;
  finish();
  return {};
}

// By the guard that ended the contact before, or else by another one.
Refusal PhaseEpisode::solve(double longest) {
  Refusal refusal = Refusal::none;
  for (std::size_t i = 0; i < endings_.size(); ++i) {
    contact_ = endings_[taught_->ending].contact.get();
    contact_->set_end(condition(release()));
    const Refusal present = contact_->solve(before_.data(), longest);
    if (present == Refusal::none && guards_of_law_hold())
      return present;
    if (i == 0)
      refusal = present == Refusal::none ? Refusal::no_release : present;
    taught_->ending = (taught_->ending + 1) % endings_.size();
  }
  return refusal;
}

EndCondition PhaseEpisode::condition(std::size_t guard) const {
  const AffineForm &form = mode().guards[guard].indicator;
  return {.constant = form({.gap = 0, .gap_rate = 0, .internal = internal_}),
          .by_penetration = -form.gap,
          .by_rate = -form.gap_rate};
}

void PhaseEpisode::finish() {
  after_.resize(before_.size());
  kernel().turn(linear_.phase().view(), before_.data(), duration(), after_.data());
  end_moments_ = contact_->end_moments();
  flow_->add(duration(), end_moments_.data(), contact_->terms(), after_.data());
}

// Internal states follow the touch at once and stay; nothing else depends on them.
void PhaseEpisode::reset_internal() {
  const ExactPhase &phase = linear_.phase();
  const contact::ContactPair &pair = equations_.contacts().pairs()[onset_.contact];
  if (pair.n_internal() == 0)
    return;
  state_.resize(phase.n_modes());
  phase.state(before_.data(), state_.data());
  const Index first = equations_.layout().internal() + pair.internal_offset;
  internal_.assign(state_.data() + first, state_.data() + first + pair.n_internal());
  double gap_derivatives[2];
  penetration_->free_motion(before_.data(), 2, gap_derivatives);
  const double rate = -gap_derivatives[1] * flow_->fastest();
  const LocalState local{.gap = 0, .gap_rate = rate, .internal = internal_};
  const int open = linear_.forms().contact_modes()[onset_.contact];
  const std::vector<AffineForm> &reset =
      law().modes()[static_cast<std::size_t>(open)].guards[onset_.guard].reset;
  std::vector<double> changed = internal_;
  for (std::size_t i = 0; i < reset.size(); ++i) {
    changed[i] = reset[i](local);
    for (Index k = 0; k < phase.n_modes(); ++k)
      before_[static_cast<std::size_t>(phase.places()[static_cast<std::size_t>(k)])] +=
          phase.modal().inverse()(k, first + static_cast<Index>(i)) * (changed[i] - internal_[i]);
  }
  internal_ = std::move(changed);
  force_.set_internal(internal_);
}

// Guards of the contact's own mode but that by which it ends, at the touch, at the nodes and at the
// end. Those of a gap or a force are positive wherever a law pushes, which is proven between these.
bool PhaseEpisode::guards_of_law_hold() const {
  for (std::size_t g = 0; g < mode().guards.size(); ++g) {
    if (g == release())
      continue;
    const AffineForm &form = mode().guards[g].indicator;
    if (!is_gap(form, -1) &&
        !(form({.gap = 0, .gap_rate = -contact_->approach_speed(), .internal = internal_}) > 0))
      return false;
    for (int i = 0; i <= contact_->nodes(); ++i)
      if (!(form({.gap = -contact_->penetrations()[i],
                  .gap_rate = -contact_->rates()[i],
                  .internal = internal_}) > 0))
        return false;
  }
  return true;
}

// Bounds of the magnitudes within the contact, by places.
void PhaseEpisode::set_reach(const double *x, double duration) {
  const ExactPhase &phase = linear_.phase();
  const auto padded = static_cast<std::size_t>(phase.view().n_padded);
  reach_.assign(padded, 0);
  for (const PhaseGroup &group : phase.groups()) {
    const auto first = static_cast<std::size_t>(group.first);
    if (group.kind != BlockKind::dense) {
      const double growth = std::exp(std::max(0.0, group.exponent.real() * duration));
      reach_[first] = growth * (std::abs(x[first]) + std::abs(x[first + padded]));
      continue;
    }
    const Matrix step = duration * group.generator.cwiseAbs();
    Vector term = ConstVectorView(x + first, step.rows()).cwiseAbs();
    VectorView sum(reach_.data() + first, step.rows());
    sum = term;
    constexpr int most_terms = 60;
    for (int k = 1; k < most_terms; ++k) {
      term = step * term / k;
      sum += term;
    }
  }
}

// Of a guard, for magnitudes within the reach.
double PhaseEpisode::second_derivative(std::size_t guard) const {
  const PhaseView &view = linear_.phase().view();
  const auto n = static_cast<std::size_t>(view.n_padded);
  double sum = 0;
  for (std::size_t j = 0; j < n; ++j)
    sum += view.second[guard * n + j] * reach_[j];
  return sum;
}

bool PhaseEpisode::others_stay_away() {
  const PhaseView &view = linear_.phase().view();
  const std::vector<PhaseGuard> &guards = linear_.forms().guards();
  if (guards.size() < 2)
    return true;
  const double t = duration();
  const double pull = contact_->pulling_impulse();
  const double push = contact_->impulse() + pull;
  const Vector &load = flow_->load();
  std::vector<double> least(guards.size());
  set_reach(before_.data(), t);
  for (std::size_t g = 0; g < guards.size(); ++g) {
    double f[4];
    kernel().derivatives(view, static_cast<int>(g), before_.data(), f);
    least[g] = f[0] + std::min(0.0, f[1] * t) - 0.5 * t * t * second_derivative(g) -
               guard_rounding * kernel().guard_size(view, static_cast<int>(g), before_.data());
  }
  set_reach(load.data(), t);
  for (std::size_t g = 0; g < guards.size(); ++g) {
    if (guards[g].contact == onset_.contact)
      continue;
    double f[4];
    kernel().derivatives(view, static_cast<int>(g), load.data(), f);
    const double value = f[0] - view.constants[g];
    const double bend = 0.5 * t * t * second_derivative(g);
    const double down = std::max(0.0, -value) + t * std::max(0.0, -f[1]) + bend;
    const double up = std::max(0.0, value) + t * std::max(0.0, f[1]) + bend;
    if (!(least[g] - push * down - pull * up > 0))
      return false;
  }
  return true;
}

// What an end is summed up from: each group's own motion and what the force has added.
void PhaseEpisode::add_rounding(double *rounding) const {
  const auto n = static_cast<std::size_t>(linear_.phase().view().n_padded);
  constexpr double unit = 8 * 0x1p-52;
  const double impulse = contact_->impulse();
  const Vector &load = flow_->load();
  for (std::size_t j = 0; j < n; ++j)
    rounding[j] += unit * (std::abs(before_[j]) + std::abs(before_[j + n]) +
                           impulse * (std::abs(load[static_cast<Index>(j)]) +
                                      std::abs(load[static_cast<Index>(j + n)])));
}

} // namespace vibroimpact::motion
