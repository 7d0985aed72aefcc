#include "analyses/sweeps/steadiness.h"

#include <algorithm>

namespace vibroimpact::analyses {

Steadiness::Steadiness(Vector scale, long longest, double tolerance)
    : scale_(std::move(scale)), longest_(longest), tolerance_(tolerance),
      states_(scale_.size(), 2 * longest + 1) {}

void Steadiness::clear() {
  states_.clear();
  multiple_ = 0;
  nearest_ = std::numeric_limits<double>::infinity();
  without_approach_ = 0;
}

// The states of the last k periods are no farther than `distance` from the motion that repeats
// after k periods, p_0 ... p_{k-1}. If that repeats after j < k already, p_0 = p_j, then |x_0 -
// x_j| <= |x_0 - p_0| + |p_j - x_j| <= 2 distance: what the approach alone explains. A lightly
// damped motion that spirals in comes near to where it was some periods before long before it is
// near to where it was one period before. Twice as much is allowed, since the largest entry of a
// vector that turns changes.
long Steadiness::shortest(Index k, double distance) const {
  for (Index j = 1; j < k; ++j)
    if (states_.change(0, j) <= 4 * distance)
      return j;
  return k;
}

// Every approach to a motion that repeats brings the state nearer and nearer to one before it; a
// chaotic motion comes as near as it ever will by chance, ever more rarely.
void Steadiness::note_approach() {
  ++without_approach_;
  for (Index k = 1; k <= longest_ && k < states_.count(); ++k)
    if (const double change = states_.change(0, k); change < nearest_) {
      nearest_ = change;
      without_approach_ = 0;
    }
}

void Steadiness::add(const Eigen::Ref<const Vector> &physical) {
  states_.add(physical.cwiseProduct(scale_));
  note_approach();
  multiple_ = 0;
  const double size = states_[0].cwiseAbs().maxCoeff();
  for (Index k = 1; k <= longest_ && 2 * k < states_.count() && multiple_ == 0; ++k) {
    const double last = states_.change(0, k);
    const double before = states_.change(k, 2 * k);
    // Changes that shrink by the factor r leave last r / (1 - r) to go.
    const double factor = before > 0 ? last / before : 0;
    const double remaining = factor < 1 ? last * std::max(1.0, factor / (1 - factor)) : last;
    const bool small_already = last <= 1e-3 * tolerance_ * size;
    if ((factor < 1 && remaining <= tolerance_ * size) || small_already)
      multiple_ = shortest(k, last + std::min(remaining, tolerance_ * size));
  }
}

Vector state_scale(const motion::Equations &equations, double forcing_frequency) {
  const motion::StateLayout &layout = equations.layout();
  const model::Model &model = equations.model();
  Vector scale = Vector::Ones(layout.physical_size());
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const reduction::ReducedBody &body = *model.bodies()[b];
    const Vector omega = body.omega();
    for (Index j = 0; j < body.size(); ++j) {
      double reach = 0;
      for (const reduction::BodyPoint &point : body.points)
        reach = std::max(reach, point.rows.col(j).head(3).cwiseAbs().maxCoeff());
      scale[model.offset(b) + j] = reach;
      scale[layout.velocity() + model.offset(b) + j] =
          reach / (omega[j] > 0 ? omega[j] : forcing_frequency);
    }
  }
  for (const contact::ContactPair &pair : equations.contacts().pairs()) {
    const std::vector<contact::InternalState> states = pair.law->internal_states();
    for (std::size_t i = 0; i < states.size(); ++i)
      if (states[i].unit == "m/s")
        scale[layout.internal() + pair.internal_offset + static_cast<Index>(i)] =
            1 / forcing_frequency;
  }
  return scale;
}

Vector deviation_scale(const motion::Equations &equations, double forcing_frequency) {
  const Vector scale = state_scale(equations, forcing_frequency);
  return (scale.array() > 0).select(scale, 1);
}

} // namespace vibroimpact::analyses
