// What drives a linear system between two breaks of its sources: inputs that go on by themselves.
//
// A source is a sum of exponentials, s = Re(a exp(e t)), and a polynomial, whose coordinates are
// its value and derivatives. One more input is the number 1, for what is constant in the system.
#pragma once

#include "model/exponential_form.h"
#include "motion/phase/modal_form.h"

#include <vector>

namespace vibroimpact::motion {

struct Input {
  enum class Kind { one, exponential, polynomial };
  Kind kind = Kind::one;
  std::size_t source = 0;
  Complex exponent{}; ///< imaginary part >= 0 [1/s]
  Index degree = 0;   ///< of a polynomial

  bool is_pair() const { return exponent.imag() != 0; }
  /// Real coordinates: of a pair real and imaginary part of a, of a polynomial s, s', ...
  Index size() const { return kind == Kind::polynomial ? degree + 1 : is_pair() ? 2 : 1; }
  /// w' = G w of these, size() squared [1/s].
  Matrix generator() const;
  bool same_kind(const Input &other) const {
    return kind == other.kind && source == other.source && degree == other.degree &&
           is_pair() == other.is_pair();
  }
  bool operator==(const Input &other) const = default;
};

class Excitation {
public:
  /// The sources from now on, up to their next break.
  void take(const std::vector<model::ExponentialForm> &sources);

  const std::vector<Input> &inputs() const { return inputs_; }
  /// Real coordinates of all inputs.
  Index size() const { return size_; }
  /// Changes with the exponents.
  long generation() const { return generation_; }
  /// Changes with the number and kinds of inputs.
  long structure() const { return structure_; }

  /// The coordinates at an instant [s], one behind the other.
  void coordinates(double time, double *list) const;
  /// w' = G w of all of them, size() squared [1/s].
  Matrix generator() const;

private:
  std::vector<model::ExponentialForm> sources_;
  std::vector<Input> inputs_, before_;
  Index size_ = 0;
  long generation_ = 0, structure_ = 0;
};

} // namespace vibroimpact::motion
