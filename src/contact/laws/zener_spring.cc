#include "contact/laws/zener_spring.h"

#include <cmath>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Zener";

/// e2 = by_elongation e + by_dashpot z
struct InnerNode {
  double by_elongation = 1, by_dashpot = 0;
};

InnerNode inner_node(const ZenerConstants &k) {
  if (!k.series)
    return {};
  const double sum = *k.series + k.parallel + k.branch;
  return {.by_elongation = *k.series / sum, .by_dashpot = k.branch / sum};
}

std::vector<Mode> connected(const ZenerConstants &k) {
  Mode mode{.name = "connected", .in_contact = true};
  if (k.exponent == 1) {
    const InnerNode node = inner_node(k);
    const double by_elongation = k.branch * node.by_elongation;
    const double by_dashpot = k.branch * (node.by_dashpot - 1);
    AffineLaw law;
    law.force.gap = -(k.parallel * node.by_elongation + by_elongation);
    law.force.internal = {-(k.parallel * node.by_dashpot + by_dashpot)};
    AffineForm rate;
    rate.gap = by_elongation / k.damping;
    rate.internal = {by_dashpot / k.damping};
    law.internal_rate = {rate};
    mode.affine = law;
  }
  return {mode};
}

} // namespace

ZenerSpring::ZenerSpring(const ZenerConstants &constants)
    : ContactLaw(connected(constants), {0.0}), constants_(constants) {}

void ZenerSpring::declare(parameters::Section &connection) {
  using namespace parameters;
  connection
      .subsection(
          section_name,
          "A spring in series with another one, beside which there is a dashpot on a spring "
          "of its own: tension that relaxes. The dashpot begins without elongation.")
      .quantity("Series stiffness", "", dimension::stiffness, range::positive, "k_1",
                "Spring between the first end and the others; empty: rigid.")
      .quantity("Parallel stiffness", "0 N/m", dimension::stiffness, range::non_negative, "k_2",
                "Spring beside the branch of the dashpot, which stays when that has relaxed.")
      .quantity("Branch stiffness", "", dimension::stiffness, range::positive, "k_3",
                "Spring in series with the dashpot.")
      .required()
      .quantity("Damping constant", "", dimension::any, range::positive, "c",
                "Force of the dashpot over the power of its rate, in N (s/m)^a; N s/m with "
                "Exponent = 1.")
      .required()
      .quantity("Exponent", "1", dimension::none, Range{.lower = 0, .upper = 1, .lower_open = true},
                "a", "Power of the rate of the dashpot.");
}

std::shared_ptr<const ContactLaw> ZenerSpring::create(const parameters::Values &connection) {
  const parameters::Values law = connection.subsection(section_name);
  law.require("Branch stiffness");
  law.require("Damping constant");
  const double exponent = law.quantity("Exponent");
  ZenerConstants constants{
      .series = {},
      .parallel = law.quantity("Parallel stiffness"),
      .branch = law.quantity("Branch stiffness"),
      .damping = law.quantity_of("Damping constant",
                                 {.length = 1 - exponent, .mass = 1, .time = exponent - 2}),
      .exponent = exponent};
  if (law.has("Series stiffness"))
    constants.series = law.quantity("Series stiffness");
  return std::make_shared<ZenerSpring>(constants);
}

std::vector<InternalState> ZenerSpring::internal_states() const {
  return {{.name = "dashpot_elongation", .unit = "m", .description = "elongation of the dashpot"}};
}

void ZenerSpring::evaluate(int /*mode*/, const LocalState &state, LawResponse &response) const {
  const ZenerConstants &k = constants_;
  const InnerNode node = inner_node(k);
  const double inner = node.by_elongation * state.gap + node.by_dashpot * state.internal[0];
  const double pull = k.branch * (inner - state.internal[0]);
  const double power = 1 / k.exponent;
  const double rate = std::copysign(std::pow(std::abs(pull) / k.damping, power), pull);
  const double rate_by_pull = power * std::pow(std::abs(pull) / k.damping, power - 1) / k.damping;
  const double tension = k.parallel * inner + pull;
  response.force = -tension;
  response.force_by_gap = -(k.parallel + k.branch) * node.by_elongation;
  response.force_by_gap_rate = 0;
  response.force_by_internal = {k.branch - (k.parallel + k.branch) * node.by_dashpot};
  response.internal_rate = {rate};
  response.internal_rate_by_gap = {rate_by_pull * k.branch * node.by_elongation};
  response.internal_rate_by_gap_rate = {0};
  response.internal_rate_by_internal = {rate_by_pull * k.branch * (node.by_dashpot - 1)};
  const double in_series = k.series ? tension * tension / *k.series : 0;
  response.stored_energy = (in_series + k.parallel * inner * inner + pull * pull / k.branch) / 2;
  response.dissipated_power = pull * rate;
}

} // namespace vibroimpact::contact
