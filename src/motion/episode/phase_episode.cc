#include "motion/episode/phase_episode.h"

#include "common/memory.h"
#include "motion/episode/ring_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
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

// In a ring a force that does not begin with the penetration itself takes so many sweeps that steps
// of order 8 get through its contact in two thirds of the time.
bool is_worth_it(const ContactLaw &law, int mode) {
  const std::optional<contact::ForcePulse> course = law.force_pulse(mode);
  return course && course->begin.power == 1;
}

} // namespace

std::unique_ptr<PhaseEpisode> PhaseEpisode::create(const Equations &equations, LinearPhase &linear,
                                                   std::size_t guard, int mode, double tolerance,
                                                   std::shared_ptr<TaughtContact> taught) {
  const PhaseGuard &onset = linear.forms().guards()[guard];
  const contact::ContactPair &pair = equations.contacts().pairs()[onset.contact];
  const ContactLaw &law = *pair.law;
  const int open = linear.forms().contact_modes()[onset.contact];
  const contact::Guard &passed = law.modes()[static_cast<std::size_t>(open)].guards[onset.guard];
  const Mode &entered = law.modes()[static_cast<std::size_t>(mode)];
  if (pair.circle && !is_worth_it(law, mode))
    return nullptr;
  if (!law.force_pulse(mode) || !law.elastic_force() || entered.affine || entered.holds() ||
      (!pair.circle && !pair.tangential.empty()) || !equations.holding().empty() ||
      !is_gap(passed.indicator, 1) || passed.action != contact::GuardAction::change_mode)
    return nullptr;
  std::unique_ptr<PhaseEpisode> made(
      new PhaseEpisode(equations, linear, onset, mode, tolerance, std::move(taught)));
  return made->endings_.empty() ? nullptr : std::move(made);
}

PhaseEpisode::PhaseEpisode(const Equations &equations, LinearPhase &linear, const PhaseGuard &onset,
                           int mode, double tolerance, std::shared_ptr<TaughtContact> taught)
    : equations_(equations), linear_(linear), onset_(onset), mode_(mode), tolerance_(tolerance),
      taught_(std::move(taught)), others_(linear) {
  if (pair().circle)
    force_ = std::make_unique<RingForce>(pair(), mode);
  else
    force_ = std::make_unique<LawForce>(law(), mode);
  const contact::ForcePulse course = *law().force_pulse(mode);
  for (const contact::ForcePulse::End &end : course.ends)
    if (leads_back(this->mode().guards[end.guard]))
      endings_.push_back({.guard = end.guard, .edge = end.edge});
}

// To a mode without force whose guards the kernel can judge.
bool PhaseEpisode::leads_back(const contact::Guard &guard) const {
  const Mode &behind = law().modes()[static_cast<std::size_t>(guard.target)];
  const auto judged = [&](const contact::Guard &next) {
    return !pair().circle || is_product(next.indicator);
  };
  return guard.action == contact::GuardAction::change_mode && guard.reset.empty() &&
         behind.affine && !behind.holds_gap &&
         std::all_of(behind.guards.begin(), behind.guards.end(), judged);
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
  std::size_t sum = entries * of_sparse_entry + bytes_of(before_, after_) + others_.bytes();
  for (const ForcedOutput &output : outputs_)
    sum += bytes_of(output.rows());
  for (const Vector &load : bent_loads_)
    sum += bytes_of(load);
  return sum;
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
  for (Ending &ending : endings_)
    ending.contact.reset();
  set_outputs();
  set_rows();
  const contact::ForceEdge begin = law().force_pulse(mode_)->begin;
  while (taught_->shapes.size() < endings_.size())
    taught_->shapes.push_back(std::make_shared<ContactEpisode::Taught>());
  const ForcedMotion motion =
      pair().circle ? ForcedMotion(outputs_[0], outputs_[1]) : ForcedMotion(outputs_[0]);
  for (std::size_t i = 0; i < endings_.size(); ++i)
    endings_[i].contact = std::make_unique<ContactEpisode>(motion, *force_, begin, endings_[i].edge,
                                                           tolerance_, taught_->shapes[i]);
  contact_ = endings_.front().contact.get();
}

