#include "motion/episode/contact_outputs.h"

#include "common/zero.h"
#include "motion/episode/contact_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

using Coefficients = std::array<double, ContactEpisode::most_terms>;

// Of sum c_k s^k, differentiated `order` times, or integrated once where that is -1.
double polynomial(const double *coefficients, int terms, int order, double s) {
  double sum = 0;
  if (order < 0) {
    for (int k = terms; k-- > 0;)
      sum = coefficients[k] / (k + 1) + s * sum;
    return s * sum;
  }
  for (int k = terms; k-- > order;) {
    double factor = 1;
    for (int i = 0; i < order; ++i)
      factor *= k - i;
    sum = factor * coefficients[k] + s * sum;
  }
  return sum;
}

} // namespace

ContactOutputs::ContactOutputs(const LinearOutputs &forms, const PhaseEpisode &contact,
                               double tolerance)
    : forms_(forms), contact_(contact), inner_points_(ContactSteps::inner_points(tolerance)) {}

// It goes like t^(n - 1) beside a force that goes like t^n; one that is cut off ends in the midst.
bool ContactOutputs::possible(const PhaseEpisode &contact) {
  const ForceShape &shape = contact.solution().tools().family.shape();
  return contact.n_directions() == 1 && shape.begin >= 1 && (shape.end >= 1 || shape.end == 0);
}

std::size_t ContactOutputs::bytes() const {
  std::size_t sum = bytes_of(times_, integrals_);
  for (const Output &output : outputs_)
    sum += bytes_of(output.form.rows());
  return sum;
}

void ContactOutputs::renew() {
  known_ = false;
  if (version_ == contact_.version())
    return;
  version_ = contact_.version();
  penetration_.emplace(Output{.form = contact_.output()});
  outputs_.clear();
  for (std::size_t form = 0; form < forms_.ranges.size(); ++form)
    outputs_.push_back(output(form));
}

// The force acts on the form at once where it sees the velocity of one of the two sides.
ContactOutputs::Output ContactOutputs::output(std::size_t form) const {
  const Vector row = contact_.in_amplitudes(forms_.rows.row(static_cast<Index>(form)));
  Output made{.form = {contact_.flow(), row, forms_.constants[form], 1},
              .range = forms_.ranges[form]};
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  const double size = row.cwiseAbs().dot(contact_.flow().load().cwiseAbs());
  made.integrated = std::abs(made.form.responses()[0]) > rounding * size ? 1 : 0;
  made.differentiated = forms_.differentiated[form] ? 1 : 0;
  return made;
}

void ContactOutputs::include() {
  renew();
  for (Output &output : outputs_) {
    output.form.require(contact_.solution().terms());
    include(output);
  }
  for (const LinearOutputs::Force &force : forms_.forces)
    if (force.contact == contact_.contact()) {
      require_integrals();
      include_force(*force.range);
    }
}

// By the coefficients of the free motion and the integrals of the force at the end.
bool ContactOutputs::stays_inside(const Output &output, const double *free) const {
  const ConstVectorView forces(contact_.solution().forces(), contact_.solution().nodes());
  if (output.order() == 2 || forces.minCoeff() < 0)
    return false;
  const double fastest = contact_.flow().fastest();
  const double theta = fastest * contact_.duration();
  const double scale = output.differentiated ? fastest : 1;
  double low = scale * polynomial(free, contact_.solution().terms(), output.differentiated, 0);
  double high = low;
  const auto add = [&](double change) { (change < 0 ? low : high) += scale * change; };
  double power = 1;
  for (int k = output.differentiated + 1; k < contact_.solution().terms(); ++k) {
    power *= theta;
    add(free[k] * (output.differentiated ? k : 1) * power);
  }
  const int first = 1 - output.order();
  power = first == 0 ? contact_.duration() : contact_.duration() * theta;
  for (int k = first; k + output.differentiated < contact_.solution().terms(); ++k, power *= theta)
    add(output.form.responses()[k + output.differentiated] * power *
        contact_.end_moments()[static_cast<std::size_t>(k)]);
  return low >= output.range->minimum && high <= output.range->maximum;
}

// J_k = theta^(k + 1) I_k f at the instants at which the contact is shown.
void ContactOutputs::require_integrals() {
  if (known_)
    return;
  known_ = true;
  const ContactEpisode &solved = contact_.solution();
  ShownPoints &shown = solved.tools().shown(inner_points_);
  const double theta = contact_.flow().fastest() * contact_.duration();
  const Index count = shown.rule.nodes.size();
  const int terms = solved.terms();
  shown.between.require(terms);
  times_ = theta * shown.rule.nodes.cast<double>();
  integrals_.setZero(count, terms + 2);
  const ConstVectorView forces(solved.forces(), solved.nodes());
  double power = theta;
  for (int k = 0; k < terms; ++k, power *= theta) {
    integrals_.col(k + 2).segment(1, count - 2).noalias() =
        power * (shown.between.term(k) * forces);
    integrals_(count - 1, k + 2) = power * contact_.end_moments()[static_cast<std::size_t>(k)];
  }
  set_forces();
}

// The force and its rate by the law, of penetrations that are as exact as the nodes are. At both
// ends the sides just touch.
void ContactOutputs::set_forces() {
  const double fastest = contact_.flow().fastest();
  double *const free = free_penetration_.data();
  penetration_->form.free_motion(contact_.before().data(), contact_.solution().terms(), free);
  free[0] = 0;
  ForceValues law;
  Motions at;
  for (Index i = 0; i < times_.size(); ++i) {
    at.places[0][0] =
        std::max(derivative(*penetration_, free, 0, i), std::numeric_limits<double>::min());
    at.rates[0][0] = fastest * derivative(*penetration_, free, 1, i);
    contact_.force().evaluate(1, at, law);
    integrals_(i, 1) = law.force[0][0];
    const double acceleration = fastest * fastest * derivative(*penetration_, free, 2, i);
    integrals_(i, 0) =
        (law.by_place[0][0][0] * at.rates[0][0] + law.by_rate[0][0][0] * acceleration) / fastest;
  }
}

