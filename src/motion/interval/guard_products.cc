#include "motion/interval/guard_products.h"

namespace vibroimpact::motion {

using contact::AffineForm;

bool is_product(const AffineForm &form) {
  AffineForm rest = form;
  rest.gap = 0;
  rest.constant = 0;
  rest.internal.clear();
  return form.gap != 0 && rest.zero();
}

std::optional<std::vector<GuardProduct>> guard_products(const Equations &equations) {
  std::vector<GuardProduct> products;
  Index place = 0;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    for (const contact::Guard &guard : equations.mode(c).guards) {
      const auto &circle = equations.contacts().pairs()[c].circle;
      if (circle && !is_product(guard.indicator))
        return std::nullopt;
      if (circle)
        products.push_back(
            {.guard = place,
             .contact = c,
             .form = guard.indicator,
             .scale = guard.indicator.gap * circle->sense() / (2 * circle->clearance())});
      ++place;
    }
  for (GuardProduct &product : products) {
    product.factors = place;
    place += 3;
  }
  return products;
}

AffineForm touching_radius(const contact::CircularGap &circle, const AffineForm &form) {
  AffineForm radius = circle.sense() / form.gap * form;
  radius.gap = 0;
  radius.constant += circle.clearance();
  return radius;
}

} // namespace vibroimpact::motion
