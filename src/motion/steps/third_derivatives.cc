// Third derivatives of the motion at the ends of a step of order 8.
#include "motion/steps/high_order_stepper.h"
#include "motion/system/friction_rates.h"

namespace vibroimpact::motion {

// The third derivative needs those of the sources.
void HighOrderStepper::read_sources(double time) {
  sources_.clear();
  has_higher_ =
      equations_.model().linear() && equations_.holding().empty() && !equations_.sees_force_rates();
  for (const model::Source &source : equations_.model().sources()) {
    std::optional<model::ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      has_higher_ = false;
    else
      sources_.push_back(*std::move(form));
  }
}

// m q''' = f' - K q' - C q'' + forces of the contacts by the chain rule, and likewise for internal
// states.
void HighOrderStepper::add_higher(EndPoint &point) {
  const StateLayout &layout = equations_.layout();
  const model::Model &model = equations_.model();
  const Index n = layout.n;
  const ConstVectorView velocity(point.rates.data(), n);
  const ConstVectorView acceleration(point.rates.data() + n, n);
  point.higher.resize(layout.physical_size(), 1);
  model.stiffness().apply(velocity, elastic_);
  model.damping().apply(acceleration, damping_);
  point.higher.col(0).head(n) = acceleration;
  auto third = point.higher.col(0).segment(n, n);
  third = -elastic_ - damping_;
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const model::Source &source = model.sources()[k];
    SourceValues &s = point.sources[k];
    s[3] = third_derivative(sources_[k], point.time);
    third += s[1] * source.load + s[2] * source.rate_load + s[3] * source.inertial_load;
  }
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c)
    if (!equations_.inactive(c))
      add_contact_rates(equations_, c, response_, point);
  third.array() /= model.mass().array();
}

} // namespace vibroimpact::motion