// What one newton along an axis, on the second side, does to the amplitudes in a second.
Vector PhaseEpisode::load(int direction) const {
  const ExactPhase &phase = linear_.phase();
  const StateLayout &layout = equations_.layout();
  Vector unit = Vector::Zero(phase.n_modes());
  unit.segment(layout.velocity(), layout.n) =
      pair().along(direction).projection->row.transpose().cwiseQuotient(equations_.model().mass());
  const Eigen::Matrix<long double, Eigen::Dynamic, 1> modes =
      phase.modal().long_inverse() * unit.cast<long double>();
  Vector load = Vector::Zero(static_cast<Index>(phase.n_amplitudes()));
  for (Index k = 0; k < modes.size(); ++k)
    load[phase.places()[static_cast<std::size_t>(k)]] = static_cast<double>(modes[k]);
  return load;
}

void PhaseEpisode::set_outputs() {
  std::vector<Vector> loads;
  for (int d = 0; d < n_directions(); ++d)
    loads.push_back(load(d));
  outputs_.clear();
  flow_ = std::make_unique<ForcedFlow>(blocks(), loads);
  const double sign = pair().circle ? 1 : -1; // the penetration, or u_1 and u_2
  for (int d = 0; d < n_directions(); ++d) {
    const LinearRow seen = linear_row(equations_, onset_.contact, AffineForm::position_along(d));
    outputs_.emplace_back(*flow_, sign * in_amplitudes(seen.row), sign * seen.constant,
                          ContactEpisode::most_terms);
  }
}

