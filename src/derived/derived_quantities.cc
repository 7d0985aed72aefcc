#include "derived/derived_quantities.h"

#include "derived/best_of_starts.h"
#include "derived/operation.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::derived {

namespace {

using parameters::Values;

const std::vector<std::string> keys_of_operations{
    "Field", "Along", "Refine", "At",   "Where",     "Expression", "Fields", "Unit",      "Level",
    "Other", "Take",  "Sense",  "Side", "Tolerance", "Threshold",  "Levels", "Otherwise", "Inside"};

bool holds(const std::vector<std::string> &list, const std::string &word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

void check_keys(const Values &section, const Operation &wanted) {
  for (const std::string &key : wanted.required)
    section.require(key);
  for (const std::string &key : keys_of_operations)
    if (section.given(key) && !holds(wanted.required, key) && !holds(wanted.optional, key))
      section.reject(key, "must not be set when Operation = " + wanted.name);
}

/// A name that is no outer axis may belong to an inner dimension, which is not known yet; but one
/// that nearly is an axis is a slip.
void check_axes(const Values &section, const AxisNames &names) {
  std::vector<std::string> found;
  for (const std::string &name : section.names("Along")) {
    if (names.find(name) == nullptr && !parameters::nearest(name, names.all()).empty())
      section.require_known("Along", name, names.all());
    if (holds(found, names.own_name(name)))
      section.reject("Along", "must name every axis once only");
    found.push_back(names.own_name(name));
  }
  const std::string chosen = section.choice("Operation");
  const bool several = chosen == "maximum" || chosen == "minimum" || chosen == "mean";
  if (found.size() > 1 && !several)
    section.reject("Along", "must name one axis when Operation = " + chosen);
}

void check_section(const Values &section, const AxisNames &names) {
  const Operation &wanted = operation(section.choice("Operation"));
  check_keys(section, wanted);
  check_axes(section, names);
  if (wanted.check != nullptr)
    wanted.check(section, names);
}

/// That of the analysis itself, or of the one that a grid repeats.
Values computing_section(const Values &root, const std::string &analysis) {
  const Values section = root.instance("Analysis", analysis);
  return section.choice("Type") == analyses::grid_type
             ? root.instance("Analysis",
                             analyses::repeated_analysis(section, root.instances("Analysis")))
             : section;
}

/// The sign of a NaN depends on how it came about.
void make_missing_values_equal(std::vector<double> &values) {
  for (double &value : values)
    if (std::isnan(value))
      value = std::numeric_limits<double>::quiet_NaN();
}

DerivedArray evaluate_one(const Values &section, const std::string &name, const AxisNames &names,
                          const Source &source, const std::vector<DerivedArray> &earlier) {
  DerivedArray array = operation(section.choice("Operation"))
                           .evaluate(Request(section, name, names, source, earlier));
  array.name = name;
  array.operation = section.choice("Operation");
  make_missing_values_equal(array.values);
  return array;
}

/// When a key must be given: "Operation = select or contour".
std::string operations_with(const std::string &key) {
  std::vector<std::string> with;
  for (const Operation &known : operations())
    if (holds(known.required, key))
      with.push_back(known.name);
  return "Operation = " + parameters::join(with, ", ");
}

} // namespace

void declare_derived(parameters::Section &root) {
  using namespace parameters;
  std::vector<std::string> names;
  for (const Operation &known : operations())
    names.push_back(known.name);
  root.named_subsection("Derived", "A quantity derived from the results of an analysis, and stored "
                                   "with them.")
      .names("From", "",
             "The analysis; or several that all have the quantity, such as one and the parameter "
             "grid that repeats it.")
      .required()
      .choice("Operation", "maximum", names, "What is done.")
      .text("Description", "", "A sentence about the result; empty means one that is made up.")
      .text("Symbol", "",
            "What figures call it, between dollar signs as in TeX; empty means its name.")
      .text("Field", "",
            "What it is done to: the path of a field of the analysis, the name of a Derived of the "
            "same analysis that stands before this one, or an axis.")
      .required(operations_with("Field"))
      .names("Along", "",
             "Axis, for maximum, minimum and mean also several. A swept key also goes by the "
             "last part of its path and by the name of its section.")
      .required(operations_with("Along"))
      .choice("Refine", "none", {"none", "parabola"},
              "Between points: by the parabola through the extreme value and its neighbours.")
      .boolean("Inside", "false",
               "Is an extreme value at an end of the axis none, because there may be more beyond?")
      .text("At", "", "The field whose value there is wanted.")
      .required(operations_with("At"))
      .text("Where", "",
            "AXIS = COORDINATE, several of them separated by commas, for example direction = "
            "forward.")
      .required(operations_with("Where"))
      .text("Expression", "", "In the names of Fields and the variables of the file.")
      .required(operations_with("Expression"))
      .text("Fields", "", "NAME = FIELD, several of them separated by commas.")
      .required(operations_with("Fields"))
      .text("Unit", "", "Unit of the expression; empty means the SI unit that it gives.")
      .text("Otherwise", "",
            "Field in the unit of the expression that stands in where this is no number.")
      .quantity("Level", "", dimension::any, range::any, "", "Value that is compared with Field.")
      .text("Other", "", "Field that is compared with Field, instead of Level.")
      .choice("Take", "first", {"first", "last"}, "Which crossing, where there are several.")
      .choice("Sense", "any", {"any", "rising", "falling"},
              "How Field crosses the level or the other field, along the axis.")
      .choice("Side", "above", {"above", "below"},
              "On which side of the level or the other field a band lies.")
      .quantity("Tolerance", "0.01", dimension::none, range::non_negative, "",
                "Relative difference from which on the two directions of a sweep differ.")
      .quantity("Threshold", "", dimension::any, range::any, "",
                "Step of Field from one point to the next that is no jump yet.")
      .required(operations_with("Threshold"))
      .quantities("Levels", "", dimension::any, range::any, "", "Levels of a contour.", 0, 1000)
      .required(operations_with("Levels"))
      .quantity("Probability", "", dimension::none, range::fraction, "p",
                "Of a quantile: the value that this share of the values does not exceed.")
      .required(operations_with("Probability"));
}

void check_analyses(const Values &root) {
  for (const std::string &name : root.instances("Derived")) {
    const Values section = root.instance("Derived", name);
    section.require("From");
    for (const std::string &analysis : section.names("From"))
      section.require_known("From", analysis, root.instances("Analysis"));
  }
}

void DerivedQuantities::add(const Values &root, const std::string &analysis,
                            const std::vector<Axis> &axes,
                            const std::vector<analyses::GridKey> &keys) {
  Wanted wanted{.names = AxisNames(axes, keys), .titles = {}, .sections = {}};
  wanted.best = analyses::create_analysis(computing_section(root, analysis))->best_of();
  for (const std::string &name : root.instances("Derived")) {
    const Values section = root.instance("Derived", name);
    if (!holds(section.names("From"), analysis))
      continue;
    check_section(section, wanted.names);
    wanted.sections.push_back(section);
    wanted.titles.push_back(name);
  }
  if (!wanted.sections.empty() || !wanted.best.field.empty())
    wanted_[analysis] = std::move(wanted);
}

DerivedQuantities::Result DerivedQuantities::evaluate(const std::string &analysis,
                                                      const Source &source) const {
  Result result;
  const auto found = wanted_.find(analysis);
  if (found == wanted_.end() || source.arrays.empty())
    return result;
  const Wanted &wanted = found->second;
  if (!wanted.best.field.empty())
    for (DerivedArray &array : best_of_starts(source, wanted.best))
      if (!holds(wanted.titles, array.name))
        result.arrays.push_back(std::move(array));
  const auto &sections = wanted.sections;
  for (std::size_t i = 0; i < sections.size(); ++i)
    try {
      result.arrays.push_back(
          evaluate_one(sections[i], wanted.titles[i], wanted.names, source, result.arrays));
    } catch (const InputError &error) {
      result.problems.emplace_back(error.what());
    }
  return result;
}

} // namespace vibroimpact::derived
