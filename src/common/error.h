// The two kinds of error a user can meet. Everything else is a programming error and uses
// std::logic_error.
#pragma once

#include <stdexcept>
#include <string>

namespace vibroimpact {

/// The user's input cannot be used. The message is complete: it names the file and line (or the
/// JSON path, or the command-line option), the key, its value and what is allowed. The program
/// prints it once, on rank 0, and ends every rank with exit code 1.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A computation did not succeed although its input was valid (no convergence, a step limit, NaN).
/// Inside a sweep the point is recorded as failed with this message and the others go on.
class NumericalError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace vibroimpact
