#include "motion/phase/exact_groups.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vibroimpact::motion {

namespace {

/// A block of modes, or an input.
struct Part {
  BlockKind kind;
  Index first, size; ///< coordinates
  Matrix generator;
  std::optional<std::size_t> input{};
};

BlockKind input_kind(const Input &input) {
  if (input.size() == 1)
    return BlockKind::real;
  return input.kind == Input::Kind::exponential ? BlockKind::pair : BlockKind::dense;
}

std::vector<Part> parts_of(const ModalForm &modal, const std::vector<Input> &inputs) {
  std::vector<Part> parts;
  for (const ModalBlock &block : modal.blocks())
    parts.push_back({.kind = block.size == 1 ? BlockKind::real : block.kind,
                     .first = block.column,
                     .size = block.size,
                     .generator = block.matrix()});
  Index first = modal.basis().cols();
  for (std::size_t k = 0; k < inputs.size(); first += inputs[k++].size())
    parts.push_back({.kind = input_kind(inputs[k]),
                     .first = first,
                     .size = inputs[k].size(),
                     .generator = inputs[k].generator(),
                     .input = k});
  return parts;
}

// Of each part the first one that it is coupled with, directly or through others.
std::vector<std::size_t> first_coupled(std::size_t n_parts, std::size_t n_blocks,
                                       const std::vector<Coupling> &couplings) {
  std::vector<std::size_t> first(n_parts);
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (const Coupling &coupling : couplings) {
    const std::size_t a = first[coupling.block];
    const std::size_t b = first[n_blocks + coupling.input];
    std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
  }
  return first;
}

PhaseGroup single_group(const Part &part) {
  PhaseGroup group{
      .kind = part.kind, .coordinates = {}, .generator = part.generator, .input = part.input};
  for (Index c = 0; c < part.size; ++c)
    group.coordinates.push_back(part.first + c);
  if (part.kind == BlockKind::pair)
    group.exponent = {part.generator(0, 0), part.generator(1, 0)};
  if (part.kind == BlockKind::real)
    group.exponent = part.generator(0, 0);
  return group;
}

void append(const Part &part, PhaseGroup &group) {
  const Index before = group.generator.rows();
  Matrix both = Matrix::Zero(before + part.size, before + part.size);
  both.topLeftCorner(before, before) = group.generator;
  both.bottomRightCorner(part.size, part.size) = part.generator;
  group.generator = std::move(both);
  for (Index c = 0; c < part.size; ++c)
    group.coordinates.push_back(part.first + c);
}

// What the inputs drive in the modes of a dense block.
void set_couples(const Matrix &couples, PhaseGroup &group) {
  const Index n_modes = couples.rows();
  const auto size = static_cast<Index>(group.coordinates.size());
  for (Index a = 0; a < size; ++a)
    for (Index b = 0; b < size; ++b) {
      const Index mode = group.coordinates[static_cast<std::size_t>(a)];
      const Index driving = group.coordinates[static_cast<std::size_t>(b)];
      if (mode < n_modes && driving >= n_modes)
        group.generator(a, b) = couples(mode, driving - n_modes);
    }
}

PhaseGroup coupled_group(const std::vector<Part> &parts, const std::vector<std::size_t> &first,
                         std::size_t i, const Matrix &couples) {
  PhaseGroup group = single_group(parts[i]);
  for (std::size_t m = i + 1; m < parts.size(); ++m)
    if (first[m] == i)
      append(parts[m], group);
  group.kind = BlockKind::dense;
  group.exponent = 0;
  group.input.reset();
  set_couples(couples, group);
  return group;
}

bool comes_before(const PhaseGroup &a, const PhaseGroup &b) {
  const auto rank = [](const PhaseGroup &g) {
    return g.kind == BlockKind::pair ? 0 : g.kind == BlockKind::real ? 1 : 2;
  };
  return std::pair(rank(a), a.is_input()) < std::pair(rank(b), b.is_input());
}

} // namespace

std::vector<PhaseGroup> phase_groups(const ModalForm &modal, const std::vector<Input> &inputs,
                                     const std::vector<Coupling> &couplings,
                                     const Matrix &couples) {
  const std::vector<Part> parts = parts_of(modal, inputs);
  const std::vector<std::size_t> first =
      first_coupled(parts.size(), modal.blocks().size(), couplings);
  std::vector<PhaseGroup> groups;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (first[i] != i)
      continue;
    const bool alone = std::count(first.begin(), first.end(), i) == 1;
    groups.push_back(alone ? single_group(parts[i]) : coupled_group(parts, first, i, couples));
  }
  std::stable_sort(groups.begin(), groups.end(), comes_before);
  return groups;
}

} // namespace vibroimpact::motion
