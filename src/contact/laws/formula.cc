#include "contact/laws/formula.h"

#include "contact/laws/read_formula.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Formula";
constexpr double rounding = 1e-9; // of the largest force

AffineForm affine(const LinearForm &form) {
  return {.constant = form.constant, .gap = -form.by_penetration, .gap_rate = -form.by_rate};
}

// Open, contact, where the force is cut off separating, and a mode that objects.
constexpr int contact_mode = 1;

std::vector<Mode> make_modes(const FormulaShape &shape, double largest_penetration,
                             Tension tension) {
  std::optional<AffineLaw> force;
  if (shape.linear)
    force = AffineLaw{.force = affine(*shape.linear)};
  if (tension == Tension::cut_off && !shape.factor)
    throw std::invalid_argument("must be refuse or pull for this Force: a force can be cut off "
                                "where the rate v stands in one factor that is linear in x and v");
  std::vector<Mode> modes = tension == Tension::cut_off
                                ? open_contact_separating(affine(*shape.factor), force)
                                : open_and_contact(force);
  const int faulty = static_cast<int>(modes.size());
  if (tension == Tension::refused && shape.factor)
    modes[contact_mode].guards.push_back({.indicator = affine(*shape.factor), .target = faulty});
  modes[contact_mode].guards.push_back(
      {.indicator = {.constant = largest_penetration, .gap = 1}, .target = faulty});
  modes.push_back({.name = "faulty", .in_contact = true, .guards = modes[contact_mode].guards});
  modes.back().guards.resize(1); // the overlap ends
  return modes;
}

std::string in_words(double value, const char *unit) {
  std::ostringstream text;
  text << value << " " << unit;
  return text.str();
}

} // namespace

FormulaLaw::FormulaLaw(parameters::Formula formula, double largest_penetration, Tension tension)
    : FormulaLaw(formula, shape_of(formula), largest_penetration, tension) {}

FormulaLaw::FormulaLaw(parameters::Formula formula, const FormulaShape &shape,
                       double largest_penetration, Tension tension)
    : ContactLaw(make_modes(shape, largest_penetration, tension), {}), formula_(std::move(formula)),
      shape_(shape), largest_penetration_(largest_penetration), tension_(tension),
      energy_([at_rest = formula_](double u) { return at_rest(u, 0).value; }, largest_penetration) {
}

bool FormulaLaw::acts(int mode) const {
  return mode == contact_mode || mode + 1 == static_cast<int>(modes().size());
}

double FormulaLaw::stored(double penetration) const {
  if (shape_.linear)
    return (shape_.linear->constant + 0.5 * shape_.linear->by_penetration * penetration) *
           penetration;
  if (!shape_.elastic)
    return energy_(penetration);
  const double power = shape_.elastic->exponent + 1;
  return shape_.elastic->stiffness * std::pow(penetration, power) / power;
}

void FormulaLaw::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double penetration = -state.gap;
  response.force = response.force_by_gap = response.force_by_gap_rate = 0;
  response.stored_energy = response.dissipated_power = 0;
  // A linear form holds at trial states behind the release too, as in all affine modes.
  if (!acts(mode) || !(penetration > 0 || shape_.linear))
    return;
  const parameters::Dual force = formula_(penetration, -state.gap_rate);
  response.force = force.value;
  response.force_by_gap = -force.by[0];
  response.force_by_gap_rate = -force.by[1];
  response.stored_energy = stored(penetration);
  // A difference of forces would leave rounding where there is no damping.
  response.dissipated_power = shape_.linear
                                  ? shape_.linear->by_rate * state.gap_rate * state.gap_rate
                                  : (formula_(penetration, 0).value - force.value) * state.gap_rate;
}

// In the mode that objects it is one of the two guards that has led there.
std::string FormulaLaw::objection(int mode, const LocalState &state) const {
  if (!acts(mode))
    return "";
  const std::string where = "at a penetration of " + in_words(-state.gap, "m") + " and a rate of " +
                            in_words(-state.gap_rate, "m/s");
  LawResponse response;
  evaluate(mode, state, response);
  const bool faulty = mode != contact_mode;
  if (-state.gap > (faulty ? 1 - rounding : 1) * largest_penetration_)
    return "is asked for beyond its Largest penetration, " + where + ",";
  if (!std::isfinite(response.force))
    return "is no finite number " + where;
  if (faulty || (tension_ == Tension::refused && response.force < -rounding * energy_.largest()))
    return "pulls " + where;
  return "";
}

