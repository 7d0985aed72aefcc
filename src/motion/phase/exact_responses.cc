// The response of the modes of a phase to its inputs, A Y + B = Y S.
#include "motion/phase/exact_phase.h"

#include "common/decompositions.h"

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
bool resonant(const std::vector<Complex> &eigenvalues, Complex exponent, double radius) {
  const double reach =
      exponent == 0.0 ? slow * slow * radius * radius : resonance * resonance * std::norm(exponent);
  return std::any_of(eigenvalues.begin(), eigenvalues.end(),
                     [&](Complex e) { return std::norm(e - exponent) <= reach; });
}

// What an exponential input drives one coordinate with: l + e r + e^2 p.
Complex driving(const LinearSystem::Load &loads, Index coordinate, Complex exponent) {
  return loads.value[coordinate] +
         exponent * (loads.rate[coordinate] + exponent * loads.acceleration[coordinate]);
}

// What the k-th coordinate of a polynomial input drives: s, s' or s''.
const Vector *load_of_derivative(const LinearSystem::Load &loads, Index k) {
  const Vector *of[] = {&loads.value, &loads.rate, &loads.acceleration};
  return k < 3 ? of[k] : nullptr;
}

} // namespace

const LinearSystem::Load &ExactPhase::loads_of(const Input &input) const {
  return input.kind == Input::Kind::one ? modal_loads_.back() : modal_loads_[input.source];
}

bool ExactPhase::is_driven(const ModalBlock &block, const Input &input) const {
  const LinearSystem::Load &loads = loads_of(input);
  const bool exponential = input.kind == Input::Kind::exponential;
  const std::array<double, 3> &sizes =
      input.kind == Input::Kind::one ? load_sizes_.back() : load_sizes_[input.source];
  const Index count = exponential ? 3 : std::min<Index>(3, input.size());
  const double growth = exponential ? std::sqrt(std::norm(input.exponent)) : 1;
  double whole = 0;
  double own = 0;
  double factor = 1;
  for (Index k = 0; k < count; ++k, factor *= growth) {
    const Vector &load = *load_of_derivative(loads, k);
    whole = std::max(whole, factor * sizes[static_cast<std::size_t>(k)]);
    for (Index i = 0; i < block.size; ++i)
      own = std::max(own, factor * std::abs(load[block.column + i]));
  }
  return own > rounding * whole;
}

// Basis of the block times the response, into the columns of the input from `first` on.
void ExactPhase::add_response(const ModalBlock &block, const Complex *response, Index first,
                              bool pair) {
  for (Index c = 0; c < block.size; ++c)
    for (Index i = 0; i < n_modes(); ++i) {
      const double basis = modal_.basis()(i, block.column + c);
      columns_(i, first) += basis * response[c].real();
      if (pair)
        columns_(i, first + 1) -= basis * response[c].imag();
    }
}

// (e - B)^-1 of the loads.
void ExactPhase::respond_to_exponential(const ModalBlock &block, const Input &input, Index first) {
  const LinearSystem::Load &loads = loads_of(input);
  const Complex e = input.exponent;
  if (block.kind == BlockKind::pair) {
    const Complex x = driving(loads, block.column, e);
    const Complex y = driving(loads, block.column + 1, e);
    const Complex d = e - block.exponent.real();
    const double w = block.exponent.imag();
    const Complex inverse = 1.0 / ((e - block.exponent) * (e - std::conj(block.exponent)));
    const Complex response[] = {(d * x - w * y) * inverse, (w * x + d * y) * inverse};
    add_response(block, response, first, input.is_pair());
  } else if (block.kind == BlockKind::real) {
    const Complex response = driving(loads, block.column, e) / (e - block.exponent.real());
    add_response(block, &response, first, input.is_pair());
  } else {
    Eigen::MatrixXcd shifted = -block.matrix().cast<Complex>();
    shifted.diagonal().array() += e;
    ComplexVector sum(block.size);
    for (Index i = 0; i < block.size; ++i)
      sum[i] = driving(loads, block.column + i, e);
    const ComplexVector response = LuFactors<ComplexMatrix>(shifted).solve(sum);
    add_response(block, response.data(), first, input.is_pair());
  }
}

// Y_k = B^-1 (Y_{k-1} - B_k), the shift of a polynomial taking s to s' and so on.
void ExactPhase::respond_to_polynomial(const ModalBlock &block, const Input &input, Index first) {
  const LinearSystem::Load &loads = loads_of(input);
  const LuFactors<Matrix> lu(block.matrix());
  Vector response = Vector::Zero(block.size);
  for (Index k = 0; k < input.size(); ++k) {
    if (const Vector *load = load_of_derivative(loads, k))
      response -= load->segment(block.column, block.size);
    response = lu.solve(response).eval();
    columns_.col(first + k).head(n_modes()) +=
        modal_.basis().middleCols(block.column, block.size) * response;
  }
}

// What the input drives, instead of a response to it.
void ExactPhase::couple(const ModalBlock &block, const Input &input, Index first) {
  const LinearSystem::Load &loads = loads_of(input);
  auto couples = couples_.block(block.column, first - n_modes(), block.size, input.size());
  if (input.kind == Input::Kind::exponential) {
    for (Index i = 0; i < block.size; ++i) {
      const Complex sum = driving(loads, block.column + i, input.exponent);
      couples(i, 0) = sum.real();
      if (input.is_pair())
        couples(i, 1) = -sum.imag();
    }
    return;
  }
  couples.setZero();
  for (Index k = 0; k < std::min<Index>(3, input.size()); ++k)
    couples.col(k) = load_of_derivative(loads, k)->segment(block.column, block.size);
}

// The response to one input of one block of modes, into the columns of the input's coordinates from
// `first` on. False: they must stay together.
bool ExactPhase::respond(std::size_t index, const Input &input, Index first, bool may_couple) {
  const ModalBlock &block = modal_.blocks()[index];
  if (!is_driven(block, input))
    return true;
  if (resonant(eigenvalues_[index], input.exponent, radius_)) {
    if (may_couple)
      couple(block, input, first);
    return false;
  }
  if (input.kind == Input::Kind::exponential)
    respond_to_exponential(block, input, first);
  else
    respond_to_polynomial(block, input, first);
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

// The columns of all inputs, or of those that have changed when nothing is to be coupled. False:
// some must be coupled.
bool ExactPhase::respond(const Excitation &excitation, bool may_couple) {
  Index first = n_modes();
  for (std::size_t k = 0; k < inputs_.size(); ++k) {
    const Input &input = excitation.inputs()[k];
    if (may_couple || input != inputs_[k]) {
      columns_.middleCols(first, input.size()).setZero();
      add_source_rows(input, first);
      for (std::size_t b = 0; b < modal_.blocks().size(); ++b)
        if (!respond(b, input, first, may_couple)) {
          if (!may_couple)
            return false;
          couplings_.push_back({.block = b, .input = k});
        }
    }
    first += input.size();
  }
  return true;
}

} // namespace vibroimpact::motion
