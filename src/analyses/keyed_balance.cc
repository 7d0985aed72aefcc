#include "analyses/keyed_balance.h"

#include "analyses/swept_system.h"
#include "common/error.h"

#include <numbers>

namespace vibroimpact::analyses {

KeyedBalance::KeyedBalance(const SweptParameter &parameter, const std::string &excitation,
                           System &system, const LineContext &context, Index harmonics,
                           Index intervals)
    : parameter_(parameter), excitation_(excitation), original_(system), context_(context),
      harmonics_(harmonics), grids_(harmonics, intervals), present_(&system) {}

continuation::HarmonicEquations KeyedBalance::equations(double key) {
  if (key_ == key)
    return equations_;
  key_.reset();
  try {
    move_to(key);
  } catch (const InputError &error) {
    throw NumericalError(error.what());
  }
  equations_ = balance_->equations();
  key_ = key;
  return equations_;
}

void KeyedBalance::move_to(double key) {
  if (parameter_.is_frequency()) {
    if (!(key > 0))
      throw NumericalError("there is no motion of a frequency of zero");
    original_.model.set_frequency(sweep_source(original_, excitation_), 2 * std::numbers::pi * key);
  } else {
    balance_.reset();
    built_ = std::make_unique<System>(context_.build({parameter_.at(key)}));
    present_ = built_.get();
  }
  balance_.emplace(present_->model, present_->contacts, sweep_source(*present_, excitation_),
                   grids_, harmonics_);
}

} // namespace vibroimpact::analyses
