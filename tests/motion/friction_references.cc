// A particle on a tangential spring that meets a side at an angle, with friction under normal laws
// that are damped or not linear, against figures of an independent program:
// tests/support/friction_reference.py.
#include "contact/friction/spring_slider.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace friction_references_tests {

using namespace model;
using contact::ContactLaw;
using contact::ContactSet;
using contact::Coulomb;
using contact::FrictionalLaw;
using contact::Hertz;
using contact::HuntCrossley;
using contact::KelvinVoigt;
using contact::SpringSlider;
using testing::Changes;
using testing::oblique_contact;
using testing::particle;
using testing::settings_of;
using testing::vector_of;

/// State x, y, x', y' and the deformation of the tangential spring towards x. The slip is that of
/// the ground on the particle.
struct Reference {
  double time;
  const char *mode;
  double x, y, vx, vy, deformation;
};

struct Case {
  const char *name;
  std::shared_ptr<const ContactLaw> normal;
  std::shared_ptr<const contact::TangentialLaw> tangential;
  double spring, speed, start; ///< along x
  double end;
  std::vector<Reference> changes;
  Reference last;
};

std::ostream &operator<<(std::ostream &out, const Case &of) { return out << of.name; }

std::vector<Case> cases() {
  const auto slider = [](double k) { return std::make_shared<SpringSlider>(k, 0.3, 0); };
  const auto coulomb = std::make_shared<Coulomb>(0.3, 0.3);
  const auto kelvin_voigt = std::make_shared<KelvinVoigt>(3e4, 90);
  const auto hertz = std::make_shared<Hertz>(contact::HertzConstants{.stiffness = 1e5});
  const auto hunt_crossley = HuntCrossley::with_dissipation({.stiffness = 1e5}, 0.2);
  return {
      {.name = "kelvin-voigt, spring-slider",
       .normal = kelvin_voigt,
       .tangential = slider(2e4),
       .spring = 0,
       .speed = 0.9,
       .start = 0,
       .end = 0.03,
       .changes = {{0.00099999999999997, "stick", 0.000899999999999974, 0.1, 0.9, 1, 0},
                   {0.00344712268425298, "slip backward", 0.00308049458050511, 0.102282667748561,
                    0.873186368333747, 0.854291921224291, 0.00218049458050514},
                   {0.0240257546450681, "separating", 0.0156267245434669, 0.101786990301936,
                    0.438199761772876, -0.595663433978609, 1.04693272280632e-17},
                   {0.027025754645068, "open", 0.0169413238287855, 0.1, 0.438199761772876,
                    -0.595663433978609, 1.04693272280632e-17}},
       .last = {0.03, "open", 0.0182446374347708, 0.0982283507983862, 0.438199761772876,
                -0.595663433978609, 1.04693272280632e-17}},
      {.name = "kelvin-voigt, spring-slider on a spring",
       .normal = kelvin_voigt,
       .tangential = slider(2e5),
       .spring = 400000,
       .speed = 0.25,
       .start = 0,
       .end = 0.03,
       .changes = {{0.00099999999999997, "stick", 0.000241749604274888, 0.1, 0.225413898787513, 1,
                    0},
                   {0.00184272772824525, "slip backward", 0.000408172022738206, 0.100825481135277,
                    0.162509931493563, 0.957598276858102, 0.000166422418463318},
                   {0.00299695986095999, "stick", 0.000522632961782035, 0.10189088047957,
                    0.0306593425540689, 0.886021208097659, 0.000204702484673841},
                   {0.00641525572354965, "slip forward", 3.57083708125603e-05, 0.104461598336768,
                    -0.227022904747104, 0.603334675118986, -0.000282222106295633},
                   {0.0094346292139205, "stick", -0.000372823509026233, 0.105837985021811,
                    -4.04411093282435e-05, 0.304749152947844, -0.000303850461629438},
                   {0.0135599583958453, "slip backward", 0.000199293107379251, 0.106250714644364,
                    0.147958657082457, -0.0964148460766311, 0.000268266154776046},
                   {0.01558228405043, "stick", 0.000334421852909717, 0.105881139147047,
                    -0.0222109597134881, -0.264653896999843, 0.00022892298552212},
                   {0.0186935742957375, "slip forward", -4.48061964268401e-05, 0.104728357691849,
                    -0.159501770942111, -0.462748387546269, -0.000150305063814438},
                   {0.0220387887875775, "stick", -0.000305194495872891, 0.102958641065061,
                    0.0284734753636563, -0.57757809137851, -5.51658055916291e-05},
                   {0.0232277162981834, "slip backward", -0.000228283309807204, 0.102261589231584,
                    0.0963008899629756, -0.59278618479433, 2.17453804740577e-05},
                   {0.0240257546450682, "separating", -0.000139121726206535, 0.101786990301936,
                    0.125064009494202, -0.595663433978604, -5.16690097825123e-19},
                   {0.0270257546450681, "open", 0.000240738905758872, 0.1, 0.0889996250672293,
                    -0.595663433978604, -5.16690097825123e-19}},
       .last = {0.03, "open", 0.000250655023827124, 0.0982283507983863, -0.0833450011539263,
                -0.595663433978604, -5.16690097825123e-19}},
      {.name = "hertz, coulomb",
       .normal = hertz,
       .tangential = coulomb,
       .spring = 400000,
       .speed = 0.25,
       .start = 0,
       .end = 0.05,
       .changes = {{0.00099999999999997, "slip backward", 0.000241749604274888, 0.1,
                    0.225413898787513, 1, 0},
                   {0.00349698737471938, "slip forward", 0.000557736573269584, 0.102492545350155, 0,
                    0.99377712533127, 0},
                   {0.0103771946434702, "slip backward", -0.000489604021541641, 0.108930491355974,
                    0, 0.835779295873819, 0},
                   {0.017218629122131, "slip forward", 0.00030573109055909, 0.11335868442928, 0,
                    0.418295341931314, 0},
                   {0.0241479589497288, "stick", -5.12517890651746e-05, 0.114268294060286, 0,
                    -0.165151162715158, 0},
                   {0.0354443243284377, "slip backward", -5.12517890651746e-05, 0.107758275147139,
                    0, -0.887655944954027, 0},
                   {0.0434626283148459, "open", 1.78846016575787e-05, 0.1, 0.0117626175326387,
                    -0.999999999999656, 0}},
       .last = {0.05, "open", -1.17730387388947e-05, 0.0934626283148477, -0.0132140106810797,
                -0.999999999999656, 0}},
      {.name = "hunt-crossley, coulomb",
       .normal = hunt_crossley,
       .tangential = coulomb,
       .spring = 400000,
       .speed = 0.25,
       .start = 0,
       .end = 0.05,
       .changes = {{0.00099999999999997, "slip backward", 0.000241749604274888, 0.1,
                    0.225413898787513, 1, 0},
                   {0.00349397265053609, "slip forward", 0.000557484475017199, 0.102488667442731, 0,
                    0.992561632486041, 0},
                   {0.010352932894474, "slip backward", -0.000477637183749909, 0.108828814334667, 0,
                    0.808628944951817, 0},
                   {0.0172078619987834, "slip forward", 0.000278304062612976, 0.112944347925535, 0,
                    0.356543913292188, 0},
                   {0.0242937364328156, "stick", -3.68996632634642e-05, 0.113448826729627, 0,
                    -0.208924328898598, 0},
                   {0.0359086499589708, "slip backward", -3.68996632634642e-05, 0.107001639801041,
                    0, -0.801139011174482, 0},
                   {0.044060201349959, "open", 1.38406798091903e-05, 0.1, 0.00794739922727219,
                    -0.882189986247021, 0}},
       .last = {0.05, "open", -3.9543613685159e-06, 0.0947599691106106, -0.00991698760850239,
                -0.882189986247021, 0}},
      {.name = "hertz, spring-slider",
       .normal = hertz,
       .tangential = slider(4e5),
       .spring = 400000,
       .speed = 0.25,
       .start = 0,
       .end = 0.05,
       .changes = {{0.00099999999999997, "stick", 0.000241749604274888, 0.1, 0.225413898787513, 1,
                    0},
                   {0.00099999999999997, "slip backward", 0.000241749604274888, 0.1,
                    0.225413898787513, 1, 0},
                   {0.00344822312415885, "stick", 0.000557601753683755, 0.102444077227274,
                    0.00552878408667645, 0.994076129337112, 9.06220015548318e-06},
                   {0.00412769666370941, "slip forward", 0.000535482017398778, 0.103117932066337,
                    -0.0696321567136972, 0.989083748228832, -1.3057536129494e-05},
                   {0.0102823754476756, "stick", -0.000489878924105477, 0.108851054586494,
                    -0.00888795794062103, 0.839753763256502, -6.24530700442743e-05},
                   {0.0120344258383933, "slip backward", -0.000349559980921465, 0.110253148866537,
                    0.152329544580713, 0.757761479121372, 7.78658731397371e-05},
                   {0.016847643883661, "stick", 0.000332174978178493, 0.113198221869776,
                    0.00577307671713469, 0.446680603176753, 0.000113719358369412},
                   {0.0195127197556812, "slip forward", 9.27697023852354e-05, 0.114108588630872,
                    -0.140737900474907, 0.232951032763785, -0.000125685917423845},
                   {0.0227770395265558, "stick", -0.000188470216632905, 0.114414100083772,
                    0.00063835205220881, -0.0472622039373183, -0.000129790397719964},
                   {0.026219645574557, "slip backward", 6.21927669890965e-05, 0.113746043058265,
                    0.082329199044164, -0.337425728816922, 0.000120872585902038},
                   {0.0281357934251003, "stick", 0.000139249172611397, 0.112955397167908,
                    -0.00621845562813713, -0.485629042752844, 0.00011059547561496},
                   {0.0314592576167046, "slip forward", -5.74267574072181e-05, 0.110962144562484,
                    -0.0649728561090034, -0.704792589754025, -8.60804544036552e-05},
                   {0.0335301276009104, "stick", -0.000118689612942974, 0.109387929686301,
                    0.00884486046164317, -0.811434650339725, -6.82206739748129e-05},
                   {0.0361183877292321, "slip backward", -5.1013433428509e-06, 0.107152474749334,
                    0.0583921226268356, -0.909361510174991, 4.53675956253099e-05},
                   {0.0395024066704024, "stick", 9.68933470128772e-05, 0.103937941949823,
                    -0.00692095018684604, -0.980344114946658, 1.85338322587535e-05},
                   {0.0408647719125095, "slip forward", 6.84579614300999e-05, 0.102592754389482,
                    -0.0322080367287543, -0.993130459145948, -9.90155332402381e-06},
                   {0.0434626283148428, "open", -3.55515152875634e-05, 0.1, -0.0395524216879298, -1,
                    -8.93868876092042e-17}},
       .last = {0.05, "open", 1.55829276990372e-05, 0.0934626283148428, 0.0420548520636264, -1,
                -8.93868876092042e-17}},
  };
}

