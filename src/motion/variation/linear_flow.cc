#include "motion/variation/linear_flow.h"

#include "common/decompositions.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

void turn(const ModalBlock &block, double h, Matrix &modal) {
  if (block.kind == BlockKind::dense) {
    const Matrix exponential = vibroimpact::exponential(h * block.generator);
    modal.middleRows(block.column, block.size) =
        (exponential * modal.middleRows(block.column, block.size)).eval();
    return;
  }
  const double size = std::exp(block.exponent.real() * h);
  if (block.kind == BlockKind::real) {
    modal.row(block.column) *= size;
    return;
  }
  const double c = size * std::cos(block.exponent.imag() * h);
  const double s = size * std::sin(block.exponent.imag() * h);
  for (Index k = 0; k < modal.cols(); ++k) {
    const double x = modal(block.column, k);
    const double y = modal(block.column + 1, k);
    modal(block.column, k) = c * x - s * y;
    modal(block.column + 1, k) = s * x + c * y;
  }
}

} // namespace

std::size_t LinearFlow::bytes() const {
  std::size_t sum = bytes_of(modal_);
  for (const KnownKey &key : keys_)
    sum += key.response ? key.response->bytes() : 0;
  return sum;
}

void LinearFlow::propagate(double h, Matrix &columns) {
  const ModalForm &form = phase_.phase().modal();
  modal_.noalias() = form.inverse() * columns;
  for (const ModalBlock &block : form.blocks())
    turn(block, h, modal_);
  columns.noalias() = form.basis() * modal_;
}

// dB of y' = A y + B w, by the rows s = S w, s' = S G w, s'' = S G^2 w of the sources.
Matrix LinearFlow::changed_inputs(const Matrix &generator, const Matrix &generator_change,
                                  const KeyTangent::LinearTangent &tangent) const {
  const LinearSystem &system = phase_.system();
  const Index n = system.size();
  const Index m = generator.rows();
  const Matrix sources =
      phase_.phase().columns().bottomRightCorner(3 * static_cast<Index>(system.loads().size()), m);
  Matrix inputs = Matrix::Zero(n, m);
  inputs.col(0) = tangent.constant;
  for (std::size_t k = 0; k < system.loads().size(); ++k) {
    const LinearSystem::Load &load = system.loads()[k];
    const LinearSystem::Load &change = tangent.loads[k];
    const auto rows = sources.middleRows(3 * static_cast<Index>(k), 3);
    const RowVector rate_change = rows.row(0) * generator_change;
    const RowVector acceleration_change = rate_change * generator + rows.row(1) * generator_change;
    inputs += change.value * rows.row(0) + change.rate * rows.row(1) +
              change.acceleration * rows.row(2) + load.rate * rate_change +
              load.acceleration * acceleration_change;
  }
  return inputs;
}

// E = C^-1 dM C with C = [W Y; 0 1].
Matrix LinearFlow::coupling(KeyTangent &key, const Excitation &excitation) const {
  const ExactPhase &phase = phase_.phase();
  const KeyTangent::LinearTangent &tangent =
      key.linear(phase_.forms().contact_modes(), phase_.system());
  const Matrix &generator_change = key.sources().input_generator();
  const Matrix inputs = changed_inputs(excitation.generator(), generator_change, tangent);
  const Index n = phase.n_modes();
  const Index m = inputs.cols();
  const auto response = phase.columns().topRightCorner(n, m);
  Matrix all = Matrix::Zero(n + m, n + m);
  all.topRows(n) = tangent.matrix * phase.columns().topRows(n);
  all.topRightCorner(n, m) += inputs - response * generator_change;
  all.topRows(n) = (phase.modal().inverse() * all.topRows(n)).eval();
  all.bottomRightCorner(m, m) = generator_change;
  return all;
}

const ForcedResponse &LinearFlow::response(std::size_t place, KeyTangent &key,
                                           const Excitation &excitation) {
  if (keys_.size() <= place)
    keys_.resize(place + 1);
  KnownKey &known = keys_[place];
  const long sources = key.sources().generation();
  if (known.identity != key.identity() || known.excitation != excitation.generation() ||
      known.sources != sources) {
    known.response.emplace(phase_.phase().groups(), coupling(key, excitation));
    known.identity = key.identity();
    known.excitation = excitation.generation();
    known.sources = sources;
  }
  return *known.response;
}

Matrix LinearFlow::forced(const std::vector<KeyTangent *> &keys, const Excitation &excitation,
                          double time, const Vector &state, double h) {
  const ExactPhase &phase = phase_.phase();
  const Index n = phase.n_modes();
  const Index m = excitation.size();
  const auto columns = phase.columns().topRows(n);
  Vector x(n + m);
  excitation.coordinates(time, x.data() + n);
  x.head(n) = phase.modal().inverse() * (state.head(n) - columns.rightCols(m) * x.tail(m));
  Matrix forced(n, static_cast<Index>(keys.size()));
  Vector start(n + m);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const ForcedResponse &respond = response(k, *keys[k], excitation);
    start.tail(m) = keys[k]->sources().input_coordinates(time);
    start.head(n) = -(phase.modal().inverse() * (columns.rightCols(m) * start.tail(m)));
    forced.col(static_cast<Index>(k)) = columns * respond(h, x, start);
  }
  return forced;
}

} // namespace vibroimpact::motion
