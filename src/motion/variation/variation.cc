#include "motion/variation/variation.h"

#include "common/error.h"
#include "motion/trajectory.h"
#include "motion/variation/start_projection.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace vibroimpact::motion {

namespace {

// Of two delays at one instant, relative to the larger: below, deviating motions have both events
// at one instant too.
constexpr double equal_delays = 1e-6;

// Of what is left of a column beside those before it: below, it is the rounding of the column.
constexpr double dependent_column = 1e-14;

bool same_instant(double one, double other) {
  return std::abs(one - other) <= 8 * std::numeric_limits<double>::epsilon() * std::abs(other);
}

} // namespace

double Determinant::value() const { return sign * std::exp(logarithm); }

Variation::Variation(const Trajectory &trajectory, Vector scale, double tolerance,
                     std::vector<KeyTangent *> keys)
    : equations_(trajectory.equations()),
      keys_(std::move(keys)), accuracy_{.scale = std::move(scale), .tolerance = tolerance},
      saltations_(equations_, keys_, accuracy_.scale), start_(trajectory.time()) {
  if (accuracy_.scale.size() != equations_.layout().physical_size())
    throw std::logic_error("a variation needs one scale for each physical state");
  for (KeyTangent *key : keys_)
    key->enter(trajectory.time(), equations_.source_break());
  projection_ = start_projection(equations_, keys_, trajectory.time(), trajectory.state());
  columns_ = projection_.by_key;
}

void Variation::set_columns(const Matrix &columns) {
  Matrix all(columns.rows(), columns.cols() + n_keys());
  all << projection_.by_state * columns, columns_.rightCols(n_keys());
  columns_ = std::move(all);
}

Vector Variation::orthonormalise() {
  const Index count = columns_.cols() - n_keys();
  const Matrix scaled = accuracy_.scale.asDiagonal() * columns_.leftCols(count);
  const Eigen::HouseholderQR<Matrix> qr(scaled);
  Vector growth(count);
  for (Index k = 0; k < count; ++k) {
    const double left = std::abs(qr.matrixQR()(k, k));
    growth[k] = left > dependent_column * scaled.col(k).norm()
                    ? std::log(left)
                    : -std::numeric_limits<double>::infinity();
  }
  const Matrix basis = qr.householderQ() * Matrix::Identity(scaled.rows(), count);
  columns_.leftCols(count) = accuracy_.scale.cwiseInverse().asDiagonal() * basis;
  return growth;
}

void Variation::apply(const LinearMap &map) {
  columns_ = (map.by_state * columns_).eval();
  columns_.rightCols(n_keys()) += map.by_key;
}

// The modes and the interval between breaks that hold during a step.
void Variation::follow(const StepView &view) {
  const auto &modes = view.equations().modes();
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
  const double next = view.equations().source_break();
  if (next != equations_.source_break())
    pass_break(view.start_state(), view.start(), next);
}

void Variation::pass_break(const Vector &state, double time, double next) {
  if (!keys_.empty())
    columns_.rightCols(n_keys()) += saltations_.at_break(state, next);
  equations_.set_source_break(next);
  for (KeyTangent *key : keys_)
    key->enter(time, next);
}

// False: the sources have no closed form, which the keys need.
bool Variation::step_linear(const StepView &view) {
  auto known = flows_.find(equations_.modes());
  if (known == flows_.end())
    known = flows_.emplace(equations_.modes(), LinearFlow(equations_)).first;
  LinearFlow &flow = known->second;
  std::optional<Matrix> forced;
  if (!keys_.empty()) {
    forced = flow.forced(equations_, keys_, view.start(), view.start_state(), view.length());
    if (!forced)
      return false;
  }
  columns_ = (flow.propagator(view.length()) * columns_).eval();
  if (forced)
    columns_.rightCols(n_keys()) += *forced;
  determinant_.logarithm += flow.divergence() * view.length();
  return true;
}

void Variation::step(const StepView &view) {
  follow(view);
  if (!LinearSystem::holds(equations_) || !step_linear(view))
    determinant_.logarithm += integrate_beside(view, equations_, keys_, accuracy_, columns_);
  if (!columns_.allFinite())
    throw NumericalError("the variation of the motion is no longer finite at t = " +
                         std::to_string(view.end()) + " s");
}

// At one instant: do deviating motions have this event at another time than those before?
bool Variation::contradicts(const Saltation &saltation, double time) {
  const bool again = same_instant(instant_.time, time);
  bool apart = false;
  if (again && instant_.jumps && saltation.jumps) {
    const RowVector delay = saltation.delay * instant_.map;
    const auto size = [&](const RowVector &row) {
      return row.cwiseQuotient(accuracy_.scale.transpose()).cwiseAbs().maxCoeff();
    };
    apart =
        size(delay - instant_.delay) > equal_delays * std::max(size(delay), size(instant_.delay));
  }
  if (!again)
    instant_ = {.time = time,
                .map = Matrix::Identity(columns_.rows(), columns_.rows()),
                .delay = saltation.delay,
                .jumps = saltation.jumps};
  instant_.jumps = instant_.jumps || saltation.jumps;
  instant_.map = (saltation.map.by_state * instant_.map).eval();
  return apart;
}

void Variation::event(const ContactEvent &event) {
  const std::optional<Saltation> saltation = saltations_.of(event, start_);
  if (!saltation)
    return;
  const bool apart = contradicts(*saltation, event.time);
  tangential_events_ += apart || !saltation->differentiable ? 1 : 0;
  apply(saltation->map);
  const double determinant = saltation->map.by_state.partialPivLu().determinant();
  determinant_.logarithm += std::log(std::abs(determinant));
  determinant_.sign *= determinant < 0 ? -1 : 1;
}

} // namespace vibroimpact::motion
