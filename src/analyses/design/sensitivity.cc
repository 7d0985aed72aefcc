#include "analyses/design/sensitivity.h"

#include "analyses/design/stored_evaluations.h"
#include "analyses/results/fields.h"
#include "common/bytes.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *sensitivity_section = "Sensitivity";

std::string field_name(const Sensitivity::Quantity &quantity) {
  return "quantity/" + quantity.name;
}

void add_indices(const FieldWriter &result, const std::string &quantity, const std::string &unit,
                 const std::vector<DesignKey> &keys, const SobolIndices &indices) {
  result.number("mean/" + quantity, indices.mean, unit, "mean over all samples");
  result.number("deviation/" + quantity, std::sqrt(indices.variance), unit,
                "standard deviation over all samples");
  result.number("samples/" + quantity, static_cast<double>(indices.rows), "1",
                "samples of which no evaluation failed");
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const SobolIndex &index = indices.arguments[k];
    const std::string path = quantity + "/" + keys[k].name;
    result.number("first_order/" + path, index.first, "1",
                  "share of the variance that the key brings about by itself");
    result.number("first_order_error/" + path, index.first_error, "1", "its standard error");
    result.number("total/" + path, index.total, "1",
                  "share of the variance that the key brings about together with all others");
    result.number("total_error/" + path, index.total_error, "1", "its standard error");
  }
}

} // namespace

Sensitivity::Sensitivity(Settings settings)
    : settings_(std::move(settings)), design_{settings_.samples,
                                              static_cast<Index>(settings_.keys.size()),
                                              static_cast<std::uint64_t>(settings_.seed)} {}

void Sensitivity::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      sensitivity_section,
      "Which of several keys decide about quantities of another analysis, when they "
      "are drawn at random between their bounds: Sobol's indices.");
  section.text("Repeat", "", "Name of the analysis that is evaluated.").required();
  section.named_subsection("Quantity", "What the keys decide about.")
      .text("Quantity", "",
            "The path of a field of the repeated analysis or the name of a Derived of it; one "
            "number.")
      .required();
  declare_design_keys(section);
  section
      .integer("Samples", "500", Range{.lower = 2, .upper = 1e6}, "",
               "Each takes as many evaluations as there are keys, and two more. Standard errors "
               "go down with the square root of their number.")
      .integer("Seed", "1", Range{.lower = 0, .upper = 1e9}, "",
               "Of what is drawn at random: equal seeds give equal results.");
}

std::shared_ptr<const Analysis> Sensitivity::create(const Values &analysis) {
  const Values section = analysis.subsection(sensitivity_section);
  const std::string evaluated = read_evaluated(section);
  refuse_selections(analysis, evaluated);
  std::vector<std::string> taken;
  std::vector<DesignKey> keys = read_design_keys(section, evaluated, taken);
  require_bounds(section, keys);
  std::vector<Quantity> quantities;
  for (const std::string &name : section.instances("Quantity")) {
    const Values one = section.instance("Quantity", name);
    one.require("Quantity");
    quantities.push_back({name, {one.text("Quantity"), one.place("Quantity")}});
  }
  if (quantities.empty())
    section.reject_section("at least one subsection Quantity NAME must be given");
  return std::make_shared<Sensitivity>(
      Settings{.evaluated = evaluated,
               .keys = std::move(keys),
               .quantities = std::move(quantities),
               .samples = static_cast<std::size_t>(section.integer("Samples")),
               .seed = section.integer("Seed")});
}

std::vector<Axis> Sensitivity::axes() const { return {evaluation_axis(design_.points())}; }

std::size_t Sensitivity::message_size() const {
  const std::size_t count = settings_.quantities.size();
  return packed(std::vector<double>(count), std::vector<std::string>(count),
                std::string(longest_failure(count), ' '))
      .size();
}

void Sensitivity::check_outcomes(const Outcomes &outcomes) const {
  check_at_bounds(settings_.keys, settings_.evaluated,
                  [&](const std::vector<parameters::Override> &overrides) {
                    outcomes.check(settings_.evaluated, overrides);
                  });
}

