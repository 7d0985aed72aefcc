#include "analyses/basin_rows.h"

#include "common/error.h"
#include "contact/same_law.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

// Of initial states at equally spaced values of a key, relative to the largest of them: a reading
// of texts with units leaves a few roundings.
constexpr double proportional = 1e-12;

Vector state_of(const model::InitialState &initial) {
  Vector state(initial.displacement.size() + initial.velocity.size());
  state << initial.displacement, initial.velocity;
  return state;
}

bool same_history(const model::TimeFunction &a, const model::TimeFunction &b) {
  if (a.period() != b.period() || a.highest_frequency() != b.highest_frequency())
    return false;
  for (int i = 0; i < 7; ++i) {
    const double time = (i + 0.3) / 7 * (a.period() > 0 ? a.period() : 1);
    if (a.value(time) != b.value(time) || a.rate(time) != b.rate(time) ||
        a.acceleration(time) != b.acceleration(time))
      return false;
  }
  return true;
}

bool same_contacts(const contact::ContactSet &a, const contact::ContactSet &b, double size) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    const contact::ContactPair &one = a.pairs()[c], &other = b.pairs()[c];
    if (one.gap.base_coefficients != other.gap.base_coefficients ||
        !same_law(*one.law, *other.law, size))
      return false;
  }
  return true;
}

} // namespace

void declare_cell_axis(parameters::Section &section, const std::string &name,
                       const std::string &description) {
  using namespace parameters;
  Section &axis = section.subsection(name, description);
  declare_key_range(axis);
  axis.integer("Cells", "200", Range{.lower = 1, .upper = 1e5}, "", "Number of cells.");
}

SweptParameter read_cell_axis(const parameters::Values &section, const std::string &name) {
  const parameters::Values values = section.subsection(name);
  values.require("Parameter");
  SweptParameter axis = read_key_range(values, 2);
  const long cells = values.integer("Cells");
  const double first = axis.values.front();
  const double width = (axis.values.back() - first) / static_cast<double>(cells);
  axis.values.clear();
  for (long i = 0; i < cells; ++i)
    axis.values.push_back(first + (static_cast<double>(i) + 0.5) * width);
  return axis;
}

model::InitialState BasinRow::start(double first) const {
  const Index n = origin.size() / 2;
  const Vector state = origin + first * slope;
  return {.displacement = state.head(n), .velocity = state.tail(n)};
}

BasinRow basin_row(const SweptParameter &first, const SweptParameter &second, double value,
                   const SystemSource &build) {
  const auto built = [&](double at) { return build({second.at(value), first.at(at)}); };
  const double low = first.values.front(), high = first.values.back();
  BasinRow row{.system = built(low), .origin = {}, .slope = {}};
  const Vector start = state_of(row.system.initial);
  row.slope = Vector::Zero(start.size());
  if (high > low) {
    const System end = built(high), middle = built(0.5 * (low + high));
    const Vector last = state_of(end.initial);
    const double size = std::max(start.cwiseAbs().maxCoeff(), last.cwiseAbs().maxCoeff());
    const double bend = (state_of(middle.initial) - 0.5 * (start + last)).cwiseAbs().maxCoeff();
    if (!same_motions(row.system, end, size > 0 ? size : 1) || !(bend <= proportional * size))
      throw InputError(first.origin + " the key " + first.path +
                       " of the first axis must change initial conditions only, and these in "
                       "proportion; other keys may stand in the second axis.");
    row.slope = (last - start) / (high - low);
  }
  row.origin = start - low * row.slope;
  return row;
}

bool same_motions(const System &a, const System &b, double size) {
  if (motion::structure_of(a.model, a.contacts) != motion::structure_of(b.model, b.contacts) ||
      motion::data_of(a.model, a.contacts) != motion::data_of(b.model, b.contacts))
    return false;
  const auto &one = a.model.sources(), &other = b.model.sources();
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const model::Source &x, const model::Source &y) {
                      return same_history(*x.function, *y.function);
                    }) &&
         same_contacts(a.contacts, b.contacts, size);
}

} // namespace vibroimpact::analyses
