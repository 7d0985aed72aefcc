// Friction along two directions: against figures of an independent program
// (tests/support/planar_friction_reference.py), against friction along one direction where the
// motion keeps to one, and against closed forms.
#include "contact/friction/planar_spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "support/planar_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace planar_friction_tests {

using namespace model;
using contact::ContactLaw;
using contact::ContactSet;
using contact::FrictionalLaw;
using contact::Hertz;
using contact::KelvinVoigt;
using contact::LinearPenalty;
using contact::PlanarSpringSlider;
using contact::SpringSlider;
using contact::SpringSliderConstants;
using contact::Viscous;
using testing::across_the_ground;
using testing::Changes;
using testing::on_the_ground;
using testing::precise;
using testing::Sled;
using testing::sled_model;
using testing::vector_of;

const Sled pressed{
    .mass = 1, .kx = 1, .ky = 1.7, .driven = true, .start = {1.5, 0.5, 0, 0.2, -1, 0}};
const Sled flying{.mass = 2, .kx = 4e5, .ky = 1e5, .start = {0, 0, 0.099, 0.3, 0.2, 1}};
const Sled sliding{
    .mass = 2, .kx = 400, .ky = 100, .weight = 60, .start = {0, 0, 0.112, 0.8, -0.5, 0}};

/// State x, y, z, x', y', z' and the deformation of the tangential spring; the slip is that of the
/// ground on the mass.
struct Reference {
  double time;
  const char *mode;
  double state[8];
};

struct Case {
  const char *name;
  std::shared_ptr<const ContactLaw> normal;
  SpringSliderConstants constants;
  Sled sled;
  double end;
  std::vector<Reference> changes;
  Reference last;
};

std::ostream &operator<<(std::ostream &out, const Case &of) { return out << of.name; }

