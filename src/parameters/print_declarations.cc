#include "parameters/print_formats.h"
#include "parameters/values.h"

#include <stdexcept>

namespace vibroimpact::parameters {

std::string print_declarations(const Section &declarations, const std::string &format) {
  if (format == "markdown")
    return print_markdown(declarations);
  if (format == "prm")
    return print_prm(declarations);
  if (format == "json")
    return print_json(declarations);
  throw std::logic_error("declarations cannot be printed as '" + format + "'");
}

} // namespace vibroimpact::parameters
