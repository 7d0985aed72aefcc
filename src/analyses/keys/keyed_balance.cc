#include "analyses/keys/keyed_balance.h"

#include "common/error.h"

namespace vibroimpact::analyses {

KeyedBalance::KeyedBalance(const SweptParameter &parameter, const std::string &excitation,
                           System &system, const LineContext &context, Index harmonics,
                           Index intervals)
    : keyed_({parameter}, excitation, "A harmonic balance", system, context), harmonics_(harmonics),
      grids_(harmonics, intervals) {}

continuation::HarmonicEquations KeyedBalance::equations(double key) {
  if (key_ == key)
    return equations_;
  key_.reset();
  const std::shared_ptr<System> before = keyed_.system(); // until what refers to it has gone
  try {
    keyed_.move_to(Vector::Constant(1, key));
  } catch (const InputError &error) {
    throw NumericalError(error.what());
  }
  balance_.emplace(system().model, system().contacts, keyed_.source(), grids_, harmonics_);
  equations_ = balance_->equations();
  key_ = key;
  return equations_;
}

} // namespace vibroimpact::analyses
