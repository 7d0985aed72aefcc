#include "integration/flight_ledger.h"

#include "integration/quadratic_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact {

namespace {

// Local state of a contact as a vector: gap, its rate, internal states, the force that holds it.
LocalState local_state(const Vector &x, std::size_t n_internal) {
  return {.gap = x[0],
          .gap_rate = x[1],
          .internal = {x.data() + 2, n_internal},
          .normal_force = x[2 + static_cast<Index>(n_internal)]};
}

std::vector<LinearRow> local_rows(const Equations &equations, std::size_t contact,
                                  std::size_t n_internal) {
  std::vector<LinearRow> rows = {linear_row(equations, contact, {.gap = 1}),
                                 linear_row(equations, contact, {.gap_rate = 1})};
  for (std::size_t i = 0; i < n_internal; ++i) {
    AffineForm form{.internal = std::vector<double>(n_internal, 0.0)};
    form.internal[i] = 1;
    rows.push_back(linear_row(equations, contact, form));
  }
  rows.push_back(linear_row(equations, contact, {.normal_force = 1}));
  return rows;
}

LinearRow unit_row(Index size, Index place) {
  LinearRow form{.row = RowVector::Zero(size)};
  form.row[place] = 1;
  return form;
}

} // namespace

FlightLedger::FlightLedger(const Equations &equations, const ExponentialBasis &basis)
    : input_work_(equations.layout().input_work()),
      absolute_input_work_(equations.layout().absolute_input_work()) {
  list_exponents(basis);
  list_pairs();
  add_loads(equations, basis);
  add_damping(equations, basis);
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!equations.silent(c))
      add_contact(equations, basis, c);
  integrals_.resize(pairs_.size());
  start_.resize(exponents_.size());
  end_.resize(exponents_.size());
}

void FlightLedger::list_exponents(const ExponentialBasis &basis) {
  for (const ExponentialBasis::Group &group : basis.groups) {
    is_pair_.push_back(group.is_pair);
    exponents_.push_back(group.is_pair ? group.exponent : Complex(group.exponent.real()));
    if (group.is_pair)
      exponents_.push_back(std::conj(group.exponent));
  }
  exponents_.emplace_back(0);
}

// [rad/s]; the fastest decay where nothing vibrates.
double FlightLedger::slowest_vibration() const {
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const Complex exponent : exponents_) {
    fastest = std::max(fastest, std::abs(exponent));
    if (exponent.imag() > 0)
      slowest = std::min(slowest, exponent.imag());
  }
  return std::min(slowest, fastest);
}

void FlightLedger::list_pairs() {
  constexpr double slow = 1e-3; // times the longest stretch
  const double slowest = slowest_vibration();
  longest_ = slowest > 0 ? 2 * std::numbers::pi / slowest : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < exponents_.size(); ++i)
    for (std::size_t j = i; j < exponents_.size(); ++j) {
      const Complex sum = exponents_[i] + exponents_[j];
      const bool is_slow = !(std::abs(sum) * longest_ >= slow);
      pairs_.push_back({.first = i,
                        .second = j,
                        .sum = sum,
                        .inverse = is_slow ? Complex() : 1.0 / sum,
                        .is_slow = is_slow});
    }
}

// Coefficients of z. c Re(a) + d Im(a) = (c - i d) / 2 a + (c + i d) / 2 conj(a).
ComplexVector FlightLedger::seen(const LinearRow &form, const ExponentialBasis &basis) const {
  const RowVector columns = form.row * basis.columns;
  ComplexVector result(static_cast<Index>(exponents_.size()));
  Index place = 0;
  for (const ExponentialBasis::Group &group : basis.groups) {
    if (!group.is_pair) {
      result[place++] = columns[group.column];
      continue;
    }
    const Complex half = 0.5 * Complex(columns[group.column], -columns[group.column + 1]);
    result[place++] = half;
    result[place++] = std::conj(half);
  }
  result[place] = form.constant;
  return result;
}

FlightLedger::Entry &FlightLedger::entry(Index place) {
  for (Entry &known : entries_)
    if (known.place == place)
      return known;
  return entries_.emplace_back(
      Entry{.place = place, .coefficients = std::vector<Complex>(pairs_.size())});
}

void FlightLedger::add_product(double factor, const ComplexVector &a, const ComplexVector &b,
                               Index place) {
  Entry &to = entry(place);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto i = static_cast<Index>(pairs_[k].first);
    const auto j = static_cast<Index>(pairs_[k].second);
    to.coefficients[k] += factor * (i == j ? a[i] * b[i] : a[i] * b[j] + a[j] * b[i]);
  }
}

