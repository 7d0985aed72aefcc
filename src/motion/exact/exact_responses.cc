// The response of the modes of a phase to its inputs.
#include "motion/exact/exact_phase.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// An input nearer (relatively) to an eigenvalue would lose more than five digits of the response.
constexpr double resonance = 1e-5;
// Eigenvalues below this part of the largest are as good as zero for a constant input.
constexpr double slow = 1e-8;
// Loads below this part of the largest come from rounding.
constexpr double rounding = 1e-13;

// An exponent within the resonance of a block's eigenvalues.
bool resonant(const ModalBlock &block, Complex exponent, double radius) {
  const double reach = exponent == 0.0 ? slow * radius : resonance * std::abs(exponent);
  if (block.kind == BlockKind::dense)
    return (block.generator.eigenvalues().array() - exponent).abs().minCoeff() <= reach;
  return std::abs(block.exponent - exponent) <= reach ||
         std::abs(std::conj(block.exponent) - exponent) <= reach;
}

} // namespace

// The response to one input of one block of modes, into the columns of the input's coordinates from
// `first` on. False: they must stay together.
bool ExactPhase::respond(const ModalBlock &block, const Input &input, Index first, bool couple) {
  const Index size = block.size;
  const auto load = [&](Index derivative) -> Vector {
    if (input.kind == Input::Kind::one)
      return derivative == 0 ? Vector(modal_constant_.segment(block.column, size))
                             : Vector(Vector::Zero(size));
    const LinearSystem::Load &loads = modal_loads_[input.source];
    const Vector *of[] = {&loads.value, &loads.rate, &loads.acceleration};
    return derivative < 3 ? Vector(of[derivative]->segment(block.column, size))
                          : Vector(Vector::Zero(size));
  };
  const auto largest = [&](const Vector &all) {
    return all.size() ? all.cwiseAbs().maxCoeff() : 0;
  };
  double whole = 0;
  double own = 0;
  for (Index k = 0; k < 3; ++k) {
    const double factor =
        input.kind == Input::Kind::exponential ? std::pow(std::abs(input.exponent), k) : 1;
    if (input.kind != Input::Kind::exponential && k >= input.size())
      break;
    if (input.kind == Input::Kind::one) {
      whole = largest(modal_constant_);
    } else {
      const LinearSystem::Load &loads = modal_loads_[input.source];
      const Vector *of[] = {&loads.value, &loads.rate, &loads.acceleration};
      whole = std::max(whole, factor * largest(*of[k]));
    }
    own = std::max(own, factor * largest(load(k)));
  }
  if (own <= rounding * whole)
    return true;
  const Matrix own_generator = block.matrix();
  const auto basis = modal_.basis().middleCols(block.column, size);
  const bool near = resonant(block, input.exponent, radius_);
  if (near && !couple)
    return false;
  if (near) {
    auto couples = couples_.block(block.column, first - n_modes(), size, input.size());
    if (input.kind != Input::Kind::exponential) {
      for (Index k = 0; k < input.size(); ++k)
        couples.col(k) = load(k);
      return false;
    }
    const Complex e = input.exponent;
    const ComplexVector sum =
        load(0).cast<Complex>() + e * load(1).cast<Complex>() + e * e * load(2).cast<Complex>();
    couples.col(0) = sum.real();
    if (input.is_pair())
      couples.col(1) = -sum.imag();
    return false;
  }
  auto into = columns_.topRows(n_modes());
  if (input.kind == Input::Kind::exponential) {
    const Complex e = input.exponent;
    const ComplexVector sum =
        load(0).cast<Complex>() + e * load(1).cast<Complex>() + e * e * load(2).cast<Complex>();
    ComplexVector response(size);
    if (block.kind == BlockKind::pair) {
      const Complex d = e - block.exponent.real();
      const double w = block.exponent.imag();
      const Complex inverse = 1.0 / ((e - block.exponent) * (e - std::conj(block.exponent)));
      response << (d * sum[0] - w * sum[1]) * inverse, (w * sum[0] + d * sum[1]) * inverse;
    } else if (block.kind == BlockKind::real) {
      response << sum[0] / (e - block.exponent.real());
    } else {
      const Eigen::MatrixXcd shifted =
          e * Eigen::MatrixXcd::Identity(size, size) - own_generator.cast<Complex>();
      response = shifted.partialPivLu().solve(sum);
    }
    into.col(first) += basis * response.real();
    if (input.is_pair())
      into.col(first + 1) -= basis * response.imag();
    return true;
  }
  const Eigen::PartialPivLU<Matrix> lu(own_generator);
  Vector response = Vector::Zero(size);
  for (Index k = 0; k < input.size(); ++k) {
    const Vector missing = response - load(k);
    response = lu.solve(missing);
    into.col(first + k) += basis * response;
  }
  return true;
}

// What the sources themselves are.
void ExactPhase::add_source_rows(const Input &input, Index first) {
  if (input.kind == Input::Kind::one)
    return;
  auto rows = columns_.middleRows(n_modes() + 3 * static_cast<Index>(input.source), 3);
  if (input.kind == Input::Kind::polynomial) {
    for (Index k = 0; k < std::min<Index>(3, input.size()); ++k)
      rows(k, first + k) = 1;
    return;
  }
  Complex power = 1;
  for (Index k = 0; k < 3; ++k, power *= input.exponent) {
    rows(k, first) = power.real();
    if (input.is_pair())
      rows(k, first + 1) = -power.imag();
  }
}

// The columns of all inputs (of exponential ones only when nothing is to be coupled). False: some
// must be coupled.
bool ExactPhase::respond(const Excitation &excitation, bool couple) {
  Index first = n_modes();
  for (std::size_t k = 0; k < inputs_.size(); ++k) {
    const Input &input = excitation.inputs()[k];
    if (couple || input.kind == Input::Kind::exponential) {
      columns_.middleCols(first, input.size()).setZero();
      add_source_rows(input, first);
      for (std::size_t b = 0; b < modal_.blocks().size(); ++b)
        if (!respond(modal_.blocks()[b], input, first, couple)) {
          if (!couple)
            return false;
          couplings_.push_back({static_cast<Index>(b), static_cast<Index>(k)});
        }
    }
    first += input.size();
  }
  return true;
}

} // namespace vibroimpact::motion
