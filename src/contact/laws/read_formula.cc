#include "contact/laws/read_formula.h"

#include <algorithm>

namespace vibroimpact::contact {

namespace {

using namespace parameters;

// With the dimensions of x and v in place of their values.
void check_unit(const Values &section, const std::string &key) {
  VariableTable table = section.parameters().variables();
  table["x"] = {.value = 1, .dimension = dimension::length, .bare = false};
  table["v"] = {.value = 1, .dimension = dimension::velocity, .bare = false};
  const Number found = Program(section.text(key), table, {}).quantity();
  if (!fits(found, dimension::force))
    section.reject(key, "must be a force [N]; with x in m and v in m/s it is " +
                            described(found.dimension) + ".");
}

} // namespace

Formula read_formula(const Values &section, const std::string &key) {
  try {
    Formula formula(section.text(key), section.parameters().variables(), {"x", "v"});
    const auto has_unit = [](const Step &step) {
      return step.kind == Step::Kind::constant && !step.constant.bare;
    };
    if (std::any_of(formula.steps().begin(), formula.steps().end(), has_unit))
      check_unit(section, key);
    return formula;
  } catch (const Refused &refused) {
    section.reject(key, refused.what());
  }
}

} // namespace vibroimpact::contact
