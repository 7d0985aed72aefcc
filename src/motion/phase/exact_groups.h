// What a linear phase under its excitation consists of: groups of coordinates that go on by
// themselves.
//
// Blocks of modes and inputs are groups of their own, but for those that are coupled since an input
// is in resonance with a block: these stay one dense block, x' = [D C; 0 S] x.
#pragma once

#include "motion/phase/excitation.h"

#include <optional>
#include <vector>

namespace vibroimpact::motion {

/// A block of modes and an input that stay together.
struct Coupling {
  std::size_t block = 0, input = 0;
};

/// One group of equal exponent, or the columns of a dense block.
struct PhaseGroup {
  BlockKind kind = BlockKind::real;
  Complex exponent{};
  std::vector<Index> coordinates;     ///< real and imaginary part of a pair
  Matrix generator;                   ///< of a dense block
  std::optional<std::size_t> input{}; ///< that the group consists of alone
  int first = 0;                      ///< place among the groups
  long generation = 0;                ///< of the excitation that it was last renewed for

  bool is_input() const { return input.has_value(); }
  /// Places that it takes among the groups.
  std::size_t size() const { return kind == BlockKind::dense ? coordinates.size() : 1; }
};

/// Of the modes, then of the inputs, whose coordinates follow those of the modes. `couples`: modes
/// x coordinates of the inputs, what the inputs that are coupled drive in the modes. Pairs come
/// first, then real ones, then dense blocks, and of each kind those of the modes before the inputs.
std::vector<PhaseGroup> phase_groups(const ModalForm &modal, const std::vector<Input> &inputs,
                                     const std::vector<Coupling> &couplings, const Matrix &couples);

} // namespace vibroimpact::motion
