#include "analyses/recorders/sector_work.h"

#include "motion/interval/constraint_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::StepView;

/// w_1 and w_2 along a step.
struct SectorWork::Place {
  std::array<Bernstein, 2> curves;

  /// cos(angle) w_2 - sin(angle) w_1
  Bernstein beyond(double angle) const {
    Bernstein sum = curves[1];
    sum *= std::cos(angle);
    Bernstein first = curves[0];
    first *= -std::sin(angle);
    sum += first;
    return sum;
  }
};

namespace {

double border(Index sector, Index sectors) {
  return std::numbers::pi * static_cast<double>(2 * sector - 1) / static_cast<double>(sectors);
}

// Turned so that it is not negative right after its start.
Bernstein rising(Bernstein curve) {
  if (curve.first_down_crossing() == 0.0)
    curve *= -1;
  return curve;
}

// Instants in (0, 1) at which the sign changes.
void add_sign_changes(const Bernstein &curve, std::vector<double> &instants) {
  Bernstein rest = rising(curve);
  double from = 0;
  for (int zeros = 0; zeros <= curve.degree(); ++zeros) {
    const std::optional<double> fall = rest.first_down_crossing();
    if (!fall || *fall == 0 || *fall == 1)
      return;
    from += *fall * (1 - from);
    instants.push_back(from);
    rest = rest.behind(*fall);
    rest *= -1;
    rest.clear_start();
  }
}

// The integral over tau from 0, for a curve along a step of length h.
Bernstein integral(const Bernstein &curve, double h) {
  std::array<double, Bernstein::maximum_degree + 1> coefficients{};
  const auto degree = static_cast<std::size_t>(curve.degree()) + 1;
  for (std::size_t k = 0; k < degree; ++k)
    coefficients[k + 1] =
        coefficients[k] + h / static_cast<double>(degree) * curve.coefficients()[k];
  return Bernstein::of_coefficients({coefficients.data(), degree + 1});
}

RowVector work_of(const StepView &view, std::size_t contact) {
  const motion::StateLayout &layout = view.equations().layout();
  const Index place = view.equations().contacts().pairs()[contact].sliding_place;
  RowVector work(2);
  for (Index i = 0; const Index entry : {layout.friction_work(place), layout.wear_work(place)})
    work[i++] = view.end_state()[entry] - view.start_state()[entry];
  return work;
}

// Both powers, integrated from the start of the step.
std::array<Bernstein, 2> work_curves(const StepView &view, std::size_t contact) {
  const auto power = [&](auto part) {
    return integral(
        motion::local_curve(view, contact,
                            [&](const contact::LocalState &state) {
                              contact::LawResponse response;
                              view.equations().contacts().pairs()[contact].law->evaluate(
                                  view.equations().modes()[contact], state, response);
                              return part(response);
                            }),
        view.length());
  };
  return {power([](const contact::LawResponse &response) { return response.friction_power; }),
          power([](const contact::LawResponse &response) {
            return response.force * response.sliding_speed;
          })};
}

} // namespace

std::vector<double> SectorWork::angles() const {
  std::vector<double> middles;
  for (Index k = 0; k < sectors(); ++k)
    middles.push_back(2 * std::numbers::pi * static_cast<double>(k) /
                      static_cast<double>(sectors()));
  return middles;
}

SectorWork::Place SectorWork::place(const StepView &view) const {
  const contact::ContactPair &pair = view.equations().contacts().pairs()[contact_];
  Place place;
  for (int d = 0; d < 2; ++d) {
    Bernstein &curve = place.curves[static_cast<std::size_t>(d)];
    curve = view.displacement(*pair.along(d).projection);
    curve += pair.along(d).offset;
    curve *= -pair.circle->sense();
  }
  return place;
}

namespace {

double angle_at(const std::array<Bernstein, 2> &curves, double tau) {
  return std::atan2(curves[1](tau), curves[0](tau));
}

} // namespace

Index SectorWork::sector(const Place &place, double tau) const {
  return sector(angle_at(place.curves, tau));
}

Index SectorWork::sector(double angle) const {
  const double width = 2 * std::numbers::pi / static_cast<double>(sectors());
  const auto nearest = static_cast<Index>(std::floor(angle / width + 0.5));
  return (nearest + sectors()) % sectors();
}

// The sector lies between its borders.
bool SectorWork::within(const Place &place, Index sector) const {
  return place.beyond(border(sector, sectors())).lower_bound() >= 0 &&
         place.beyond(border(sector + 1, sectors())).upper_bound() <= 0;
}

// Of all borders, continued beyond the centre: where no sector ends both pieces belong to the same.
std::vector<double> SectorWork::crossings(const Place &place) const {
  std::vector<double> instants;
  for (Index k = 0; k < sectors(); ++k)
    add_sign_changes(place.beyond(border(k, sectors())), instants);
  std::sort(instants.begin(), instants.end());
  return instants;
}

// What the integrals of the state have grown by beside those of the curves, by the errors of these,
// is spread over the step.
void SectorWork::divide(const StepView &view, const Place &place, const RowVector &work) {
  const std::array<Bernstein, 2> curves = work_curves(view, contact_);
  std::vector<double> instants = crossings(place);
  instants.push_back(1);
  double from = 0;
  for (const double to : instants) {
    const Index into = sector(place, (from + to) / 2);
    for (Index i = 0; i < 2; ++i) {
      const Bernstein &curve = curves[static_cast<std::size_t>(i)];
      work_(into, i) += curve(to) - curve(from) + (to - from) * (work[i] - curve.end());
    }
    from = to;
  }
}

void SectorWork::add_impact(double energy, double wear, double angle) {
  work_.row(sector(angle)) += RowVector{{energy, wear}};
  last_angle_ = angle;
}

void SectorWork::add(const StepView &view) {
  const RowVector work = work_of(view, contact_);
  if (work.isZero(0))
    return;
  const Place place = this->place(view);
  last_angle_ = angle_at(place.curves, 1);
  const Index middle = sector(place, 0.5);
  if (within(place, middle))
    work_.row(middle) += work;
  else
    divide(view, place, work);
}

} // namespace vibroimpact::analyses
