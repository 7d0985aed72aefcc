// The list of operations.
#include "derived/operation.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::derived {

const std::vector<Operation> &operations() {
  static const std::vector<Operation> list{
      {"maximum", {"Field", "Along"}, {"Refine", "Inside"}, maximum, check_extreme},
      {"minimum", {"Field", "Along"}, {"Refine", "Inside"}, minimum, check_extreme},
      {"mean", {"Field", "Along"}, {}, mean},
      {"standard deviation", {"Field", "Along"}, {}, standard_deviation},
      {"standard error", {"Field", "Along"}, {}, standard_error},
      {"quantile", {"Field", "Along", "Probability"}, {}, quantile},
      {"position of maximum",
       {"Field", "Along"},
       {"Refine", "Inside"},
       position_of_maximum,
       check_position},
      {"position of minimum",
       {"Field", "Along"},
       {"Refine", "Inside"},
       position_of_minimum,
       check_position},
      {"value at maximum", {"Field", "Along", "At"}, {"Inside"}, value_at_maximum},
      {"value at minimum", {"Field", "Along", "At"}, {"Inside"}, value_at_minimum},
      {"select", {"Field", "Where"}, {}, select, check_places},
      {"expression",
       {"Fields", "Expression"},
       {"Unit", "Otherwise"},
       evaluate_formula,
       check_formula},
      {"crossing",
       {"Field", "Along"},
       {"Level", "Other", "Take", "Sense"},
       crossing,
       check_comparison},
      {"band", {"Field", "Along"}, {"Level", "Other", "Side"}, band, check_comparison},
      {"hysteresis width", {"Field", "Along"}, {"Tolerance"}, hysteresis_width, check_position},
      {"locus of jump", {"Field", "Along", "Threshold"}, {}, locus_of_jump, check_position},
      {"contour", {"Field", "Levels"}, {}, contour},
  };
  return list;
}

const Operation &operation(const std::string &name) {
  const auto &list = operations();
  const auto found = std::find_if(
      list.begin(), list.end(), [&](const Operation &candidate) { return candidate.name == name; });
  if (found == list.end())
    throw std::logic_error("no operation " + name);
  return *found;
}

} // namespace vibroimpact::derived