void Sensitivity::try_outcomes(const Outcomes &outcomes) const {
  std::vector<WantedQuantity> wanted;
  for (const Quantity &quantity : settings_.quantities)
    wanted.push_back(quantity.wanted);
  try_single_numbers(outcomes, settings_.evaluated,
                     overrides_at(settings_.keys, start_of_search(settings_.keys, 0, 0)), wanted);
}

void Sensitivity::add_values(PointResult &point, LineContext &context) const {
  std::vector<std::string> paths;
  for (const Quantity &quantity : settings_.quantities)
    paths.push_back(quantity.wanted.path);
  const Vector coordinates = design_.point(point.index[0] - 1);
  const Evaluated evaluated = context.outcomes().evaluate(
      settings_.evaluated, overrides_at(settings_.keys, coordinates), paths,
      [&context](double share) { context.note_progress(share); });
  for (std::size_t q = 0; q < paths.size(); ++q)
    FieldWriter(point).number(field_name(settings_.quantities[q]),
                              single_number(evaluated.outcomes[q], paths[q]),
                              evaluated.outcomes[q].unit, paths[q]);
}

PointResult Sensitivity::evaluate(std::size_t number, LineContext &context) const {
  PointResult point{.index = {number + 1}};
  add_keys(point, settings_.keys, design_.point(number));
  try {
    add_values(point, context);
    return point;
  } catch (const InputError &error) { // of this evaluation alone: the result waits for all
    point.reason = error.what();
  } catch (const NumericalError &error) {
    point.reason = error.what();
  }
  point.status = Status::failed;
  return point;
}

// The quantities with their units, none where the evaluation failed; why it did.
std::string Sensitivity::note(const PointResult &point) const {
  std::vector<double> values;
  std::vector<std::string> units;
  if (point.status != Status::failed)
    for (const Quantity &quantity : settings_.quantities)
      if (const Field *field = find(point, field_name(quantity))) {
        values.push_back(field->values[0]);
        units.push_back(field->unit().substr(0, longest_unit));
      }
  return packed(values, units,
                point.reason.substr(0, longest_failure(settings_.quantities.size())));
}

PointResult Sensitivity::result(const LineContext &context) const {
  std::vector<std::vector<double>> values(settings_.quantities.size());
  std::vector<std::string> units, found_units;
  std::string failure;
  for (std::size_t line = 0; line < design_.points(); ++line) {
    std::vector<double> found;
    std::string reason;
    if (const std::string note = context.message_of(line); !note.empty())
      unpack(note, found, found_units, reason);
    for (std::size_t q = 0; q < values.size(); ++q)
      values[q].push_back(found.empty() ? std::numeric_limits<double>::quiet_NaN() : found[q]);
    if (!found.empty())
      units = found_units;
    else if (failure.empty())
      failure = reason;
  }
  PointResult result{.index = {0}};
  for (std::size_t q = 0; q < values.size(); ++q) {
    const SobolIndices indices = sobol_indices(values[q], static_cast<Index>(settings_.keys.size()),
                                               static_cast<std::uint64_t>(settings_.seed));
    if (indices.rows < 2)
      return {.index = {0},
              .status = Status::failed,
              .reason =
                  "fewer than two samples have all their evaluations; the first that failed: " +
                  failure};
    add_indices({result, "", Listed::yes}, settings_.quantities[q].name, units.at(q),
                settings_.keys, indices);
  }
  return result;
}

void Sensitivity::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  const std::size_t number = line == design_.points() ? 0 : line + 1;
  const PointResult *known = context.find({number});
  if (known != nullptr)
    context.skip();
  if (number == 0) {
    if (known == nullptr)
      context.store(result(context));
    return;
  }
  PointResult point = known != nullptr ? *known : evaluate(line, context);
  const std::string left = note(point);
  if (known == nullptr)
    context.store(std::move(point));
  context.leave_message(line, left);
}

} // namespace vibroimpact::analyses
