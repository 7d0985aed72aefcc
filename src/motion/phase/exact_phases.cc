#include "motion/phase/exact_phases.h"

#include "common/memory.h"
#include "motion/episode/phase_episode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vibroimpact::motion {

namespace {

// Beyond the slowest vibration of the bodies alone no piece is worth trying; where nothing vibrates
// only the excitation asks for pieces at all.
double longest_piece(const model::Model &model) {
  double slowest = std::numeric_limits<double>::infinity();
  const Matrix stiffness = model.stiffness().dense();
  for (Index j = 0; j < stiffness.rows(); ++j)
    if (stiffness(j, j) > 0)
      slowest = std::min(slowest, std::sqrt(stiffness(j, j) / model.mass()[j]));
  constexpr double whole = 1e3; // [s]
  return std::isfinite(slowest) ? 8 / slowest : whole;
}

// Of the tables of some eight lengths for every guard, and of the decomposition; per entry, by
// trial on the machine that the benchmarks were made on.
double cost_of(const LinearPhase &phase) {
  constexpr double tables = 8 * 8 * 90, decomposition = 4; // [ns]
  const auto n = static_cast<double>(phase.system().size());
  return tables * static_cast<double>(phase.forms().guards().size()) * n +
         decomposition * n * n * n;
}

// Of a contact change within steps over many of them: what is shown of the motion there.
double cost_of_change(const model::Model &model) {
  return 2e4 + 2.5e3 * static_cast<double>(model.size()); // [ns], by trial
}

} // namespace

LinearPhase::LinearPhase(const Equations &equations, const Settings &settings, double longest_piece,
                         std::shared_ptr<TaughtPhase> taught)
    : taught_(std::move(taught)), system_(equations), forms_(equations),
      phase_(system_.matrix(), system_.constant(), system_.loads(), forms_.guard_forms(),
             longest_piece, {taught_, &taught_->lengths}),
      tolerance_(settings.relative_tolerance),
      longest_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()) {}

const PowerForms &LinearPhase::powers(const Equations &equations) {
  if (!powers_)
    powers_ = std::make_unique<PowerForms>(equations);
  return *powers_;
}

WorkIntegrals &LinearPhase::work(const Equations &equations) {
  if (!work_)
    work_ = std::make_unique<WorkIntegrals>(powers(equations), phase_, equations.layout());
  else if (work_excitation_ != phase_.generation())
    work_->renew();
  work_excitation_ = phase_.generation();
  return *work_;
}

ExactSegment &LinearPhase::segment(const Equations &equations) {
  if (!segment_)
    segment_ = std::make_unique<ExactSegment>(equations, phase_, tolerance_, longest_step_);
  else if (segment_excitation_ != phase_.generation())
    segment_->renew();
  segment_excitation_ = phase_.generation();
  return *segment_;
}

std::size_t LinearPhase::bytes() const {
  return bytes_of(system_.matrix(), forms_.guard_forms().rows) + phase_.bytes() +
         (powers_ ? bytes_of(powers_->rows()) : 0) + (work_ ? work_->bytes() : 0) +
         (segment_ ? segment_->bytes() : 0) + (part_ ? part_->bytes() : 0);
}

ExactPhases::ExactPhases(const Equations &equations, const Settings &settings)
    : equations_(equations), settings_(settings), longest_piece_(longest_piece(equations.model())),
      change_cost_(cost_of_change(equations.model())) {}

bool ExactPhases::take_sources(double time) {
  sources_.clear();
  for (const model::Source &source : equations_.model().sources()) {
    std::optional<model::ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      return false;
    sources_.push_back(*std::move(form));
  }
  excitation_.take(sources_);
  return true;
}

LinearPhase *ExactPhases::find() {
  const auto [place, unknown] = phases_.try_emplace(equations_.modes());
  Known &known = place->second;
  if (unknown && LinearSystem::holds(equations_))
    known.taught = std::make_shared<TaughtPhase>();
  if (known.taught && !known.phase) {
    known.phase =
        std::make_shared<LinearPhase>(equations_, settings_, longest_piece_, known.taught);
    check_ = true;
  }
  return known.phase.get();
}

bool ExactPhases::linear() { return find() != nullptr; }

LinearPhase *ExactPhases::present() {
  LinearPhase *const found = find();
  if (found)
    found->phase().take(excitation_);
  return found;
}

std::size_t ExactPhases::bytes() const {
  std::size_t sum = 0;
  for (const auto &[modes, known] : phases_)
    sum += known.phase ? known.phase->bytes() : 0;
  return sum;
}

void ExactPhases::meet(LinearPhase &phase) {
  phase.taught_->met = true;
  spent_ += cost_of(phase);
}

void ExactPhases::drop_oldest(const LinearPhase &phase) {
  check_ = false;
  std::size_t sum = bytes();
  while (sum > settings_.prepared_bytes) {
    const LinearPhase *oldest = &phase;
    for (const auto &[modes, known] : phases_)
      if (known.phase && known.phase->entered_ < oldest->entered_)
        oldest = known.phase.get();
    if (oldest == &phase)
      return;
    sum -= oldest->bytes();
    drop(*oldest);
  }
}

void ExactPhases::drop(const LinearPhase &phase) {
  for (auto &[modes, known] : phases_)
    if (known.phase && known.phase->part_)
      known.phase->part_->forget(phase);
  phases_.at(phase.forms().contact_modes()).phase.reset();
}

// Of phases that have been dropped nothing is left.
void ExactPhases::forget() {
  check_ = true;
  spent_ = 0;
  changes_ = 0;
  std::erase_if(phases_, [](const auto &at) { return at.second.taught && !at.second.phase; });
  for (const auto &[modes, known] : phases_)
    if (known.taught) {
      known.taught->met = false;
      known.taught->lengths.hints.fill(-1);
      for (const auto &[guard, contact] : known.taught->contacts)
        contact->forget();
    }
}

} // namespace vibroimpact::motion