std::vector<Case> cases() {
  return {
      {.name = "planar spring-slider",
       .normal = std::make_shared<contact::ConstantForce>(10),
       .constants = {.stiffness = 20, .coefficient = 0.1, .damping_constant = 0},
       .sled = pressed,
       .end = 16,
       .changes = {{0.0489873531261052,
                    "slip",
                    {1.50899833929809, 0.450816365629648, 0, 0.165824212823049, -0.999132449873178,
                     0, 0.0089983392980884, -0.0491836343703521}},
                   {5.3078161651912,
                    "stick",
                    {-0.698741173322129, -0.248439678650026, 0, 0.0638435238570978,
                     -0.0494486005707686, 0, -0.0306169266478815, -0.0395297837413544}},
                   {5.73726025323503,
                    "slip",
                    {-0.618759084759125, -0.216852236445888, 0, 0.202498077376525,
                     0.148189391082624, 0, 0.0493651619151219, -0.00794234153721634}},
                   {9.56178468704502,
                    "stick",
                    {0.257255658859042, 0.214255393693958, 0, -0.0351689290988684,
                     0.0331353198387877, 0, 0.034287518146827, 0.0363918411093889}},
                   {10.104759660647,
                    "slip",
                    {0.173681961115662, 0.169444971897997, 0, -0.134077094707706,
                     -0.113672143298354, 0, -0.049286179596553, -0.00841858068657255}},
                   {10.381015715885,
                    "stick",
                    {0.156652438746511, 0.152931513920628, 0, -5.71263901173627e-05,
                     0.000138472545840626, 0, -0.0462211693011754, -0.0190683902947281}},
                   {11.2969289430319,
                    "slip",
                    {0.154771167117648, 0.158356034655287, 0, -0.0979978542053037,
                     -0.116867123059923, 0, -0.0481024409300383, -0.0136438695600691}},
                   {13.312676675603,
                    "stick",
                    {-0.111900260954356, -0.0605042355431574, 0, 0.0355858191933943,
                     -0.0229954450360006, 0, -0.0271370439405751, -0.041995009776964}},
                   {15.1076187659362,
                    "slip",
                    {-0.0351710186404316, -0.012136325288516, 0, 0.0846979301062688,
                     0.100168062834435, 0, 0.0495921983733492, 0.00637290047767744}}},
       .last = {16,
                "slip",
                {0.0167416176971444, 0.0134233439477358, 0, 0.0338782334993193, 0.0111304556892291,
                 0, 0.0483192365206348, 0.0128550138880887}}},
      {.name = "planar spring-slider with a dashpot",
       .normal = std::make_shared<contact::ConstantForce>(10),
       .constants = {.stiffness = 20, .coefficient = 0.1, .damping_constant = 0.8},
       .sled = pressed,
       .end = 16,
       .changes = {{0.00923692503834771,
                    "slip",
                    {1.50181449687105, 0.490777638757357, 0, 0.192829117190304, -0.996537049428346,
                     0, 0.00181449687104892, -0.00922236124264281}},
                   {5.31211321108563,
                    "stick",
                    {-0.713589419827405, -0.25419058245046, 0, 0.0582899078519614,
                     -0.049367596396326, 0, -0.0325633245544725, -0.0378504465845277}},
                   {5.74768512484297,
                    "slip",
                    {-0.638396020129394, -0.225709760922489, 0, 0.17945105728063, 0.124834737619016,
                     0, 0.0426300751435383, -0.00936962505655658}},
                   {9.58163074161678,
                    "stick",
                    {0.279586307775907, 0.22842182143311, 0, -0.0324403754282823,
                     0.0323526720411943, 0, 0.0354458562472531, 0.0352284562935924}},
                   {10.1367318158109,
                    "slip",
                    {0.199795754767177, 0.18659276777516, 0, -0.114601178773376,
                     -0.0923491309254035, 0, -0.0443446967614771, -0.00660059736435729}},
                   {10.3930016571386,
                    "stick",
                    {0.186292649110013, 0.174062899496194, 0, 0.000993371777126292,
                     -0.00386330869163197, 0, -0.0473502190333964, -0.0160231710841474}},
                   {11.2560855508299,
                    "slip",
                    {0.188688051012712, 0.178344804410438, 0, -0.0719525755644184,
                     -0.0704839271586938, 0, -0.0449548171306978, -0.0117412661699027}},
                   {13.4154124198135,
                    "stick",
                    {-0.0975054776164215, -0.0642672319430859, 0, 0.0369448770499535,
                     -0.0234257521150557, 0, -0.0268849640544701, -0.0421265945283383}},
                   {15.2321398004024,
                    "slip",
                    {-0.0235589354409835, -0.0146907185512451, 0, 0.0484498134080034,
                     0.0625517412858454, 0, 0.0470615781209679, 0.00744991886350253}}},
       .last = {16,
                "slip",
                {-0.00135732496849606, 0.00540017980812697, 0, 0.0176654554347215,
                 0.00946920362837035, 0, 0.0462539304294937, 0.0189887080741903}}},
      {.name = "planar flight, kelvin-voigt",
       .normal = std::make_shared<KelvinVoigt>(3e4, 90),
       .constants = {.stiffness = 2e5, .coefficient = 0.3, .damping_constant = 150},
       .sled = flying,
       .end = 0.03,
       .changes = {{0.00099999999999997,
                    "stick",
                    {0.000290099525129865, 0.00019833749504312, 0.1, 0.270496678545015,
                     0.195020798642096, 1, 0, 0}},
                   {0.00099999999999997,
                    "slip",
                    {0.000290099525129865, 0.00019833749504312, 0.1, 0.270496678545015,
                     0.195020798642096, 1, 0, 0}},
                   {0.0167399403601365,
                    "stick",
                    {0.000292876386047806, -6.36720119276134e-05, 0.105525600900912,
                     -0.0343611249371657, -0.00308286422246652, -0.347832182864951,
                     0.000161114007047292, -0.000147230415913302}},
                   {0.0187269522965562,
                    "slip",
                    {0.000114049774234714, -3.67731938595618e-05, 0.104712884223882,
                     -0.1251666628515, 0.02802062232655, -0.464415557162448, -1.77126047658003e-05,
                     -0.00012033159784525}},
                   {0.0240257546450682,
                    "separating",
                    {-0.000205510155510524, 0.000123192192944545, 0.101786990301936,
                     0.0528353076002799, 0.0178717405853214, -0.595663433978608, 0, 0}},
                   {0.0270257546450681,
                    "open",
                    {6.83721984042958e-05, 0.000146181509275242, 0.1, 0.101506172373314,
                     -0.00312461981270475, -0.595663433978608, 0, 0}}},
       .last = {0.03,
                "open",
                {0.000236729734607456, 0.000106403847078912, 0.0982283507983863,
                 -0.00550100748453079, -0.0226302010157601, -0.595663433978608, 0, 0}}},
      {.name = "planar flight, hertz",
       .normal = std::make_shared<Hertz>(contact::HertzConstants{.stiffness = 1e5}),
       .constants = {.stiffness = 2e5, .coefficient = 0.3, .damping_constant = 150},
       .sled = flying,
       .end = 0.03,
       .changes =
           {{0.00099999999999997,
             "stick",
             {0.000290099525129865, 0.00019833749504312, 0.1, 0.270496678545015, 0.195020798642096,
              1, 0, 0}},
            {0.00099999999999997,
             "slip",
             {0.000290099525129865, 0.00019833749504312, 0.1, 0.270496678545015, 0.195020798642096,
              1, 0, 0}},
            {0.0241190430364942,
             "stick",
             {-0.000278865120217526, -0.000137091602856507, 0.114273033924642, 0.0364971895957391,
              0.0746281675869839, -0.162686409391975, -0.000233039295238215, 9.60962109020573e-05}},
            {0.0259394110668999,
             "slip",
             {-0.000111241747229633, -2.45526374925431e-05, 0.113837426584927, 0.12995745370617,
              0.0445489380521203, -0.31472992364542, -6.54159222503217e-05, 0.000208635176266021}},
            {0.0296707596529137,
             "stick",
             {0.000228735739385556, 8.91240225307632e-06, 0.112125735360097, 0.000466078105794767,
              -0.0187716784283386, -0.593603535692982, 0.000166036847812797, 0.00012557118812449}}},
       .last = {0.03,
                "stick",
                {0.000225543804737164, 2.12618732181194e-06, 0.111926707998093, -0.0197200322518005,
                 -0.022381058166127, -0.615316186529427, 0.000162844913164405,
                 0.000118784973193226}}},
      {.name = "planar slide, kelvin-voigt",
       .normal = std::make_shared<KelvinVoigt>(3e3, 10),
       .constants = {.stiffness = 2e4, .coefficient = 0.3, .damping_constant = 0},
       .sled = sliding,
       .end = 0.4,
       .changes =
           {{0.000573906342153405,
             "slip",
             {0.000458868040637918, -0.000286794887444135, 0.112001974240758, 0.798656552741582,
              -0.499172689918014, 0.00687643824263078, 0.000458868040637918,
              -0.000286794887444135}},
            {0.0756207997670358,
             "stick",
             {0.0336740492870465, -0.0239882886455246, 0.126370874864881, -0.0427363626701421,
              -0.0236027773779052, 0.055814659969746, 0.000555422482081948, -0.0010581483910613}},
            {0.0918517235943092,
             "slip",
             {0.031964679135823, -0.0229851075344441, 0.125999042899095, -0.118471779024314,
              0.118658326487754, -0.098005627576725, -0.00115394766914157, -5.49672799807997e-05}},
            {0.152111740594384,
             "stick",
             {0.0293189018411181, -0.0214671266565726, 0.115110532790917, 0.00152504358470524,
              0.00727084226733103, -0.0834841381368686, -0.00065996257049079,
              -9.97031427287945e-05}}},
       .last = {0.4,
                "stick",
                {0.0293177765016998, -0.0214791724331332, 0.122805958024857, 0.000810363648781539,
                 0.0012361343803088, 0.0280749223719218, -0.000661087909909004,
                 -0.000111748919289341}}},
      {.name = "planar slide, hertz",
       .normal = std::make_shared<Hertz>(contact::HertzConstants{.stiffness = 2e4}),
       .constants = {.stiffness = 2e4, .coefficient = 0.3, .damping_constant = 0},
       .sled = sliding,
       .end = 0.4,
       .changes =
           {{0.000418221873784628,
             "slip",
             {0.000334478022550279, -0.000209049678319422, 0.112001473984953, 0.799286475185709,
              -0.499560604162844, 0.00704864925547266, 0.000334478022550279,
              -0.000209049678319422}},
            {0.0723149082868452,
             "stick",
             {0.0342778141309435, -0.0241132213745958, 0.128834826298599, -0.0428094321313164,
              -0.0213263501599063, -0.0824159919436625, 0.000822417734149463,
              -0.00121710570347165}},
            {0.0886969939931464,
             "slip",
             {0.0322533984390421, -0.022899303243091, 0.12522644203318, -0.145209269728292,
              0.134616649569382, -0.333449808140055, -0.00120199795775198, -3.18757196686705e-06}},
            {0.185930603133127,
             "stick",
             {0.0205084844067615, -0.0181589952812671, 0.12602058008601, -0.021724373420767,
              0.00466041430960603, 0.306087685884528, -0.00123076506227576, 0.000266113909472435}},
            {0.239819289316815,
             "slip",
             {0.0209367036126994, -0.0182582645742428, 0.119544491175602, -0.075029668596713,
              0.0164547423938039, -0.38941674917937, -0.000802545856337861, 0.000166844616496669}},
            {0.295070452923622,
             "stick",
             {0.0187887350423121, -0.0177621606041079, 0.116108368002057, -0.0183613356181525,
              0.00438043497810335, 0.330506937971395, -0.00059729669461203, 0.000139348132028394}}},
       .last = {0.4,
                "stick",
                {0.0192577077893864, -0.0178743371041445, 0.112564252178388, -0.0130978144082636,
                 0.00247090558718936, -0.135990172469568, -0.000128323947537802,
                 2.7171631991845e-05}}},
  };
}

