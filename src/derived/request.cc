#include "derived/operation.h"
#include "derived/units_of_fields.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::derived {

namespace {

template <class Named> const Named *named(const std::vector<Named> &list, const std::string &name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Named &candidate) { return candidate.name == name; });
  return found == list.end() ? nullptr : &*found;
}

template <class Named>
void add_names(const std::vector<Named> &list, std::vector<std::string> &names) {
  for (const Named &candidate : list)
    names.push_back(candidate.name);
}

} // namespace

void check_numbered_axes(const parameters::Values &section, const AxisNames &names) {
  for (const std::string &name : section.names("Along"))
    if (const Axis *axis = names.find(name); axis != nullptr && !axis->labels.empty())
      section.reject("Along", "must be an axis with numbers");
}

LabelledArray Request::array(const std::string &key, const std::string &name) const {
  if (const DerivedArray *derived = named(earlier_, name))
    return derived->view();
  if (const LabelledArray *field = named(source_.arrays, name))
    return *field;
  const Axis *axis = named(source_.dimensions, names_.own_name(name));
  if (axis != nullptr && axis->labels.empty())
    return {axis->name,   axis->unit,     axis->description,
            {axis->name}, {axis->size()}, axis->values.data()};
  std::vector<std::string> known;
  add_names(earlier_, known);
  add_names(source_.arrays, known);
  section_.reject(key, "'" + name + "' is no field of the analysis and no quantity derived before" +
                           parameters::suggestion(name, known) +
                           " There are: " + parameters::join(known, ", ") + ".");
}

Axis Request::axis(const std::string &key, const std::string &name,
                   const LabelledArray &array) const {
  const std::string own = names_.own_name(name);
  if (!array.find(own))
    section_.reject(key, array.dimensions.empty()
                             ? "must not name an axis: " + array.name + " is a single number"
                             : "must be an axis of " + array.name + ", which are " +
                                   parameters::join(array.dimensions, ", ") + "; '" + name +
                                   "' is none of them.");
  return *named(source_.dimensions, own);
}

std::vector<Axis> Request::along(const LabelledArray &array) const {
  std::vector<Axis> axes;
  for (const std::string &name : section_.names("Along"))
    axes.push_back(axis("Along", name, array));
  return axes;
}

Axis Request::along_one(const LabelledArray &array, bool numbers) const {
  const Axis axis = along(array).at(0);
  if (numbers && !axis.labels.empty())
    section_.reject("Along", "must be an axis with numbers");
  return axis;
}

double Request::number(const std::string &key, const std::string &unit) const {
  const parameters::Number factor = one(unit);
  return section_.quantity_of(key, factor.dimension) / factor.value;
}

std::vector<double> Request::numbers(const std::string &key, const std::string &unit) const {
  const parameters::Number factor = one(unit);
  section_.require_dimension(key, factor.dimension);
  std::vector<double> numbers = section_.quantities(key);
  for (double &number : numbers)
    number /= factor.value;
  return numbers;
}

DerivedArray Request::result(const std::string &unit, const std::string &description,
                             const std::vector<std::string> &dimensions, const Shape &shape) const {
  DerivedArray result{"", unit,
                      section_.has("Description") ? section_.text("Description") : description};
  result.dimensions = dimensions;
  result.shape = shape;
  result.values.assign(number_of_values(shape), std::numeric_limits<double>::quiet_NaN());
  return result;
}

} // namespace vibroimpact::derived
