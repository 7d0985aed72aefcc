#include "periodic/contact_memory.h"

#include <algorithm>

namespace vibroimpact::periodic {

using contact::AffineForm;
using contact::Guard;
using contact::Mode;

namespace {

bool depends(const AffineForm &form, std::size_t i) {
  return i < form.internal.size() && form.internal[i] != 0;
}

bool acts(const Mode &mode, std::size_t i) {
  if (!mode.affine || mode.holds_gap || depends(mode.affine->force, i))
    return true;
  const std::vector<AffineForm> &rates = mode.affine->internal_rate;
  return i >= rates.size() || !rates[i].zero() ||
         std::any_of(rates.begin(), rates.end(),
                     [i](const AffineForm &rate) { return depends(rate, i); });
}

bool is_lost(const Guard &guard, std::size_t i) {
  return !depends(guard.indicator, i) && i < guard.reset.size() &&
         std::none_of(guard.reset.begin(), guard.reset.end(),
                      [i](const AffineForm &reset) { return depends(reset, i); });
}

} // namespace

std::vector<Index> idle_memory(const motion::Equations &equations) {
  std::vector<Index> places;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    const Mode &mode = equations.mode(c);
    for (std::size_t i = 0; i < static_cast<std::size_t>(pair.n_internal()); ++i)
      if (!acts(mode, i) && std::all_of(mode.guards.begin(), mode.guards.end(),
                                        [i](const Guard &guard) { return is_lost(guard, i); }))
        places.push_back(equations.layout().internal() + pair.internal_offset +
                         static_cast<Index>(i));
  }
  return places;
}

} // namespace vibroimpact::periodic