class PlanarFrictionTest : public ::testing::TestWithParam<std::tuple<Case, const char *>> {};
INSTANTIATE_TEST_SUITE_P(Cases, PlanarFrictionTest,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values("exact", "rk")));

TEST_P(PlanarFrictionTest, EveryChangeAndTheEnd) {
  const auto &[of, method] = GetParam();
  const double error = std::string(method) == "exact" ? 1e-10 : 1e-8;
  const Model model = sled_model(of.sled);
  const ContactSet contacts(
      {on_the_ground(model,
                     std::make_shared<FrictionalLaw>(
                         of.normal, std::make_shared<PlanarSpringSlider>(of.constants)),
                     across_the_ground())});
  Trajectory trajectory(model, contacts, precise(method));
  Changes changes(contacts);
  const Vector start = Eigen::Map<const Vector>(of.sled.start.data(), 6);
  trajectory.start(0, start.head(3), start.tail(3));
  trajectory.advance(of.end, changes);
  const Index springs = trajectory.layout().internal();
  const auto expect_state = [&](const Vector &state, const Reference &expected) {
    for (Index i = 0; i < 6; ++i)
      EXPECT_NEAR(state[i], expected.state[i], error) << expected.time << " " << i;
    for (Index i = 0; i < 2; ++i)
      EXPECT_NEAR(state[springs + i], -expected.state[6 + i], error) << expected.time << " " << i;
  };
  ASSERT_EQ(changes.list.size(), of.changes.size());
  for (std::size_t i = 0; i < of.changes.size(); ++i) {
    EXPECT_NEAR(changes.list[i].time, of.changes[i].time, error) << i;
    EXPECT_EQ(changes.list[i].to, of.changes[i].mode) << i;
    expect_state(changes.list[i].state, of.changes[i]);
  }
  expect_state(trajectory.state(), of.last);
  EXPECT_LT(trajectory.accuracy().energy_residual, error);
}

class PlanarFrictionMethodsTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, PlanarFrictionMethodsTest, ::testing::Values("exact", "rk"));

// Where all is the same along all directions, the motion keeps to one, and friction along that one
// says all: in flight against a side, with and without a dashpot, and where the force begins with
// nothing. Without a dashpot the spring turns at the rate k_t |v| / (mu N) towards the slip: where
// N begins without a slope explicit steps would be without number.
TEST_P(PlanarFrictionMethodsTest, MotionAlongOneDirection) {
  const std::vector<std::shared_ptr<const ContactLaw>> normals = {
      std::make_shared<LinearPenalty>(3e4), std::make_shared<KelvinVoigt>(3e4, 90),
      std::make_shared<Hertz>(contact::HertzConstants{.stiffness = 1e5})};
  for (const auto &normal : normals)
    for (const double dashpot : {0.0, 150.0}) {
      if (dashpot == 0 && normal == normals.back() && std::string(GetParam()) == "rk")
        continue;
      SCOPED_TRACE(normal->name() + " " + std::to_string(dashpot));
      EXPECT_LT(testing::apart_along_one_direction(
                    normal, std::make_shared<SpringSlider>(2e5, 0.3, dashpot),
                    std::make_shared<PlanarSpringSlider>(SpringSliderConstants{
                        .stiffness = 2e5, .coefficient = 0.3, .damping_constant = dashpot}),
                    GetParam()),
                1e-8);
    }
}

// x'' = -c x' / m along both directions.
TEST_P(PlanarFrictionMethodsTest, ViscousFriction) {
  const Sled sled{.mass = 2};
  const Model model = sled_model(sled);
  const ContactSet contacts({on_the_ground(
      model, testing::constant_with(10, std::make_shared<Viscous>(3, 2)), across_the_ground())});
  Trajectory trajectory(model, contacts, precise(GetParam()));
  trajectory.start(0, vector_of({0, 0, 0}), vector_of({1, -0.5, 0}));
  trajectory.advance(1, Observers({}));
  const Vector &x = trajectory.state();
  EXPECT_NEAR(x[3], std::exp(-1.5), 1e-9);
  EXPECT_NEAR(x[4], -0.5 * std::exp(-1.5), 1e-9);
  EXPECT_NEAR(x[0], (1 - std::exp(-1.5)) / 1.5, 1e-9);
}

} // namespace planar_friction_tests
} // namespace vibroimpact::motion
