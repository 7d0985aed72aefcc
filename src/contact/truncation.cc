#include "contact/truncation.h"

#include "contact/local_flexibility.h"
#include "reduction/known_flexibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace vibroimpact::contact {

using model::Model;
using model::PointReference;
using reduction::ReducedBody;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Displacement per force at the frequency Omega of what a side lacks [m/N].
double lacking_receptance(const Remainder &lacking, double frequency) {
  if (lacking.inverse_mass <= 0)
    return 0;
  const double ratio = std::pow(frequency / lacking.frequency, 2);
  const double fast = lacking.inverse_mass / (frequency * frequency);
  const double attached = std::min(lacking.attached * std::pow(frequency, 4), fast * ratio * ratio);
  const double slow =
      std::isnan(lacking.flexibility) ? fast * ratio : lacking.flexibility * (1 + ratio) + attached;
  return 1 / (1 / slow + 1 / fast);
}

double spring_error(double stiffness, double kept_mass, const std::vector<Remainder> &remainders) {
  const double frequency = std::sqrt(stiffness / kept_mass);
  double receptance = 0;
  for (const Remainder &lacking : remainders)
    receptance += lacking_receptance(lacking, frequency);
  return std::sqrt(1 + stiffness * receptance) - 1;
}

struct BodySide {
  PointReference point;
  RowVector row; ///< of the displacement along the normal
};

std::vector<BodySide> sides_of(const ContactPair &pair, const Model &model) {
  std::vector<BodySide> sides;
  for (const std::string &name : {pair.side_a, pair.side_b}) {
    PointReference point;
    if (!model.find_point(name, point))
      continue;
    const ReducedBody &body = *model.bodies()[point.body];
    sides.push_back({point, pair.normal.transpose() * body.points[point.point].rows.topRows(3)});
  }
  if (sides.empty())
    throw std::logic_error("contact " + pair.name + " has no point " + pair.side_a);
  return sides;
}

/// Highest frequency of the coordinates that move a side; not of those with a node there, which
/// leave but rounding.
double highest_frequency(const ReducedBody &body, const RowVector &row) {
  constexpr double rounding = 1e-6;
  const double least = rounding * row.cwiseAbs().maxCoeff();
  const Vector omega = body.omega();
  double highest = 0;
  for (Index j = 0; j < body.size(); ++j)
    if (std::abs(row[j]) > least)
      highest = std::max(highest, omega[j]);
  return highest;
}

/// Sum over the attachment modes, those that nothing bounds the frequency of.
double attached_part(const ReducedBody &body, const RowVector &row) {
  const Vector &bounds = body.eigen_residual;
  const Vector omega = body.omega();
  double sum = 0;
  for (Index j = 0; j < bounds.size(); ++j)
    if (std::isnan(bounds[j]))
      sum += row[j] * row[j] / std::pow(omega[j], 6);
  return sum;
}

double kept_inverse_mass(const ReducedBody &body, const RowVector &row) {
  return row.cwiseAbs2() * body.mass.cwiseInverse();
}

double lacking_flexibility(const PointReference &point, const Vector3 &normal, const Model &model) {
  const ReducedBody &body = *model.bodies()[point.body];
  if (std::isnan(reduction::flexibility_along(body.points[point.point], normal)))
    return unknown;
  const auto flexibility = local_flexibility(point, std::nullopt, normal, model);
  // Of the share that attachment modes answer, round-off leaves less than this.
  constexpr double answered = 1e-8;
  return flexibility && flexibility->share() < 1 - answered ? flexibility->whole - flexibility->kept
                                                            : 0;
}

double whole_inverse_mass(const BodySide &side, const Vector3 &normal, const Model &model) {
  const Matrix &inverse = model.bodies()[side.point.body]->points[side.point.point].inverse_mass;
  return inverse.size() == 0 ? unknown : normal.dot(inverse * normal);
}

Remainder remainder_of(const BodySide &side, const Vector3 &normal, const Model &model) {
  const ReducedBody &body = *model.bodies()[side.point.body];
  return {.inverse_mass = std::max(0.0, whole_inverse_mass(side, normal, model) -
                                            kept_inverse_mass(body, side.row)),
          .flexibility = lacking_flexibility(side.point, normal, model),
          .frequency = highest_frequency(body, side.row),
          .attached = attached_part(body, side.row)};
}

// Two points of one body: an impulse at one moves the other through the kept coordinates, but
// hardly through the mesh, where M^-1 falls off within a few elements.
Remainder remainder_of_both(const BodySide &a, const BodySide &b, const Vector3 &normal,
                            const Model &model) {
  const ReducedBody &body = *model.bodies()[a.point.body];
  const double whole = whole_inverse_mass(a, normal, model) + whole_inverse_mass(b, normal, model);
  return {.inverse_mass = std::max(0.0, whole - kept_inverse_mass(body, b.row - a.row)),
          .flexibility = lacking_flexibility(a.point, normal, model) +
                         lacking_flexibility(b.point, normal, model),
          .frequency = highest_frequency(body, b.row - a.row),
          .attached = attached_part(body, b.row - a.row)};
}

