// What changes of contacts with friction lead to: the forms and the map that are made once for a
// guard, against the equations at states drawn at random.
#include "motion/phase/friction_routes.h"
#include "contact/friction/spring_slider.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "motion/event/mode_change.h"
#include "motion/phase/exact_change.h"
#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <utility>

namespace vibroimpact::motion {
namespace friction_routes_tests {

using namespace model;
using contact::ContactPair;
using contact::ContactSet;
using testing::coulomb;
using testing::oblique_contact;
using testing::particle;
using testing::sliding_along_x;

constexpr double instant = 0.37;

struct Case {
  const char *name;
  std::function<std::vector<ContactPair>(const Model &)> contacts;
  /// Ends of changes that states drawn at random must come to, by names of modes.
  std::vector<const char *> ends;
};

std::ostream &operator<<(std::ostream &out, const Case &of) { return out << of.name; }

std::shared_ptr<const contact::ContactLaw>
frictional(std::shared_ptr<const contact::ContactLaw> normal,
           std::shared_ptr<const contact::TangentialLaw> tangential) {
  return std::make_shared<contact::FrictionalLaw>(std::move(normal), std::move(tangential));
}

// Two masses on springs, shaken and pushed.
Model shaken_pair() {
  Model model({particle("first", 0.7, 3.0), particle("second", 1.9, 2.0)});
  model.add_base_motion("table", std::make_shared<Harmonic>(Given::displacement, 0.4, 1.3, 0.2),
                        {0, 1}, Vector3::UnitX());
  model.add_force("push", std::make_shared<Harmonic>(Given::displacement, 2.0, 0.9, 0.6),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  return model;
}

std::vector<Case> cases() {
  const auto slider = std::make_shared<contact::SpringSlider>(5.0, 0.4, 0);
  const auto dry = std::make_shared<contact::Coulomb>(0.4, 0.6);
  return {
      {.name = "dry friction of both masses",
       .contacts =
           [](const Model &model) {
             return std::vector{
                 sliding_along_x(model, "first.head", "second.head", coulomb(1.5, 0.8, 1)),
                 sliding_along_x(model, "second.head", "", coulomb(1, 1, 1), 0.3)};
           },
       .ends = {"contact, stick", "contact, slip forward", "contact, slip backward"}},
      {.name = "a mass held twice",
       .contacts =
           [](const Model &model) {
             return std::vector{
                 sliding_along_x(model, "first.head", "", coulomb(1.5, 0.8, 1)),
                 sliding_along_x(model, "first.head", "", coulomb(1, 1, 1), 0.3),
                 sliding_along_x(model, "first.head", "second.head", coulomb(0.7, 1, 1))};
           },
       .ends = {"contact, stick", "contact, slip forward", "contact, slip backward"}},
      {.name = "springs with sliders",
       .contacts =
           [=](const Model &model) {
             return std::vector{
                 oblique_contact(
                     model, "first.head", 0.1,
                     frictional(std::make_shared<contact::KelvinVoigt>(30.0, 2.0), slider)),
                 sliding_along_x(model, "first.head", "second.head", coulomb(1, 1, 2))};
           },
       .ends = {"contact, stick", "contact, slip forward", "contact, slip backward", "open"}},
      {.name = "sides that meet at an angle",
       .contacts =
           [=](const Model &model) {
             return std::vector{
                 oblique_contact(model, "first.head", 0.1,
                                 frictional(std::make_shared<contact::LinearPenalty>(30.0), dry)),
                 oblique_contact(
                     model, "second.head", 0.1,
                     frictional(std::make_shared<contact::LinearPenalty>(50.0), slider))};
           },
       .ends = {"contact, stick", "contact, slip forward", "contact, slip backward", "open"}}};
}

class FrictionRoutesOf : public ::testing::TestWithParam<Case> {
protected:
  FrictionRoutesOf() : contacts_(GetParam().contacts(model_)) { phases_.take_sources(instant); }

  // Positions, velocities and internal states for which a guard is zero.
  Vector state_at(const PhaseForms &forms, std::size_t guard) {
    const Index size = equations_.layout().physical_size();
    Vector x = Vector::Zero(equations_.layout().size());
    std::normal_distribution<double> drawn;
    for (Index i = 0; i < size; ++i)
      x[i] = drawn(generator_);
    const RowVector row = forms.guard_forms().rows.row(static_cast<Index>(guard));
    Vector seen(row.size());
    seen.head(size) = x.head(size);
    std::vector<SourceValues> sources;
    equations_.source_values(instant, sources);
    for (std::size_t k = 0; k < sources.size(); ++k)
      for (Index order = 0; order < 3; ++order)
        seen[size + 3 * static_cast<Index>(k) + order] =
            sources[k][static_cast<std::size_t>(order)];
    const RowVector own = row.head(size);
    const double value = row.dot(seen) + forms.guard_forms().constants[static_cast<Index>(guard)];
    x.head(size) -= value / own.squaredNorm() * own.transpose();
    return x;
  }

  // By the equations: the mode, and the state in place.
  int pass(const std::vector<int> &modes, const PhaseGuard &guard, Vector &x) {
    set_modes(modes);
    const Vector before = x;
    pass_guard(equations_, guard.contact, equations_.mode(guard.contact).guards[guard.guard],
               instant,
               equations_.local_state(guard.contact, instant,
                                      ConstVectorView(before.data(), before.size())),
               x);
    const int mode = equations_.modes()[guard.contact];
    set_modes(modes);
    return mode;
  }

  void compare(LinearPhase &from, std::size_t guard) {
    const PhaseForms &forms = from.forms();
    FrictionRoutes routes(equations_, from, from.phase(), guard);
    Vector inputs(phases_.excitation().size());
    phases_.excitation().coordinates(instant, inputs.data());
    for (int draw = 0; draw < 20; ++draw) {
      Vector x = state_at(forms, guard);
      Amplitudes amplitudes;
      from.phase().amplitudes(x.head(from.phase().n_modes()), inputs.data(), amplitudes);
      const Amplitudes exact(amplitudes.size(), 0.0);
      const FrictionRoutes::Route &route =
          routes.route(routes.choose(amplitudes.data(), exact.data()));
      const int mode = pass(forms.contact_modes(), forms.guards()[guard], x);
      ASSERT_EQ(route.mode, mode) << "guard " << guard;
      ++ends_[equations_.contacts()
                  .pairs()[forms.guards()[guard].contact]
                  .law->modes()[static_cast<std::size_t>(mode)]
                  .name];
      compare_states(from, guard, route, amplitudes, x);
    }
  }

  void compare_states(LinearPhase &from, std::size_t guard, const FrictionRoutes::Route &route,
                      const Amplitudes &amplitudes, const Vector &expected) {
    set_modes(from.forms().contact_modes());
    equations_.set_mode(from.forms().guards()[guard].contact, route.mode);
    ExactPhase &to = phases_.present()->phase();
    const ExactChange change(from.phase(), route.resets, to);
    Amplitudes behind(to.n_amplitudes()), rounding(to.n_amplitudes());
    kernel().change(change.view(), amplitudes.data(), behind.data(), rounding.data());
    Vector y(to.n_modes());
    to.state(behind.data(), y.data());
    EXPECT_LT((y - expected.head(y.size())).cwiseAbs().maxCoeff(), 1e-12 * y.norm());
    set_modes(from.forms().contact_modes());
  }

  void set_modes(const std::vector<int> &modes) {
    for (std::size_t c = 0; c < modes.size(); ++c)
      equations_.set_mode(c, modes[c]);
  }

  const Model model_ = shaken_pair();
  const ContactSet contacts_;
  Equations equations_{model_, contacts_};
  ExactPhases phases_{equations_, Settings{}};
  std::mt19937 generator_{7};
  std::map<std::string, int> ends_;
};

// From every combination of modes through every guard.
TEST_P(FrictionRoutesOf, LeadWhereTheEquationsLead) {
  std::vector<int> modes(contacts_.size(), 0);
  for (bool more = true; more;) {
    set_modes(modes);
    LinearPhase &from = *phases_.present();
    for (std::size_t g = 0; g < from.forms().guards().size(); ++g)
      compare(from, g);
    more = false;
    for (std::size_t c = 0; c < modes.size() && !more; ++c) {
      modes[c] = (modes[c] + 1) % static_cast<int>(contacts_.pairs()[c].law->modes().size());
      more = modes[c] != 0;
    }
  }
  for (const char *name : GetParam().ends)
    EXPECT_GT(ends_[name], 20) << name;
}

INSTANTIATE_TEST_SUITE_P(All, FrictionRoutesOf, ::testing::ValuesIn(cases()));

} // namespace friction_routes_tests
} // namespace vibroimpact::motion
