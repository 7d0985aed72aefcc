#include "model/system_damping.h"

#include "model/assembled_system.h"
#include "reduction/body_sections.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace vibroimpact::model {

namespace {

constexpr const char *damping_section = "System damping";

/// d of each mode [1/s].
Vector mode_damping(const parameters::Values &section, const AssembledModes &modes) {
  if (section.choice("Damping model") == "rayleigh")
    return reduction::sections::optional_quantity(section, "Rayleigh alpha") +
           reduction::sections::optional_quantity(section, "Rayleigh beta") *
               modes.stiffness.array();
  const std::vector<double> ratios = section.quantities("Damping ratio");
  const auto n = static_cast<std::size_t>(modes.stiffness.size());
  if (ratios.size() > n)
    section.reject("Damping ratio", "must have at most " + std::to_string(n) +
                                        " values, one for each mode of the whole system");
  Vector damping = 2 * modes.angular_frequency();
  for (std::size_t j = 0; j < n; ++j)
    damping[static_cast<Index>(j)] *= ratios[std::min(j, ratios.size() - 1)];
  return damping;
}

Projection mode_coordinate(const Model &model, const AssembledModes &modes, Index mode) {
  const Vector shape = modes.shapes.col(mode);
  Projection coordinate{.row = model.mass().cwiseProduct(shape).transpose(),
                        .base_coefficients = std::vector<double>(model.sources().size(), 0)};
  for (std::size_t k = 0; k < model.sources().size(); ++k)
    if (model.moves_base(k) && modes.stiffness[mode] > 0)
      coordinate.base_coefficients[k] = -shape.dot(model.sources()[k].load) / modes.stiffness[mode];
  return coordinate;
}

} // namespace

void Model::add_modal_dashpot(ModalDashpot dashpot) {
  add_dashpot(dashpot.damping, dashpot.coordinate);
  list_drives();
  modal_dashpots_.push_back(std::move(dashpot));
}

void Model::add_dashpot(double damping, const Projection &elongation) {
  damping_.add(damping, elongation.row);
  for (std::size_t k = 0; k < sources_.size(); ++k)
    sources_[k].rate_load -= damping * elongation.base_coefficients[k] * elongation.row.transpose();
}

void declare_system_damping(parameters::Section &root) {
  using namespace parameters;
  root.subsection(damping_section,
                  "Damping of the modes of the whole system: all bodies with their springs and "
                  "connections, contacts open. It is added to that of bodies and connections.")
      .choice("Damping model", "ratio", {"ratio", "rayleigh"},
              "ratio: a fraction of critical damping for each mode; rayleigh: alpha M + beta K.")
      .quantities("Damping ratio", "0", dimension::none, range::non_negative, "\\zeta",
                  "One for each mode, by rising frequency; the last one repeats. Motions without "
                  "strain count, and have no damping.",
                  1, std::numeric_limits<int>::max())
      .quantity("Rayleigh alpha", "", dimension::inverse_time, range::non_negative, "\\alpha",
                "Factor of the mass matrix.")
      .quantity("Rayleigh beta", "", dimension::time, range::non_negative, "\\beta",
                "Factor of the stiffness matrix.");
}

void add_system_damping(const parameters::Values &root, Model &model) {
  const parameters::Values section = root.subsection(damping_section);
  reduction::sections::check_use(section, "Damping model",
                                 {{"Damping ratio", {"ratio"}},
                                  {"Rayleigh alpha", {"rayleigh"}},
                                  {"Rayleigh beta", {"rayleigh"}}});
  const std::vector<double> ratios = section.quantities("Damping ratio");
  if (section.choice("Damping model") == "ratio" &&
      std::all_of(ratios.begin(), ratios.end(), [](double ratio) { return ratio == 0; }))
    return;
  if (!model.rotors().empty())
    section.reject_section("must not be there in a model with rotors, which has no modes");
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  const Vector damping = mode_damping(section, modes);
  for (Index j = 0; j < damping.size(); ++j)
    if (damping[j] != 0)
      model.add_modal_dashpot(
          {.coordinate = mode_coordinate(model, modes, j), .damping = damping[j]});
}

} // namespace vibroimpact::model