/// None where a meshed side has no mass at the contact.
std::optional<std::vector<Remainder>> remainders_of(const ContactPair &pair, const Model &model) {
  std::vector<BodySide> sides = sides_of(pair, model);
  sides.erase(std::remove_if(sides.begin(), sides.end(),
                             [&](const BodySide &side) {
                               return !reduction::has_modes(*model.bodies()[side.point.body]);
                             }),
              sides.end());
  for (const BodySide &side : sides)
    if (std::isnan(whole_inverse_mass(side, pair.normal, model)))
      return std::nullopt;
  if (sides.size() == 2 && sides[0].point.body == sides[1].point.body)
    return {{remainder_of_both(sides[0], sides[1], pair.normal, model)}};
  std::vector<Remainder> remainders;
  for (const BodySide &side : sides)
    remainders.push_back(remainder_of(side, pair.normal, model));
  return remainders;
}

std::string why_no_remainders(const ContactPair &pair, const Model &model) {
  for (const auto &side : sides_of(pair, model))
    if (model.bodies()[side.point.body]->type == "modes" &&
        std::isnan(whole_inverse_mass(side, pair.normal, model)))
      return "the given modes do not say what mass the body has there";
  return "the mass matrix is singular there; compare with twice as many modes";
}

double longest_of_shortest_periods(const std::vector<Remainder> &remainders) {
  constexpr double two_pi = 6.283185307179586476925;
  double period = 0;
  for (const Remainder &lacking : remainders)
    period = std::max(period, two_pi / lacking.frequency);
  return period;
}

ContactFigures figures_of(const ContactPair &pair, double kept_mass, const Model &model) {
  const auto flexibility = local_flexibility(pair, model);
  const auto remainders = remainders_of(pair, model);
  return {.name = pair.name,
          .clearance = pair.clearance,
          .flexibility_share = flexibility ? flexibility->share() : unknown,
          .least_share = pair.least_flexibility_share,
          .impact_error = remainders ? impact_error(*pair.law, kept_mass, *remainders) : unknown,
          .no_impact_error = remainders ? "" : why_no_remainders(pair, model),
          .largest_error = pair.largest_impact_error,
          .shortest_period = remainders ? longest_of_shortest_periods(*remainders) : unknown};
}

/// "a (13.4 %), b (8 %) and 3 more": the contacts that `bad` gives a share of.
template <class Bad> std::string list(const std::vector<ContactFigures> &contacts, Bad bad) {
  constexpr std::size_t most_named = 8;
  std::ostringstream named;
  std::size_t count = 0;
  for (const ContactFigures &contact : contacts)
    if (const std::optional<double> per_cent = bad(contact); per_cent && ++count <= most_named)
      named << (count > 1 ? ", " : "") << contact.name << " (" << *per_cent << " %)";
  if (count > most_named)
    named << " and " << count - most_named << " more";
  return named.str();
}

} // namespace

double impact_error(const ContactLaw &law, double kept_mass,
                    const std::vector<Remainder> &remainders) {
  const std::optional<ElasticForce> elastic = law.elastic_force();
  if (!elastic && !law.rigid())
    return unknown;
  if (elastic && elastic->exponent == 1)
    return spring_error(elastic->stiffness, kept_mass, remainders);
  double lacking = 0;
  for (const Remainder &remainder : remainders)
    lacking += remainder.inverse_mass;
  const double power = elastic ? elastic->exponent / (elastic->exponent + 1) : 1;
  return std::pow(1 + kept_mass * lacking, power) - 1;
}

std::vector<ContactFigures> contact_figures(const ContactSet &contacts, const Model &model) {
  std::vector<ContactFigures> figures;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    figures.push_back(figures_of(contacts.pairs()[c], contacts.effective_mass(c, model), model));
  return figures;
}

std::string flexibility_warning(const std::vector<ContactFigures> &contacts) {
  const std::string named =
      list(contacts, [](const ContactFigures &contact) -> std::optional<double> {
        // Rounded down, so that no share looks as if it were enough.
        if (contact.flexibility_share < contact.least_share)
          return std::floor(1000 * contact.flexibility_share) / 10;
        return std::nullopt;
      });
  return named.empty() ? ""
                       : "the kept modes carry less of the static flexibility than Least "
                         "flexibility share asks for at the contacts " +
                             named +
                             "; quasi-static forces there come out too large. Keep more modes, or "
                             "name the points or interfaces in Attachments";
}

std::string impact_warning(const std::vector<ContactFigures> &contacts) {
  const std::string named =
      list(contacts, [](const ContactFigures &contact) -> std::optional<double> {
        // Rounded up, to three digits.
        if (!(contact.impact_error > contact.largest_error))
          return std::nullopt;
        const double unit = std::pow(10.0, std::floor(std::log10(contact.impact_error)) - 2);
        return 100 * unit * std::ceil(contact.impact_error / unit);
      });
  return named.empty()
             ? ""
             : "the modes that are left out make the peak forces of short impacts (of rigid "
               "contacts: the impulses) too large, by more than Largest impact error, at the "
               "contacts " +
                   named +
                   ". Keep more modes. At points of a mesh without a lumped mass this is measured "
                   "against the mesh, and the error is smaller where contacts last longer than "
                   "the shortest period kept";
}

} // namespace vibroimpact::contact
