#include "contact/friction/stick_and_slip.h"

namespace vibroimpact::contact {

TangentialMode stick_until(const AffineForm &most, int forward, int backward) {
  const AffineForm held = AffineForm::force_along(1);
  return {.name = "stick",
          .friction = Friction::stick,
          .holds_slip = true,
          .guards = {{.indicator = most + held, .target = forward},
                     {.indicator = most + -1.0 * held, .target = backward}}};
}

TangentialMode slip_along(double sigma, int stick) {
  const AffineForm speed = sigma * AffineForm::rate_along(1);
  return {.name = sigma > 0 ? "slip forward" : "slip backward",
          .friction = Friction::slip,
          .sliding_speed = speed,
          .guards = {{.indicator = speed, .target = stick}}};
}

} // namespace vibroimpact::contact
