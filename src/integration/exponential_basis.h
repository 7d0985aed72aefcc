// The exponentials a linear phase is made of.
//
//   [y, then s, s', s'' of each source] = columns * amplitudes(t)
//   amplitude_j(t) = amplitude_j(0) exp(exponent_j t)
//
// with two columns for a complex exponent (real and imaginary part of the amplitude) and one for a
// real one.
#pragma once

#include "integration/linear_system.h"

#include <vector>

namespace vibroimpact::integration {

struct ExponentialBasis {
  /// A part of the excitation: an exponential or the constant of a source, or the constant of the
  /// system itself.
  struct Input {
    std::size_t source = 0;
    Complex exponent{}; ///< imaginary part >= 0 [1/s]
    bool own = false;   ///< of the system
    bool operator==(const Input &other) const = default;
  };
  struct Group {
    Complex exponent;
    Index column = 0;
    bool is_pair = false; ///< two columns
  };
  std::vector<Group> groups; ///< of the modes, then of the inputs
  std::vector<Input> inputs;
  Matrix columns; ///< (size of y + 3 sources) x columns

  std::size_t n_modes() const { return groups.size() - inputs.size(); }
  /// Number of columns of the modes; those of the inputs follow.
  Index mode_columns() const { return inputs.empty() ? columns.cols() : groups[n_modes()].column; }
  /// The exponents and columns of the inputs from a basis of the same modes and kinds of inputs.
  void take_inputs(const ExponentialBasis &other);
};

/// A linear row sees Re(coefficient amplitude) of a group.
Complex seen_of_group(const Matrix &rows, Index row, const ExponentialBasis &basis,
                      const ExponentialBasis::Group &group);

} // namespace vibroimpact::integration