std::optional<ForcePulse> FormulaLaw::force_pulse(int mode) const {
  // A contact that is solved as a whole is not asked for objections.
  const bool unguarded = tension_ == Tension::refused && shape_.sees_rate && !shape_.factor;
  if (mode != contact_mode || shape_.linear || !shape_.edge || unguarded)
    return std::nullopt;
  const ForcePulse::End at_zero{.guard = 0, .edge = *shape_.edge};
  ForcePulse pulse{.begin = *shape_.edge};
  // While the sides part the factor is below zero before the penetration is zero, unless a constant
  // holds it up.
  if (tension_ != Tension::cut_off || shape_.factor->constant != 0)
    pulse.ends.push_back(at_zero);
  if (tension_ == Tension::cut_off)
    pulse.ends.push_back({.guard = 1});
  return pulse;
}

// A thousand places, and as many again that halve towards the touch.
std::string FormulaLaw::fault_at_rest() const {
  constexpr int places = 1000;
  for (int k = 2 * places; k > 0; --k) {
    const double part = k > places ? static_cast<double>(k - places) / places
                                   : std::exp2((k - places) * 0.04) / places;
    const double penetration = part * largest_penetration_;
    const double force = formula_(penetration, 0).value;
    if (!std::isfinite(force))
      return "is no finite number at a penetration of " + in_words(penetration, "m");
    if (tension_ != Tension::pulls && force < -rounding * energy_.largest())
      return "pulls at a penetration of " + in_words(penetration, "m");
  }
  return "";
}

bool FormulaLaw::jumps() const {
  for (const double rate : {0.0, 1e-3, -1e-3, 1.0, -1.0, 10.0, -10.0})
    if (const double force = formula_(0, rate).value;
        !std::isfinite(force) || std::abs(force) > rounding * energy_.largest())
      return true;
  return false;
}

void FormulaLaw::declare(parameters::Section &contact) {
  using namespace parameters;
  contact
      .subsection(section_name,
                  "Force as an expression of the penetration x and its rate v. The energy stored "
                  "is the integral of the force at v = 0, the rest of the force dissipates.")
      .text("Force", "",
            "Expression of x and v, such as k*x^1.5*(1 + d*v), with variables of the file. Either "
            "all of its numbers have units, or none has: then x is in m, v in m/s and the force in "
            "N.")
      .required()
      .quantity("Largest penetration", "", dimension::length, range::positive, "x_max",
                "Up to there the formula is checked and holds; a motion that goes farther has "
                "failed.")
      .required()
      .choice("Tension", "refuse", {"refuse", "cut off", "pull"},
              "Where the formula is negative: the motion has failed, there is no force, or the "
              "sides pull on each other. Cutting off needs v in one factor, linear in x and v.")
      .boolean("Jump at touch", "false",
               "Says that a force that is not zero where the sides touch is meant.");
}

std::shared_ptr<const ContactLaw> FormulaLaw::create(const parameters::Values &contact) {
  const parameters::Values values = contact.subsection(section_name);
  values.require("Force");
  values.require("Largest penetration");
  const double largest_penetration = values.quantity("Largest penetration");
  const std::string tension = values.choice("Tension");
  std::shared_ptr<const FormulaLaw> law;
  try {
    law = std::make_shared<FormulaLaw>(read_formula(values, "Force"), largest_penetration,
                                       tension == "pull"      ? Tension::pulls
                                       : tension == "cut off" ? Tension::cut_off
                                                              : Tension::refused);
  } catch (const std::invalid_argument &refused) {
    values.reject("Tension", refused.what());
  }
  if (const std::string fault = law->fault_at_rest(); !fault.empty())
    values.reject("Force", "must push where nothing moves, but " + fault + ".");
  if (law->jumps() && !values.boolean("Jump at touch"))
    values.reject("Force", "must be zero at x = 0 whatever the rate, for a force that jumps where "
                           "the sides touch needs Jump at touch = true");
  return law;
}

} // namespace vibroimpact::contact
