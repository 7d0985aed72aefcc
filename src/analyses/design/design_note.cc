#include "analyses/design/design_note.h"

#include <sstream>

namespace vibroimpact::analyses {

NoteSize size_of_design_note(const Objective &objective) {
  const std::size_t goals = objective.goals().size();
  const std::size_t constraints = objective.constraints().size();
  return {.values = 3 + goals + objective.cases() + 2 * constraints,
          .bytes = bytes_of_a_failure + bytes_of_a_unit * (goals + constraints)};
}

// Failed or not, points unbalanced and unsettled; objectives; cases; constraints, their excess. The
// text: the failure or, line by line, the units.
LineNote design_note(const DesignValue &value, const Objective &objective) {
  LineNote note;
  if (value.failed()) {
    note.values.resize(size_of_design_note(objective).values);
    note.values[0] = 1;
    note.text = value.failure;
    return note;
  }
  note.values = {0, value.unbalanced, value.unsettled, value.objective};
  for (const auto *more : {&value.others, &value.cases, &value.constrained, &value.excess})
    note.values.insert(note.values.end(), more->begin(), more->end());
  note.text = value.unit;
  for (const auto *units : {&value.other_units, &value.constrained_units})
    for (const std::string &unit : *units)
      note.text += "\n" + unit;
  return note;
}

DesignValue noted_design_value(const LineNote &note, const Objective &objective) {
  if (note.values.empty())
    return {.failure = "an evaluation that was left out"};
  if (note.values[0] != 0)
    return {.failure = note.text};
  DesignValue value;
  auto number = note.values.begin() + 1;
  value.unbalanced = *number++;
  value.unsettled = *number++;
  value.objective = *number++;
  const auto take = [&number](std::vector<double> &values, std::size_t count) {
    values.assign(number, number + static_cast<std::ptrdiff_t>(count));
    number += static_cast<std::ptrdiff_t>(count);
  };
  take(value.others, objective.goals().size() - 1);
  take(value.cases, objective.cases());
  take(value.constrained, objective.constraints().size());
  take(value.excess, objective.constraints().size());
  std::istringstream units(note.text);
  std::getline(units, value.unit);
  for (std::string unit; std::getline(units, unit);)
    (value.other_units.size() < value.others.size() ? value.other_units : value.constrained_units)
        .push_back(unit);
  return value;
}

} // namespace vibroimpact::analyses