// Modes of one body move few coordinates of others: most entries are zero.
void PhaseEpisode::set_rows() {
  const ExactPhase &phase = linear_.phase();
  const Matrix &columns = phase.columns();
  const Index size = phase.n_modes();
  Matrix values(size, static_cast<Index>(phase.n_amplitudes()));
  Matrix bent =
      Matrix::Zero(columns.rows(), values.cols()); // the rates of coordinates are not asked for
  bent_loads_.assign(static_cast<std::size_t>(n_directions()), Vector(size));
  for (Index i = 0; i < columns.rows(); ++i) {
    const Vector row = by_places(columns.row(i));
    const Vector turned = flow_->before(row);
    if (i < size) {
      values.row(i) = row.transpose();
      for (int d = 0; d < n_directions(); ++d)
        bent_loads_[static_cast<std::size_t>(d)][i] = turned.dot(flow_->load(d));
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
  find_frame();
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
    if (pair().circle)
      contact_->turn_to(frame_);
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
  add_force(end_moments_, 1, 0, after_.data());
}

// f = f_0 n + f_1 t along the axes.
void PhaseEpisode::add_force(const std::vector<double> &moments, int n_targets, int target,
                             double *amplitudes) const {
  const int terms = contact_->terms();
  const double *first = moments.data() + static_cast<std::ptrdiff_t>(target) * terms;
  if (!pair().circle) {
    flow_->add(duration(), first, terms, amplitudes);
    return;
  }
  const double *second = first + static_cast<std::ptrdiff_t>(n_targets) * terms;
  std::array<double, ContactEpisode::most_terms> along{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(terms); ++k)
      along[k] = frame_.normal[axis] * first[k] + frame_.tangent()[axis] * second[k];
    flow_->add(duration(), along.data(), terms, amplitudes, static_cast<int>(axis));
  }
}

double PhaseEpisode::force_along(int axis, int node) const {
  if (!pair().circle)
    return contact_->forces()[node];
  const auto a = static_cast<std::size_t>(axis);
  return frame_.normal[a] * contact_->forces(0)[node] +
         frame_.tangent()[a] * contact_->forces(1)[node];
}

// Of the touch.
void PhaseEpisode::find_frame() {
  if (!pair().circle)
    return;
  contact::RelativeMotion at;
  for (std::size_t d = 0; d < 2; ++d) {
    double derivatives[2];
    outputs_[d].free_motion(before_.data(), 2, derivatives);
    at.position[d] = derivatives[0];
    at.rate[d] = derivatives[1] * flow_->fastest();
  }
  const contact::CircularGap &circle = *pair().circle;
  frame_ = {.normal = circle.frame(at).normal, .touching = circle.sense() * circle.clearance()};
}

// Both sides just touch; what the contact sees of the motion then, at the first instant.
Motions PhaseEpisode::touch() const {
  Motions motions;
  ByDirection<double> rates{};
  for (int d = 0; d < n_directions(); ++d) {
    double derivatives[2];
    output(d).free_motion(before_.data(), 2, derivatives);
    rates[static_cast<std::size_t>(d)] = derivatives[1] * flow_->fastest();
  }
  const auto [n1, n2] = frame_.normal;
  motions.rates[0][0] = pair().circle ? -(n1 * rates[0] + n2 * rates[1]) : rates[0];
  motions.rates[1][0] = n1 * rates[1] - n2 * rates[0];
  return motions;
}

// Internal states follow the touch at once and stay; nothing else depends on them.
void PhaseEpisode::reset_internal() {
  const ExactPhase &phase = linear_.phase();
  if (pair().n_internal() == 0)
    return;
  state_.resize(phase.n_modes());
  phase.state(before_.data(), state_.data());
  const Index first = equations_.layout().internal() + pair().internal_offset;
  internal_.assign(state_.data() + first, state_.data() + first + pair().n_internal());
  force_->set_internal(internal_);
  const LocalState local = force_->local(touch(), 0);
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
  force_->set_internal(internal_);
}

// Guards of the contact's own mode but that by which it ends, at the touch, at the nodes and at the
// end. Those of a gap or a force are positive wherever a law pushes, which is proven between these.
bool PhaseEpisode::guards_of_law_hold() const {
  const Motions at_touch = touch();
  for (std::size_t g = 0; g < mode().guards.size(); ++g) {
    if (g == release())
      continue;
    const AffineForm &form = mode().guards[g].indicator;
    if (!is_gap(form, -1) && !(form(force_->local(at_touch, 0)) > 0))
      return false;
    for (int i = 0; i <= contact_->nodes(); ++i) {
      LocalState local = force_->local(contact_->motions(), i);
      local.normal_force = contact_->law().normal[static_cast<std::size_t>(i)];
      if (!(form(local) > 0))
        return false;
    }
  }
  return true;
}

// Of the force along an axis: by the rule whose nodes these are, with positive weights.
Push PhaseEpisode::push_along(int axis) const {
  Instants pushing{}, pulling{};
  for (int i = 0; i < contact_->nodes(); ++i) {
    const double force = force_along(axis, i);
    pushing[static_cast<std::size_t>(i)] = std::max(0.0, force);
    pulling[static_cast<std::size_t>(i)] = std::max(0.0, -force);
  }
  return {.load = flow_->load(axis).data(),
          .pushing = contact_->integral(pushing),
          .pulling = contact_->integral(pulling)};
}

bool PhaseEpisode::others_stay_away() {
  std::array<Push, most_axes> pushes;
  for (int d = 0; d < n_directions(); ++d)
    pushes[static_cast<std::size_t>(d)] = push_along(d);
  return others_.stay_positive(onset_.contact, before_.data(), duration(),
                               std::span(pushes).first(static_cast<std::size_t>(n_directions())));
}

// What an end is summed up from: each group's own motion and what the force has added.
void PhaseEpisode::add_rounding(double *rounding) const {
  const auto n = static_cast<std::size_t>(linear_.phase().view().n_padded);
  constexpr double unit = 8 * 0x1p-52;
  for (std::size_t j = 0; j < n; ++j)
    rounding[j] += unit * (std::abs(before_[j]) + std::abs(before_[j + n]));
  for (int d = 0; d < n_directions(); ++d) {
    const Push push = push_along(d);
    for (std::size_t j = 0; j < n; ++j)
      rounding[j] += unit * (push.pushing + push.pulling) *
                     (std::abs(push.load[j]) + std::abs(push.load[j + n]));
  }
}

} // namespace vibroimpact::motion
