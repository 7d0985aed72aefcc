#include "analyses/swept_system.h"

#include "analyses/steadiness.h"
#include "common/error.h"

#include <numbers>

namespace vibroimpact::analyses {

namespace {

std::unique_ptr<motion::Trajectory> trajectory_of(const System &system) {
  return std::make_unique<motion::Trajectory>(system.model, system.contacts, system.integration);
}

std::size_t only_periodic(const std::vector<model::Source> &sources) {
  if (sources.size() == 1)
    return 0;
  std::size_t found = sources.size();
  for (std::size_t s = 0; s < sources.size(); ++s)
    if (sources[s].function->period() > 0) {
      if (found < sources.size())
        return sources.size();
      found = s;
    }
  return found;
}

} // namespace

std::size_t sweep_source(const System &system, const std::string &name, const std::string &who) {
  const std::vector<model::Source> &sources = system.model.sources();
  const std::size_t found = name.empty() ? only_periodic(sources) : system.model.find_source(name);
  if (found == sources.size())
    throw InputError(name.empty()
                         ? who + " must have one periodic excitation, or the key Excitation where "
                                 "there are several."
                         : "Excitation must name an active excitation, which " + name + " is not.");
  if (!(sources[found].function->period() > 0))
    throw InputError("The excitation " + sources[found].name +
                     " has no frequency; its History must be harmonic or ramped harmonic.");
  return found;
}

SweptSystem::SweptSystem(const SweptParameter &parameter, const std::string &excitation,
                         const std::vector<RecorderFactory> &recorders, System &system,
                         const LineContext &context)
    : parameter_(parameter), excitation_(excitation), recorders_(recorders), original_(system),
      context_(context), present_(&system), trajectory_(trajectory_of(system)),
      size_(trajectory_->layout().physical_size()) {
  settler_.emplace(*trajectory_);
}

void SweptSystem::move_to(double value) {
  if (!parameter_.is_frequency()) {
    build(value);
    return;
  }
  original_.model.set_frequency(sweep_source(original_, excitation_), 2 * std::numbers::pi * value);
  period_ = 1 / value;
}

WindowRecording &SweptSystem::recording() {
  return recording_ ? *recording_ : recording_.emplace(recorders_, *present_);
}

void SweptSystem::build(double value) {
  recording_.reset();
  settler_.reset();
  trajectory_.reset();
  built_ = std::make_unique<System>(context_.build({parameter_.at(value)}));
  present_ = built_.get();
  trajectory_ = trajectory_of(*built_);
  settler_.emplace(*trajectory_);
  if (trajectory_->layout().physical_size() != size_)
    throw InputError("the swept key " + parameter_.path +
                     " must not change the number of coordinates");
  const std::size_t source = sweep_source(*built_, excitation_);
  period_ = built_->model.sources()[source].function->period();
}

Vector SweptSystem::scale() const {
  return state_scale(trajectory_->equations(), 2 * std::numbers::pi / period_);
}

} // namespace vibroimpact::analyses
