#include "analyses/keys/swept_system.h"

#include "analyses/sweeps/steadiness.h"
#include "common/error.h"

#include <numbers>

namespace vibroimpact::analyses {

namespace {

std::unique_ptr<motion::Trajectory> trajectory_of(const System &system) {
  return std::make_unique<motion::Trajectory>(system.model, system.contacts, system.integration);
}

} // namespace

SweptSystem::SweptSystem(const SweptParameter &parameter, const std::string &excitation,
                         const std::vector<RecorderFactory> &recorders, System &system,
                         const LineContext &context)
    : keyed_({parameter}, excitation, "A stepped sweep", system, context), recorders_(recorders) {
  renew();
  size_ = trajectory_->layout().physical_size();
}

void SweptSystem::renew() {
  recording_.reset();
  settler_.reset();
  present_ = keyed_.system();
  trajectory_ = trajectory_of(*present_);
  settler_.emplace(*trajectory_);
}

void SweptSystem::move_to(double value) {
  if (keyed_.move_to(Vector::Constant(1, value)))
    renew();
  const SweptParameter &key = keyed_.keys().front();
  if (trajectory_->layout().physical_size() != size_)
    throw InputError("the swept key " + key.path + " must not change the number of coordinates");
  period_ = key.is_frequency() ? 1 / value
                               : present_->model.sources()[keyed_.source()].function->period();
}

WindowRecording &SweptSystem::recording() {
  return recording_ ? *recording_ : recording_.emplace(recorders_, *present_);
}

Vector SweptSystem::scale() const {
  return state_scale(trajectory_->equations(), 2 * std::numbers::pi / period_);
}

} // namespace vibroimpact::analyses
