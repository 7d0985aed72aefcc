#include "analyses/transient/modal.h"

#include "analyses/results/fields.h"
#include "analyses/run/single_point.h"
#include "analyses/transient/assembled_fields.h"
#include "common/log.h"

#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr const char *modal_section = "Modal";

/// The modes of a single body that nothing else holds are in its own pictures.
bool differs_from_bodies(const model::Model &model, const Matrix &tied) {
  return model.bodies().size() > 1 || !model.connections().empty() || !model.bearings().empty() ||
         tied.rows() > 0;
}

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

void Modal::declare(parameters::Section &analysis) {
  declare_tied_contacts(analysis.subsection(modal_section, "Modes of each body, and of the whole "
                                                           "linear system with its connections."));
}

std::shared_ptr<const Analysis> Modal::create(const parameters::Values &analysis) {
  return std::make_shared<Modal>(read_tied_contacts(analysis.subsection(modal_section)));
}

void Modal::check(const System &system) const { tied_(system); }

PointResult Modal::compute(const System &system) const {
  PointResult point;
  const FieldWriter result(point);
  for (const auto &body : system.model.bodies())
    add_body(result, *body);
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    add_contact(result, system, c);
  if (!system.model.rotors().empty()) // whose mass changes as they turn
    return point;
  const Matrix tied = rows_of(tied_(system), system.model.size());
  const model::AssembledModes modes =
      assembled_modes(system.model, model::AssembledSystem(system.model, tied));
  add_assembled_modes(result, system.model, modes);
  for (Index j = 0; j < modes.rigid; ++j)
    log::info("rigid-body mode " + std::to_string(j + 1) +
              " of the whole system: " + moved_points(system.model, modes.shapes.col(j)));
  if (differs_from_bodies(system.model, tied))
    point.motion = {motion_of_modes(system.model, modes)};
  return point;
}

void Modal::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system); });
}

} // namespace vibroimpact::analyses
