#include "analyses/results/field_writer.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::analyses {

void FieldWriter::number(const Label &label, double value) const {
  array(label, {}, {value});
  if (listed_ == Listed::no)
    return;
  if (path_.empty() && label.name().find('/') == std::string::npos)
    result_->summary.push_back({.label = label, .value = value});
  else
    line(label.name(), value, label.unit());
}

void FieldWriter::number(const std::string &name, double value, const std::string &unit,
                         const std::string &description) const {
  number(Label(name, unit, description), value);
}

void FieldWriter::series(const std::string &name, const std::string &dimension,
                         std::vector<double> values, const std::string &unit,
                         const std::string &description) const {
  const std::size_t length = values.size();
  array({name, unit, description, {dimension}}, {length}, std::move(values));
}

void FieldWriter::array(const Label &label, std::vector<std::size_t> shape,
                        std::vector<double> values) const {
  result_->fields.push_back({.label = path_.empty()
                                          ? label
                                          : Label(path_ + label.name(), label.unit(),
                                                  label.description(), label.dimensions()),
                             .shape = std::move(shape),
                             .values = std::move(values)});
}

void FieldWriter::array(const Label &label, const Matrix &values) const {
  const Matrix transposed = values.transpose(); // last dimension fastest
  std::vector<std::size_t> shape = {static_cast<std::size_t>(values.size())};
  if (label.dimensions().size() == 2)
    shape = {static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())};
  array(label, std::move(shape), {transposed.data(), transposed.data() + transposed.size()});
}

void FieldWriter::line(const std::string &name, double value, const std::string &unit) const {
  std::string dotted = path_ + name;
  std::replace(dotted.begin(), dotted.end(), '/', '.');
  result_->summary.push_back({.label = Label(dotted, unit, ""), .value = value});
}

const Field *find(const PointResult &result, std::string_view name) {
  const auto found = std::find_if(result.fields.begin(), result.fields.end(),
                                  [&](const Field &field) { return field.name() == name; });
  return found == result.fields.end() ? nullptr : &*found;
}

const Field &field_of(const PointResult &result, std::string_view name) {
  const Field *field = find(result, name);
  if (field == nullptr)
    throw std::out_of_range("no field " + std::string(name));
  return *field;
}

double number_of(const PointResult &result, std::string_view name, double otherwise) {
  const Field *field = find(result, name);
  return field == nullptr || field->values.empty() ? otherwise : field->values[0];
}

} // namespace vibroimpact::analyses