class FrictionReferencesTest : public ::testing::TestWithParam<std::tuple<Case, const char *>> {};
INSTANTIATE_TEST_SUITE_P(Cases, FrictionReferencesTest,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values("exact", "rk")));

void expect_state(const Vector &state, const Reference &expected, double error) {
  EXPECT_NEAR(state[0], expected.x, error * 1e-3) << expected.time;
  EXPECT_NEAR(state[1], expected.y, error) << expected.time;
  EXPECT_NEAR(state[2], expected.vx, error) << expected.time;
  EXPECT_NEAR(state[3], expected.vy, error) << expected.time;
}

// With coordinates relative to a table that moves along the normal, where there is one.
void expect_references(const Case &of, const std::string &method, double error,
                       const std::shared_ptr<const Harmonic> &table = {}) {
  const auto table_at = [&](double time) {
    return table ? vector_of({0, table->value(time), 0, table->rate(time)})
                 : vector_of({0, 0, 0, 0});
  };
  Model model({particle("ball", 2, of.spring)});
  if (table)
    model.add_base_motion("table", table, {0}, Vector3::UnitY());
  const ContactSet contacts({oblique_contact(
      model, "ball.head", 0.1, std::make_shared<FrictionalLaw>(of.normal, of.tangential))});
  Settings settings = settings_of(method);
  settings.relative_tolerance = 1e-13;
  settings.absolute_tolerance = 0;
  Trajectory trajectory(model, contacts, settings);
  Changes changes(contacts);
  const Vector start = vector_of({of.start, 0.099, of.speed, 1}) - table_at(0);
  trajectory.start(0, start.head(2), start.tail(2));
  trajectory.advance(of.end, changes);
  ASSERT_EQ(changes.list.size(), of.changes.size());
  for (std::size_t i = 0; i < of.changes.size(); ++i) {
    const Reference &expected = of.changes[i];
    const Changes::Change &found = changes.list[i];
    EXPECT_NEAR(found.time, expected.time, error) << i;
    EXPECT_EQ(found.to, expected.mode) << i;
    expect_state(found.state.head(4) + table_at(found.time), expected, error);
    if (of.tangential->internal_states().size() == 1) {
      EXPECT_NEAR(found.state[trajectory.layout().internal()], -expected.deformation, error * 1e-3)
          << i;
    }
  }
  expect_state(trajectory.state().head(4) + table_at(of.end), of.last, error);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-9);
}

TEST_P(FrictionReferencesTest, EveryChangeAndTheEnd) {
  const auto &[of, method] = GetParam();
  expect_references(of, method, std::string(method) == "exact" ? 1e-10 : 1e-8);
}

TEST(FrictionReferencesMovedTest, SeenFromAShakenTable) {
  const auto shaking = std::make_shared<Harmonic>(Given::displacement, 0.02, 300, 0.3);
  for (const Case &of : cases()) {
    SCOPED_TRACE(of.name);
    expect_references(of, "exact", 1e-10, shaking);
  }
}

} // namespace friction_references_tests
} // namespace vibroimpact::motion