// Of R by s.
double ContactOutputs::derivative(const Output &output, const double *free, int order,
                                  Index instant) const {
  const int terms = contact_.solution().terms();
  const int shift = output.integrated - order;
  double forced = 0;
  for (int k = 1 - output.integrated; k < terms && k + shift < terms; ++k)
    forced += output.form.responses()[k] * integrals_(instant, 2 + k + shift);
  return polynomial(free, terms, -shift, times_[instant]) + forced / contact_.flow().fastest();
}

ContactOutputs::Jet ContactOutputs::jet(const Output &output, const double *free,
                                        Index instant) const {
  Jet made;
  for (int order = 0; order < 4; ++order)
    made[static_cast<std::size_t>(order)] = derivative(output, free, order, instant);
  return made;
}

void ContactOutputs::include(const Output &output) {
  Coefficients free{};
  output.form.free_motion(contact_.before().data(), contact_.solution().terms(), free.data());
  if (stays_inside(output, free.data()))
    return;
  require_integrals();
  const double scale = output.differentiated ? contact_.flow().fastest() : 1;
  values_.resize(times_.size());
  for (Index i = 0; i < values_.size(); ++i)
    values_[i] = scale * derivative(output, free.data(), output.order(), i);
  output.range->include(values_.minCoeff());
  output.range->include(values_.maxCoeff());
  // An extreme value lies beyond both ends of its interval by less than values differ thereabouts.
  const auto difference = [&](Index i) {
    return i < 0 || i + 1 >= values_.size() ? 0 : std::abs(values_[i + 1] - values_[i]);
  };
  for (Index i = 0; i + 1 < values_.size(); ++i) {
    const double reach = difference(i - 1) + difference(i) + difference(i + 1);
    const auto [low, high] = std::minmax(values_[i], values_[i + 1]);
    if (high + reach > output.range->maximum || low - reach < output.range->minimum)
      include_between(output, free.data(), i);
  }
}

void ContactOutputs::include_between(const Output &output, const double *free, Index instant) {
  const bool outer = instant == 0 || instant + 2 == times_.size();
  if (output.order() == 2 && outer) {
    include_beside_force(output, free, instant);
    return;
  }
  Bernstein polynomial = Bernstein::hermite(length(instant), jet(output, free, instant),
                                            jet(output, free, instant + 1));
  for (int i = 0; i < output.order(); ++i) {
    polynomial = polynomial.derivative();
    polynomial *= 1 / length(instant);
  }
  if (output.differentiated)
    polynomial *= contact_.flow().fastest();
  output.range->include(polynomial);
}

// The acceleration of what touches goes with the force, like t^n next to both ends, which no
// polynomial does: the law there, and a cubic for the rest.
void ContactOutputs::include_beside_force(const Output &output, const double *free,
                                          Index instant) const {
  const double by_force = output.form.responses()[0];
  const double fastest = contact_.flow().fastest();
  const auto rest = [&](Index i) {
    return std::array<double, 2>{
        fastest * derivative(output, free, 2, i) - by_force * integrals_(i, 1),
        fastest * derivative(output, free, 3, i) - by_force * integrals_(i, 0)};
  };
  if (const auto value = stationary(
          instant, Bernstein::cubic(length(instant), rest(instant), rest(instant + 1)), by_force))
    output.range->include(*value);
}

// Beside the largest of the forces at the instants, on the side to which it rises.
void ContactOutputs::include_force(ValueRange &range) const {
  Index largest = 0;
  range.include(integrals_.col(1).maxCoeff(&largest));
  range.include(integrals_.col(1).minCoeff());
  const Index from = integrals_(largest, 0) > 0 ? largest : largest - 1;
  if (from < 0 || from + 1 >= times_.size())
    return;
  if (const auto value = stationary(from, Bernstein(0), 1))
    range.include(*value);
}

// rest + by_force f where its rate is zero between two instants. None: the rate keeps its sign.
std::optional<double> ContactOutputs::stationary(Index instant, const Bernstein &rest,
                                                 double by_force) const {
  const double *free = free_penetration_.data();
  const double h = length(instant);
  const double fastest = contact_.flow().fastest();
  const Bernstein penetration = Bernstein::hermite(h, jet(*penetration_, free, instant),
                                                   jet(*penetration_, free, instant + 1));
  const Bernstein rate = penetration.derivative();
  const Bernstein acceleration = rate.derivative();
  const Bernstein slope_of_rest = rest.derivative();
  ForceValues law;
  const auto evaluate = [&](double tau) {
    Motions at;
    at.places[0][0] = std::max(penetration(tau), std::numeric_limits<double>::min());
    at.rates[0][0] = fastest / h * rate(tau);
    contact_.force().evaluate(1, at, law);
  };
  const auto slope = [&](double tau) {
    evaluate(tau);
    return slope_of_rest(tau) + by_force * (law.by_place[0][0][0] * rate(tau) +
                                            law.by_rate[0][0][0] * fastest / h * acceleration(tau));
  };
  if (!(slope(0) * slope(1) < 0))
    return std::nullopt;
  constexpr int bits = 26; // half of the digits of the place give all of the value
  const double tau = zero_between(slope, 0, 1, bits);
  evaluate(tau);
  return rest(tau) + by_force * law.force[0][0];
}

} // namespace vibroimpact::motion
