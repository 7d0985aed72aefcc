#include "analyses/transient/modal.h"

#include "analyses/results/fields.h"

#include <numbers>

namespace vibroimpact::analyses {

namespace {

std::vector<double> entries(const Vector &vector) { return {vector.begin(), vector.end()}; }

void add_body(const FieldWriter &result, const reduction::ReducedBody &body) {
  const FieldWriter of = result.below("body/" + body.name + "/");
  const auto add = [&](const std::string &name, const Vector &values, const std::string &unit,
                       const std::string &description) {
    of.series(name, "mode_" + body.name, entries(values), unit, description);
  };
  add("frequency", body.omega() / (2 * std::numbers::pi), "Hz", "undamped natural frequency");
  add("damping_ratio", body.damping_ratio(), "1", "fraction of critical damping");
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, static_cast<char>('x' + axis));
    const Vector effective = body.effective_mass().col(axis);
    add("participation_factor_" + name, body.base_participation.col(axis).cwiseQuotient(body.mass),
        "1", "participation of a base motion along " + name);
    add("effective_modal_mass_" + name, effective, "kg", "effective modal mass along " + name);
    if (body.total_mass[axis] > 0)
      of.line("effective_modal_mass_share." + name, effective.sum() / body.total_mass[axis], "1");
  }
}

// The share of each coordinate in the contact's compliance to impulses, 1 / effective mass.
void add_contact(const FieldWriter &result, const System &system, std::size_t c) {
  const contact::ContactPair &pair = system.contacts.pairs()[c];
  const Vector compliance = pair.gap.row.transpose().cwiseAbs2().cwiseQuotient(system.model.mass());
  const FieldWriter of = result.below("contact/" + pair.name + "/");
  of.series("impulse_compliance", "coordinate", entries(compliance), "1/kg",
            "gap speed per impulse, share of each coordinate");
  of.listed().number("effective_mass", system.contacts.effective_mass(c, system.model), "kg",
                     "mass that meets at the contact");
}

} // namespace

void Modal::declare(parameters::Section & /*analysis*/) {}

std::shared_ptr<const Analysis> Modal::create(const parameters::Values & /*analysis*/) {
  return std::make_shared<Modal>();
}

void Modal::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  if (context.find({})) {
    context.skip();
    return;
  }
  PointResult result;
  for (const auto &body : system.model.bodies())
    add_body(result, *body);
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    add_contact(result, system, c);
  context.store(std::move(result));
}

} // namespace vibroimpact::analyses
