#include "motion/phase/exact_phase.h"

#include "common/decompositions.h"
#include "common/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

int padded(std::size_t count) {
  const auto blocks = (static_cast<int>(count) + group_block - 1) / group_block;
  return group_block * std::max(blocks, 1);
}

std::vector<Complex> eigenvalues_of(const ModalBlock &block) {
  if (block.kind == BlockKind::real)
    return {block.exponent};
  if (block.kind == BlockKind::pair)
    return {block.exponent, std::conj(block.exponent)};
  const Eigen::VectorXcd values = eigenvalues(block.generator);
  return {values.begin(), values.end()};
}

double largest(const Vector &list) { return list.size() > 0 ? list.cwiseAbs().maxCoeff() : 0; }

} // namespace

ExactPhase::ExactPhase(const Matrix &matrix, const Vector &constant,
                       const std::vector<LinearSystem::Load> &loads, const GuardForms &guards,
                       double h0, std::shared_ptr<TaughtLengths> taught)
    : modal_(matrix), h0_(h0), taught_(std::move(taught)), guard_rows_(guards.rows),
      guard_constants_(guards.constants), n_rows_(guards.rows.cols()) {
  view_.n_guards = static_cast<int>(guards.n_guards());
  view_.n_forms = static_cast<int>(guards.constants.size());
  set_squares(guards);
  set_loads(constant, loads);
  for (const ModalBlock &block : modal_.blocks())
    for (const Complex e : eigenvalues_.emplace_back(eigenvalues_of(block)))
      radius_ = std::max(radius_, std::abs(e));
  view_.make_level = [](void *owner, int level) {
    static_cast<ExactPhase *>(owner)->make_level(level);
  };
  view_.owner = this;
  levels_.resize(n_levels);
  level_views_.resize(n_levels);
}

void ExactPhase::set_squares(const GuardForms &guards) {
  if (!guards.products || guards.products->empty())
    return;
  squares_.resize(static_cast<std::size_t>(view_.n_guards));
  for (const GuardProduct &product : *guards.products)
    squares_[static_cast<std::size_t>(product.guard)] = {.first = static_cast<int>(product.factors),
                                                         .scale = product.scale};
  view_.squares = squares_.data();
}

void ExactPhase::set_loads(const Vector &constant, const std::vector<LinearSystem::Load> &loads) {
  const Vector none = Vector::Zero(n_modes());
  for (const LinearSystem::Load &load : loads)
    modal_loads_.push_back({modal_.inverse() * load.value, modal_.inverse() * load.rate,
                            modal_.inverse() * load.acceleration});
  modal_loads_.push_back({modal_.inverse() * constant, none, none});
  for (const LinearSystem::Load &load : modal_loads_)
    load_sizes_.push_back({largest(load.value), largest(load.rate), largest(load.acceleration)});
}

// Lengths of pieces are forgotten where the groups are arranged anew, but not where the phase
// itself has been dropped since and is made again.
void ExactPhase::take(const Excitation &excitation) {
  if (generation_ == excitation.generation())
    return;
  generation_ = excitation.generation();
  const bool known = taught_->generation == generation_;
  const bool same_groups = taught_->structure == excitation.structure() && !taught_->coupled;
  if (same_groups && !groups_.empty())
    renew(excitation);
  else
    arrange(excitation);
  if (!known && (!same_groups || taught_->coupled))
    taught_->hints.fill(-1);
  taught_->generation = generation_;
  taught_->structure = excitation.structure();
}

std::size_t ExactPhase::bytes() const {
  return level_bytes_ + modal_.bytes() +
         bytes_of(guard_rows_, columns_, couples_, rows_, sizes_, slopes_, second_, third_, eighth_,
                  magnitudes_, weights_);
}

void ExactPhase::arrange(const Excitation &excitation) {
  inputs_ = excitation.inputs();
  const Index n = n_modes();
  columns_ = Matrix::Zero(n_rows_, n + excitation.size());
  columns_.topLeftCorner(n, n) = modal_.basis();
  couples_ = Matrix::Zero(n, excitation.size());
  couplings_.clear();
  respond(excitation, true);
  taught_->coupled = !couplings_.empty();
  groups_ = phase_groups(modal_, inputs_, couplings_, couples_);
  place_groups();
  allocate();
  place_dense();
  show();
  for (PhaseGroup &group : groups_)
    set_group(group);
  set_weights();
  for (std::unique_ptr<Level> &level : levels_)
    level.reset();
  level_bytes_ = 0;
  forget_levels();
  ++arrangement_;
}

