#include "contact/friction/spring_slider.h"

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Spring-slider";
enum : int { stick = 0, forward = 1, backward = 2 };

} // namespace

void SpringSlider::declare(parameters::Section &friction) {
  using namespace parameters;
  friction
      .subsection(section_name,
                  "A spring in series with a slider, which yields where the force would exceed "
                  "the coefficient times the normal force (Jenkins element).")
      .quantity("Stiffness", "", dimension::stiffness, range::positive, "k_t",
                "Tangential force per unit deformation while the slider sticks.")
      .required()
      .quantity("Coefficient", "", dimension::none, range::positive, "\\mu",
                "Tangential force over normal force at which the slider yields.")
      .required()
      .quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c_t",
                "Of a dashpot beside the spring, in series with the slider.");
}

SpringSliderConstants read_spring_slider(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Stiffness");
  law.require("Coefficient");
  return {.stiffness = law.quantity("Stiffness"),
          .coefficient = law.quantity("Coefficient"),
          .damping_constant = law.quantity("Damping constant")};
}

std::shared_ptr<const TangentialLaw> SpringSlider::create(const parameters::Values &friction) {
  const SpringSliderConstants law = read_spring_slider(friction);
  return std::make_shared<SpringSlider>(law.stiffness, law.coefficient, law.damping_constant);
}

TangentialMode SpringSlider::slip(const std::string &name, double sigma,
                                  const AffineForm &normal_force,
                                  const AffineForm &deformation) const {
  const AffineForm most = sigma * coefficient_ * normal_force;
  const bool follows = follows_normal_rate();
  const AffineForm rate =
      follows ? sigma * coefficient_ / stiffness_ * rate_of_normal_force(normal_force)
              : 1 / damping_constant_ * (most + -stiffness_ * deformation);
  const AffineForm speed = sigma * (AffineForm::rate_along(1) + -1.0 * rate);
  Guard stop{.indicator = speed, .target = stick};
  if (follows)
    stop.reset = {1 / stiffness_ * most};
  return {.name = name,
          .friction = Friction::slip,
          .force = {-1.0 * most},
          .internal_rate = {rate},
          .sliding_speed = speed,
          .guards = {stop}};
}

std::vector<TangentialMode> SpringSlider::modes(const AffineForm &normal_force,
                                                std::size_t first_internal) const {
  AffineForm deformation;
  deformation.internal.assign(first_internal + 1, 0.0);
  deformation.internal.back() = 1;
  const AffineForm rate = AffineForm::rate_along(1);
  const AffineForm pull = stiffness_ * deformation + damping_constant_ * rate;
  const AffineForm most = coefficient_ * normal_force;
  Guard yields{.indicator = most + -1.0 * pull, .target = forward};
  Guard yields_back{.indicator = most + pull, .target = backward};
  if (follows_normal_rate()) {
    yields.reset = {1 / stiffness_ * most};
    yields_back.reset = {-1 / stiffness_ * most};
  }
  return {{.name = "stick",
           .friction = Friction::stick,
           .force = {-1.0 * pull},
           .internal_rate = {rate},
           .guards = {yields, yields_back}},
          slip("slip forward", 1, normal_force, deformation),
          slip("slip backward", -1, normal_force, deformation)};
}

// A jump of the slip rate leaves the spring as it is; the slider goes on only in its direction.
int SpringSlider::mode_by_slip(int mode, const LocalState &state,
                               std::size_t /*first_internal*/) const {
  const double slip_rate = state.tangential[0].slip_rate;
  const bool goes_on = (mode == forward && slip_rate > 0) || (mode == backward && slip_rate < 0);
  return goes_on ? mode : stick;
}

std::vector<InternalState> SpringSlider::internal_states() const {
  return {{.name = "friction_deformation",
           .unit = "m",
           .description = "Deformation of the tangential spring along the direction of friction"}};
}

} // namespace vibroimpact::contact
