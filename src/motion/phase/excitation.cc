#include "motion/phase/excitation.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using model::ExponentialForm;

Matrix Input::generator() const {
  if (kind == Kind::exponential)
    return is_pair() ? pair_generator(exponent) : Matrix::Constant(1, 1, exponent.real());
  Matrix shift = Matrix::Zero(size(), size());
  shift.diagonal(1).setOnes();
  return shift;
}

Matrix Excitation::generator() const {
  Matrix generator = Matrix::Zero(size_, size_);
  Index place = 0;
  for (const Input &input : inputs_) {
    generator.block(place, place, input.size(), input.size()) = input.generator();
    place += input.size();
  }
  return generator;
}

void Excitation::take(const std::vector<ExponentialForm> &sources) {
  sources_ = sources;
  std::swap(inputs_, before_);
  inputs_.assign(1, Input());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (const ExponentialForm::Term &term : sources[k].terms) {
      const bool upper = term.exponent.imag() >= 0;
      inputs_.push_back({.kind = Input::Kind::exponential,
                         .source = k,
                         .exponent = upper ? term.exponent : std::conj(term.exponent)});
    }
    if (!sources[k].polynomial.empty())
      inputs_.push_back({.kind = Input::Kind::polynomial,
                         .source = k,
                         .degree = static_cast<Index>(sources[k].polynomial.size()) - 1});
  }
  if (inputs_ == before_)
    return;
  ++generation_;
  const auto same = [](const Input &a, const Input &b) { return a.same_kind(b); };
  if (!std::equal(inputs_.begin(), inputs_.end(), before_.begin(), before_.end(), same))
    ++structure_;
  size_ = 0;
  for (const Input &input : inputs_)
    size_ += input.size();
}

void Excitation::coordinates(double time, double *list) const {
  *list++ = 1;
  for (const ExponentialForm &source : sources_) {
    const double t = time - source.origin;
    for (const ExponentialForm::Term &term : source.terms) {
      const Complex now = term.exponent.imag() == 0
                              ? term.amplitude * std::exp(term.exponent.real() * t)
                              : term.amplitude * std::polar(std::exp(term.exponent.real() * t),
                                                            term.exponent.imag() * t);
      *list++ = now.real();
      if (term.exponent.imag() != 0)
        *list++ = term.exponent.imag() > 0 ? now.imag() : -now.imag();
    }
    if (source.polynomial.empty())
      continue;
    const ExponentialForm here = t == 0 ? source : source.about(time);
    double factorial = 1;
    for (std::size_t j = 0; j < here.polynomial.size(); ++j) {
      factorial *= j > 0 ? static_cast<double>(j) : 1;
      *list++ = factorial * here.polynomial[j];
    }
  }
}

} // namespace vibroimpact::motion