// The kernel asks for those that it needs.
void ExactPhase::forget_levels() {
  for (LevelView &view : level_views_)
    view.turn = nullptr;
}

// Of the same structure under other exponents.
void ExactPhase::renew(const Excitation &excitation) {
  if (!respond(excitation, false)) {
    arrange(excitation);
    return;
  }
  for (PhaseGroup &group : groups_)
    if (group.input && inputs_[*group.input] != excitation.inputs()[*group.input]) {
      group.exponent = excitation.inputs()[*group.input].exponent;
      set_group(group);
    }
  inputs_ = excitation.inputs();
  set_weights();
  forget_levels();
}

void ExactPhase::place_groups() {
  std::size_t count = 0;
  for (PhaseGroup &group : groups_) {
    group.first = static_cast<int>(count);
    count += group.size();
  }
  view_.n_groups = static_cast<int>(count);
  view_.n_padded = padded(count);
  view_.n_pairs =
      static_cast<int>(std::count_if(groups_.begin(), groups_.end(), [](const PhaseGroup &group) {
        return group.kind == BlockKind::pair;
      }));
  places_.assign(static_cast<std::size_t>(n_coordinates()), 0);
  for (const PhaseGroup &group : groups_)
    for (std::size_t c = 0; c < group.coordinates.size(); ++c)
      places_[static_cast<std::size_t>(group.coordinates[c])] =
          group.first + static_cast<int>(c) * (group.kind == BlockKind::pair ? view_.n_padded : 1);
}

void ExactPhase::allocate() {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto forms = static_cast<std::size_t>(view_.n_forms);
  rate_.assign(n, 0);
  frequency_.assign(n, 0);
  rows_.assign(forms * 8 * n, 0);
  for (AlignedArray *list : {&sizes_, &slopes_, &second_, &third_, &eighth_, &magnitudes_})
    list->assign(forms * n, 0);
  weights_.assign(2 * n, 0);
  constants_.assign(guard_constants_.begin(), guard_constants_.end());
  constant_sizes_.resize(forms);
  for (std::size_t g = 0; g < forms; ++g)
    constant_sizes_[g] = std::abs(constants_[g]);
}

void ExactPhase::place_dense() {
  dense_.clear();
  generators_.clear();
  fastest_dense_ = 0;
  for (const PhaseGroup &group : groups_)
    if (group.kind == BlockKind::dense) {
      const Matrix transposed = group.generator.transpose();
      generators_.emplace_back(transposed.data(), transposed.data() + transposed.size());
      dense_.push_back({group.first, static_cast<int>(group.coordinates.size()), nullptr});
      fastest_dense_ = std::max(fastest_dense_, eigenvalues(group.generator).cwiseAbs().maxCoeff());
    }
  for (std::size_t d = 0; d < dense_.size(); ++d)
    dense_[d].generator = generators_[d].data();
}

void ExactPhase::show() {
  view_.n_dense = static_cast<int>(dense_.size());
  view_.dense = dense_.data();
  view_.rate = rate_.data();
  view_.frequency = frequency_.data();
  view_.rows = rows_.data();
  view_.sizes = sizes_.data();
  view_.slopes = slopes_.data();
  view_.second = second_.data();
  view_.third = third_.data();
  view_.constants = constants_.data();
  view_.constant_sizes = constant_sizes_.data();
  view_.weights = weights_.data();
  view_.levels = level_views_.data();
  view_.hints = taught_->hints.data();
}

void ExactPhase::amplitudes(const Vector &y, const double *inputs, Amplitudes &amplitudes) const {
  const Index n = n_modes();
  amplitudes.assign(n_amplitudes(), 0.0);
  LongVector rest = y.cast<long double>();
  for (Index k = n; k < n_coordinates(); ++k) {
    const long double input = inputs[k - n];
    rest -= input * columns_.col(k).head(n).cast<long double>();
    amplitudes[static_cast<std::size_t>(places_[static_cast<std::size_t>(k)])] = inputs[k - n];
  }
  const LongVector modes = modal_.long_inverse() * rest;
  for (Index i = 0; i < n; ++i)
    amplitudes[static_cast<std::size_t>(places_[static_cast<std::size_t>(i)])] =
        static_cast<double>(modes[i]);
}

void ExactPhase::state(const double *amplitudes, double *y) const {
  const int *places = places_.data();
  const Index n = n_coordinates();
  for (Index i = 0; i < n_modes(); ++i) {
    const double *row = columns_.data() + i;
    double sum = 0;
    for (Index k = 0; k < n; ++k)
      sum += amplitudes[places[k]] * row[k * n_rows_];
    y[i] = sum;
  }
}

} // namespace vibroimpact::motion
