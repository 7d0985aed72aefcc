#include "motion/variation/linear_flow.h"

#include "motion/variation/exponential_action.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using model::ExponentialForm;

namespace {

double radius_of(const ModalBlock &block) {
  if (block.kind != BlockKind::dense)
    return std::abs(block.exponent);
  return std::min(block.generator.cwiseAbs().rowwise().sum().maxCoeff(),
                  block.generator.cwiseAbs().colwise().sum().maxCoeff());
}

Matrix exponential(const ModalBlock &block, double h) {
  if (block.kind == BlockKind::dense)
    return exponential_action(block.generator, radius_of(block), h,
                              Matrix::Identity(block.size, block.size));
  const double size = std::exp(block.exponent.real() * h);
  if (block.kind == BlockKind::real)
    return Matrix::Constant(1, 1, size);
  return size * pair_generator(std::polar(1.0, block.exponent.imag() * h));
}

// Row k: source k as a form of the coordinates of the inputs.
Matrix source_rows(const Excitation &excitation, std::size_t sources) {
  Matrix rows = Matrix::Zero(static_cast<Index>(sources), excitation.size());
  Index place = 0;
  for (const Input &input : excitation.inputs()) {
    if (input.kind != Input::Kind::one)
      rows(static_cast<Index>(input.source), place) = 1;
    place += input.size();
  }
  return rows;
}

// Closed forms of all sources from `time` on, which is short of the next break.
std::optional<std::vector<ExponentialForm>> closed_forms(const Equations &equations, double time) {
  std::vector<ExponentialForm> forms;
  for (const model::Source &source : equations.model().sources()) {
    const std::optional<ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      return std::nullopt;
    forms.push_back(*form);
  }
  return forms;
}

} // namespace

LinearFlow::LinearFlow(const Equations &equations) : system_(equations), modal_(system_.matrix()) {
  for (const ModalBlock &block : modal_.blocks())
    radius_ = std::max(radius_, radius_of(block));
}

Matrix LinearFlow::propagator(double h) const {
  Matrix propagated = modal_.inverse();
  for (const ModalBlock &block : modal_.blocks())
    propagated.middleRows(block.column, block.size) =
        (exponential(block, h) * propagated.middleRows(block.column, block.size)).eval();
  return modal_.basis() * propagated;
}

// B of y' = A y + B w, with s = C w, s' = C G w, s'' = C G^2 w of the sources.
Matrix LinearFlow::input_matrix(const Excitation &excitation, const Matrix &generator) const {
  const Matrix value = source_rows(excitation, system_.loads().size());
  const Matrix rate = value * generator;
  const Matrix acceleration = rate * generator;
  Matrix inputs = Matrix::Zero(system_.size(), excitation.size());
  inputs.col(0) = system_.constant();
  for (std::size_t k = 0; k < system_.loads().size(); ++k) {
    const LinearSystem::Load &load = system_.loads()[k];
    const auto row = static_cast<Index>(k);
    inputs += load.value * value.row(row) + load.rate * rate.row(row) +
              load.acceleration * acceleration.row(row);
  }
  return inputs;
}

// dB by a key.
Matrix LinearFlow::changed_inputs(const Excitation &excitation, const Matrix &generator,
                                  const Matrix &generator_change,
                                  const KeyTangent::LinearTangent &tangent) const {
  const Matrix value = source_rows(excitation, system_.loads().size());
  const Matrix rate = value * generator;
  const Matrix acceleration = rate * generator;
  const Matrix rate_change = value * generator_change;
  const Matrix acceleration_change = rate_change * generator + rate * generator_change;
  Matrix inputs = Matrix::Zero(system_.size(), excitation.size());
  inputs.col(0) = tangent.constant;
  for (std::size_t k = 0; k < system_.loads().size(); ++k) {
    const LinearSystem::Load &load = system_.loads()[k];
    const LinearSystem::Load &change = tangent.loads[k];
    const auto row = static_cast<Index>(k);
    inputs += change.value * value.row(row) + change.rate * rate.row(row) +
              change.acceleration * acceleration.row(row) + load.rate * rate_change.row(row) +
              load.acceleration * acceleration_change.row(row);
  }
  return inputs;
}

std::optional<Matrix> LinearFlow::forced(const Equations &equations,
                                         const std::vector<KeyTangent *> &keys, double time,
                                         const Vector &state, double h) {
  const std::optional<std::vector<ExponentialForm>> forms = closed_forms(equations, time);
  if (!forms)
    return std::nullopt;
  while (tangents_.size() < keys.size())
    tangents_.push_back(keys[tangents_.size()]->linear(equations.modes()));
  Excitation excitation;
  excitation.take(*forms);
  const Index n = system_.size();
  const Index m = excitation.size();
  const Matrix generator = generator_of(excitation);
  Matrix matrix = Matrix::Zero(n + m, n + m);
  matrix << system_.matrix(), input_matrix(excitation, generator), Matrix::Zero(m, n), generator;
  Vector start(n + m);
  start.head(n) = state.head(n);
  excitation.coordinates(time, start.data() + n);
  double radius = radius_;
  for (const Input &input : excitation.inputs())
    radius = std::max(radius, std::abs(input.exponent));
  std::vector<Matrix> changes;
  Matrix change_at_start = Matrix::Zero(n + m, static_cast<Index>(keys.size()));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const SourceTangent::InputTangent inputs =
        keys[k]->sources().inputs(time, excitation, generator);
    Matrix change = Matrix::Zero(n + m, n + m);
    change << tangents_[k].matrix,
        changed_inputs(excitation, generator, inputs.generator, tangents_[k]), Matrix::Zero(m, n),
        inputs.generator;
    changes.push_back(std::move(change));
    change_at_start.col(static_cast<Index>(k)).tail(m) = inputs.coordinates;
  }
  return exponential_tangent(matrix, changes, radius, h, start, change_at_start).topRows(n);
}

} // namespace vibroimpact::motion