void FlightLedger::add_loads(const Equations &equations, const ExponentialBasis &basis) {
  const StateLayout &layout = equations.layout();
  const Index rows = basis.columns.rows();
  for (std::size_t k = 0; k < equations.model().sources().size(); ++k) {
    const Source &source = equations.model().sources()[k];
    Index row = layout.physical_size() + 3 * static_cast<Index>(k);
    for (const Vector *load : {&source.load, &source.rate_load, &source.inertial_load}) {
      LinearRow speed{.row = RowVector::Zero(rows)};
      speed.row.segment(layout.velocity(), layout.n) = load->transpose();
      if (!load->isZero(0))
        add_product(1, seen(speed, basis), seen(unit_row(rows, row), basis), input_work_);
      ++row;
    }
  }
}

void FlightLedger::add_damping(const Equations &equations, const ExponentialBasis &basis) {
  const StateLayout &layout = equations.layout();
  const LinearForm &damping = equations.model().damping();
  const Index rows = basis.columns.rows();
  for (Index j = 0; j < layout.n; ++j) {
    const Index entry = layout.velocity() + j;
    LinearRow force = unit_row(rows, entry);
    force.row[entry] = damping.diagonal[j];
    if (damping.coupling.size() > 0)
      force.row.segment(layout.velocity(), layout.n) += damping.coupling.row(j);
    if (!force.row.isZero(0))
      add_product(1, seen(unit_row(rows, entry), basis), seen(force, basis), layout.damping_work());
  }
}

void FlightLedger::add_contact(const Equations &equations, const ExponentialBasis &basis,
                               std::size_t contact) {
  add_dissipation(equations, basis, contact);
  const StateLayout &layout = equations.layout();
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const AffineForm &law = equations.mode(contact).affine->force;
  const ComplexVector force = seen(linear_row(equations, contact, law), basis);
  const LinearRow one{.row = RowVector::Zero(basis.columns.rows()), .constant = 1};
  add_product(1, force, seen(one, basis), layout.impulse(static_cast<Index>(contact)));
  LinearRow carried{.row = RowVector::Zero(basis.columns.rows())};
  for (std::size_t k = 0; k < pair.gap.carrier.size(); ++k)
    carried.row[layout.physical_size() + 3 * static_cast<Index>(k) + 1] = pair.gap.carrier[k];
  if (!carried.row.isZero(0))
    add_product(-1, force, seen(carried, basis), input_work_);
}

void FlightLedger::add_dissipation(const Equations &equations, const ExponentialBasis &basis,
                                   std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const int mode = equations.modes()[contact];
  const auto n_internal = static_cast<std::size_t>(pair.n_internal());
  std::vector<LinearRow> rows = local_rows(equations, contact, n_internal);
  LawResponse response;
  const std::optional<Matrix> dissipated = quadratic_form(
      [&](const Vector &x) {
        pair.law->evaluate(mode, local_state(x, n_internal), response);
        return response.dissipated_power;
      },
      static_cast<Index>(rows.size()));
  if (!dissipated) {
    known_ = false;
    return;
  }
  rows.push_back({.row = RowVector::Zero(basis.columns.rows()), .constant = 1});
  const Index work = equations.layout().contact_work(static_cast<Index>(contact));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = dissipated->row(static_cast<Index>(i));
    LinearRow force{.row = RowVector::Zero(basis.columns.rows())};
    for (std::size_t j = 0; j < rows.size(); ++j) {
      force.row += row[static_cast<Index>(j)] * rows[j].row;
      force.constant += row[static_cast<Index>(j)] * rows[j].constant;
    }
    if (!row.isZero(0))
      add_product(1, seen(rows[i], basis), seen(force, basis), work);
  }
}

void FlightLedger::exponentials(const Amplitudes &amplitudes, std::vector<Complex> &z) const {
  std::size_t place = 0;
  for (std::size_t j = 0; j < is_pair_.size(); ++j) {
    const Complex amplitude(amplitudes.real[j], is_pair_[j] ? amplitudes.imaginary[j] : 0.0);
    z[place++] = amplitude;
    if (is_pair_[j])
      z[place++] = std::conj(amplitude);
  }
  z[place] = 1;
}

void FlightLedger::add(const Amplitudes &start, const Amplitudes &end, double h, Vector &state) {
  exponentials(start, start_);
  exponentials(end, end_);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Pair &pair = pairs_[k];
    const Complex before = start_[pair.first] * start_[pair.second];
    const Complex after = end_[pair.first] * end_[pair.second];
    const Complex change = after - before;
    integrals_[k] = pair.is_slow ? 0.5 * h * (before + after) - h * h / 12 * pair.sum * change
                                 : change * pair.inverse;
  }
  for (const Entry &entry : entries_) {
    double integral = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      integral += entry.coefficients[k].real() * integrals_[k].real() -
                  entry.coefficients[k].imag() * integrals_[k].imag();
    state[entry.place] += integral;
    if (entry.place == input_work_)
      state[absolute_input_work_] += std::abs(integral);
  }
}

} // namespace vibroimpact
