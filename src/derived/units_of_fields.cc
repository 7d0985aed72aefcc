#include "derived/units_of_fields.h"

namespace vibroimpact::derived {

parameters::Number one(const std::string &unit) {
  return parameters::evaluate(unit.starts_with("1") ? unit : "1 " + unit, {});
}

} // namespace vibroimpact::derived
