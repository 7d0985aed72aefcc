#include "derived/dimensionless.h"

#include "derived/units_of_fields.h"

namespace vibroimpact::derived {

namespace {

std::string described(const std::string &description, double factor) {
  return plain_description(description) + (factor == 1 ? "" : ", angular");
}

} // namespace

// All other units of results are coherent ones of SI, or "SI" of a state of several units.
double plain_factor(const std::string &unit) {
  return unit.find("Hz") == std::string::npos ? 1 : one(unit).value;
}

std::string plain_description(std::string description) {
  for (auto begin = description.find(" ["); begin != std::string::npos;
       begin = description.find(" [", begin)) {
    const auto end = description.find(']', begin);
    if (end == std::string::npos)
      break;
    description.erase(begin, end + 1 - begin);
  }
  return description;
}

void remove_units(AnalysisHeader &header) {
  for (Axis &axis : header.axes) {
    if (!axis.labels.empty())
      continue;
    const double factor = plain_factor(axis.unit);
    for (double &value : axis.values)
      value *= factor;
    axis.description = described(axis.description, factor);
    axis.unit = "1";
  }
}

void remove_units(AnalysisArrays &arrays) {
  for (AssembledField &field : arrays.fields) {
    const double factor = plain_factor(field.label.unit());
    for (double &value : field.values)
      value *= factor;
    field.label = Label(field.name(), "1", described(field.label.description(), factor),
                        field.inner_dimensions());
  }
}

} // namespace vibroimpact::derived
