#include "analyses/bilinear/tied_system.h"

#include "common/error.h"
#include "parameters/text.h"

namespace vibroimpact::analyses {

namespace {

constexpr const char *approximation_subject = "A bilinear approximation";

bool constant(const model::TimeFunction &function) { return function.highest_frequency() == 0; }

void check_sources(const model::Model &model, std::size_t source) {
  const model::Source &driving = model.sources().at(source);
  if (!driving.function->harmonic())
    throw InputError(std::string(approximation_subject) + " must have a harmonic excitation, but " +
                     driving.name + " is none.");
  for (std::size_t s = 0; s < model.sources().size(); ++s)
    if (s != source && !constant(*model.sources()[s].function))
      throw InputError(std::string(approximation_subject) +
                       " must have only constant excitations beside " + driving.name + ", but " +
                       model.sources()[s].name +
                       " varies in time; the key Excitations of the analysis chooses among them.");
}

void check_contact(const System &system) {
  const auto &pairs = system.contacts.pairs();
  if (pairs.size() != 1) {
    std::vector<std::string> names;
    for (const contact::ContactPair &pair : pairs)
      names.push_back(pair.name);
    throw InputError(
        std::string(approximation_subject) + " must have exactly one contact, but there are " +
        std::to_string(pairs.size()) + (names.empty() ? "" : ": " + parameters::join(names, ", ")) +
        "; the key Active contacts of the analysis chooses among them.");
  }
  if (pairs[0].circle)
    throw InputError(std::string(approximation_subject) +
                     " must have a contact with Gap = plane; " + pairs[0].name +
                     " has a circular one.");
  if (!pairs[0].tangential.empty())
    throw InputError(std::string(approximation_subject) +
                     " must have a contact without friction; " + pairs[0].name + " has the law " +
                     pairs[0].law->name() + ".");
  if (!(pairs[0].gap.row.cwiseAbs().maxCoeff() > 0))
    throw InputError(std::string(approximation_subject) +
                     " must have a contact with a side that can move, but neither side of " +
                     pairs[0].name + " can.");
}

} // namespace

void TiedSystem::check(const System &system, std::size_t source) {
  if (!system.model.linear())
    throw InputError(std::string(approximation_subject) +
                     " must have a linear model, without cubic springs and rotors.");
  check_sources(system.model, source);
  check_contact(system);
}

TiedSystem::TiedSystem(const System &system, std::size_t source, double angular_frequency)
    : n_(system.model.size()), omega_(angular_frequency) {
  check(system, source);
  const model::Model &model = system.model;
  sources_ = Matrix::Zero(3 * static_cast<Index>(model.sources().size()), 3);
  for (std::size_t s = 0; s < model.sources().size(); ++s) {
    const auto row = 3 * static_cast<Index>(s);
    if (s != source) {
      sources_(row, 0) = model.sources()[s].function->value(0);
      continue;
    }
    const auto function = model.sources()[s].function->with_frequency(omega_);
    const double cosine = function->value(0), sine = function->rate(0) / omega_;
    sources_.row(row) << 0, sine, cosine;
    sources_.row(row + 1) << 0, -cosine, sine;
    sources_.row(row + 2) << 0, -sine, -cosine;
  }
  make_open(model);
  make_closed(model, system.contacts.pairs()[0]);
}

RowVector TiedSystem::form(const model::Projection &projection) const {
  RowVector form = RowVector::Zero(size());
  form.head(n_) = projection.row;
  for (std::size_t s = 0; s < projection.base_coefficients.size(); ++s)
    form.tail(3) += projection.base_coefficients[s] * sources_.row(3 * static_cast<Index>(s));
  return form;
}

void TiedSystem::make_open(const model::Model &model) {
  const double squared = omega_ * omega_;
  Matrix load = Matrix::Zero(n_, 3); // over omega^2
  for (std::size_t s = 0; s < model.sources().size(); ++s) {
    const model::Source &source = model.sources()[s];
    const auto row = 3 * static_cast<Index>(s);
    load += source.load * sources_.row(row) / squared +
            source.rate_load * sources_.row(row + 1) / omega_ +
            source.inertial_load * sources_.row(row + 2);
  }
  open_ = Matrix::Zero(size(), size());
  open_.block(0, n_, n_, n_).setIdentity();
  open_.block(n_, 0, n_, n_) = -model.stiffness().dense() / squared;
  open_.block(n_, n_, n_, n_) = -model.damping().dense() / omega_;
  open_.block(n_, 2 * n_, n_, 3) = load;
  for (Index k = 0; k < n_; ++k)
    open_.row(n_ + k) /= model.mass()[k];
  open_(2 * n_ + 1, 2 * n_ + 2) = 1;
  open_(2 * n_ + 2, 2 * n_ + 1) = -1;
}

void TiedSystem::make_closed(const model::Model &model, const contact::ContactPair &pair) {
  gap_ = form(pair.gap);
  gap_[2 * n_] += pair.clearance;
  gap_rate_ = gap_ * open_;
  const RowVector acceleration = gap_rate_ * open_;
  const Vector response = pair.gap.row.transpose().cwiseQuotient(model.mass()); // M^-1 w^T
  const double inverse_mass = pair.gap.row * response;
  force_ = -omega_ * omega_ / inverse_mass * acceleration;
  closed_ = open_;
  closed_.middleRows(n_, n_) -= response / inverse_mass * acceleration;
  closing_ = Matrix::Identity(size(), size());
  closing_.topRows(n_) -= response / inverse_mass * gap_;
  closing_.middleRows(n_, n_) -= response / inverse_mass * gap_rate_;
}

} // namespace vibroimpact::analyses
