// An expression of fields, earlier quantities and coordinates, joined by the names of their
// dimensions. Everything enters and leaves in its unit, so that dimensions are checked.
#include "derived/operation.h"
#include "derived/units_of_fields.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vibroimpact::derived {

namespace {

using parameters::Dimension;
using parameters::Number;
using parameters::Refused;
using parameters::Values;
using parameters::VariableTable;

struct Argument {
  std::string name;
  std::string field;
};

std::vector<Argument> read_arguments(const Values &section) {
  std::vector<Argument> arguments;
  for (const std::string &part : parameters::split_list(section.text("Fields"))) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      section.reject("Fields", "must be NAME = FIELD, several of them separated by commas; '" +
                                   part + "' has no '='.");
    Argument argument{parameters::normalised(part.substr(0, equals)),
                      parameters::normalised(part.substr(equals + 1))};
    try {
      parameters::check_variable_name(argument.name);
    } catch (const Refused &refused) {
      section.reject("Fields", refused.what());
    }
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

parameters::Function read_function(const Values &section, const std::vector<Argument> &arguments) {
  std::vector<std::string> names;
  for (const Argument &argument : arguments)
    names.push_back(argument.name);
  parameters::Function function(section.text("Expression"), section.parameters().variables(),
                                names);
  function(std::vector<double>(names.size(), 1.0));
  return function;
}

Number unit_of_result(const Values &section) {
  try {
    return one(section.text("Unit"));
  } catch (const Refused &refused) {
    section.reject("Unit", refused.what());
  }
}

/// The fields of one expression along their common dimensions, all values in SI.
class Formula {
public:
  Formula(const Request &request)
      : request_(request), arguments_(read_arguments(request.section())),
        function_(read_function(request.section(), arguments_)), frame_(fields()) {}

  DerivedArray evaluate() {
    DerivedArray result = request_.result("1", request_.section().text("Expression"),
                                          frame_.dimensions(), frame_.shape());
    if (frame_.shape().empty()) {
      point_ = {};
      for (const LabelledArray &field : fields_)
        point_.push_back(*field.values);
      result.values[0] = at_point();
    } else {
      fill(result.values);
    }
    set_unit(result);
    return result;
  }

private:
  const std::vector<LabelledArray> &fields() {
    for (const Argument &argument : arguments_) {
      fields_.push_back(request_.array("Fields", argument.field));
      units_.push_back(one(fields_.back().unit));
    }
    return fields_;
  }

  double at_point() {
    for (std::size_t a = 0; a < point_.size(); ++a)
      point_[a] *= units_[a].value;
    const double value = function_(point_);
    if (sample_.empty() && std::isfinite(value) && value != 0)
      sample_ = point_;
    return value;
  }

  void fill(std::vector<double> &values) {
    std::vector<Operand> operands;
    for (const LabelledArray &field : fields_)
      operands.push_back(frame_.operand(field));
    const std::size_t last = frame_.shape().size() - 1;
    const std::size_t size = frame_.shape()[last];
    point_.resize(fields_.size());
    for_each_line(frame_, last, operands, [&](std::size_t k, const auto &lines) {
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t a = 0; a < lines.size(); ++a)
          point_[a] = lines[a][i];
        values[k * size + i] = at_point();
      }
    });
  }

  /// The dimension of the expression, found where it has a value; nothing when it has none.
  std::optional<Dimension> dimension() const {
    if (sample_.empty())
      return std::nullopt;
    VariableTable table = request_.section().parameters().variables();
    for (std::size_t a = 0; a < sample_.size(); ++a) {
      Number number = units_[a];
      number.value = sample_[a];
      number.literal = false;
      table[arguments_[a].name] = number;
    }
    const Number value = parameters::evaluate(request_.section().text("Expression"), table);
    return value.bare ? std::optional(Dimension{}) : value.dimension;
  }

  void set_unit(DerivedArray &result) const {
    const Values &section = request_.section();
    const std::optional<Dimension> found = dimension();
    if (!section.has("Unit")) {
      result.unit = found ? parameters::si_unit(*found) : "1";
      return;
    }
    const Number unit = unit_of_result(section);
    if (found && !(*found == unit.dimension))
      section.reject("Unit", "must be a unit of " + parameters::described(*found) +
                                 ", which is what the expression gives.");
    result.unit = section.text("Unit");
    for (double &value : result.values)
      value /= unit.value;
  }

  const Request &request_;
  std::vector<Argument> arguments_;
  parameters::Function function_;
  std::vector<LabelledArray> fields_;
  std::vector<Number> units_;
  Frame frame_;
  std::vector<double> point_;
  std::vector<double> sample_; ///< where the expression is finite and not zero
};

/// Another field where the result is no number.
void fill_in(const Request &request, DerivedArray &result) {
  const LabelledArray other = request.array("Otherwise");
  const bool fits = std::all_of(
      other.dimensions.begin(), other.dimensions.end(),
      [&](const std::string &dimension) { return result.view().find(dimension).has_value(); });
  if (!fits || other.unit != result.unit)
    request.section().reject("Otherwise", "must be a field in " + result.unit + " over " +
                                              parameters::join(result.dimensions, ", ") + ".");
  const Frame frame({result.view()});
  const Operand operand = frame.operand(other);
  for (std::size_t flat = 0; flat < result.values.size(); ++flat) {
    std::size_t rest = flat;
    std::size_t place = 0;
    for (std::size_t d = frame.shape().size(); d-- > 0;) {
      place += rest % frame.shape()[d] * operand.strides[d];
      rest /= frame.shape()[d];
    }
    if (std::isnan(result.values[flat]))
      result.values[flat] = operand.values[place];
  }
}

} // namespace

void check_formula(const Values &section, const AxisNames &names) {
  const std::vector<Argument> arguments = read_arguments(section);
  try {
    read_function(section, arguments);
  } catch (const Refused &refused) {
    section.reject("Expression", refused.what());
  }
  if (section.has("Unit")) {
    if (section.parameters().dimensionless())
      section.reject("Unit", "Unit must not be set when Units = dimensionless.");
    unit_of_result(section);
  }
  for (const std::string &variable :
       parameters::used_variables(section.text("Expression"), section.parameters().variables())) {
    const bool hidden =
        std::any_of(arguments.begin(), arguments.end(),
                    [&](const Argument &argument) { return argument.name == variable; });
    if (!hidden && names.changes(variable))
      section.reject("Expression",
                     "must have no variable that changes from point to point; name '" + variable +
                         "' among Fields to take it along its axis.");
  }
}

DerivedArray evaluate_formula(const Request &request) {
  try {
    DerivedArray result = Formula(request).evaluate();
    if (request.section().has("Otherwise"))
      fill_in(request, result);
    return result;
  } catch (const Refused &refused) {
    request.section().reject("Expression", refused.what());
  }
}

} // namespace vibroimpact::derived
