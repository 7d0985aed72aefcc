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

namespace {

GuardProduct of_gap(const contact::CircularGap &circle, const AffineForm &form) {
  return {.forms = {touching_radius(circle, form), AffineForm::position_along(0),
                    AffineForm::position_along(1)},
          .scale = form.gap * circle.sense() / (2 * circle.clearance())};
}

GuardProduct of_margin(const contact::LimitCircle &limit, double factor) {
  return {.forms = {limit.radius, limit.across[0], limit.across[1]}, .scale = factor};
}

} // namespace

std::optional<std::vector<GuardProduct>> guard_products(const Equations &equations) {
  std::vector<GuardProduct> products;
  Index place = 0;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    for (const contact::Guard &guard : equations.mode(c).guards) {
      const auto &circle = equations.contacts().pairs()[c].circle;
      if (circle && !is_product(guard.indicator))
        return std::nullopt;
      const auto &limit = equations.mode(c).limit;
      const bool margin = limit && guard.indicator.margin != 0;
      if (circle || margin) {
        products.push_back(circle ? of_gap(*circle, guard.indicator)
                                  : of_margin(*limit, guard.indicator.margin));
        products.back().guard = place;
        products.back().contact = c;
      }
      ++place;
    }
  for (GuardProduct &product : products) {
    product.factors = place;
    place += static_cast<Index>(product.forms.size());
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
