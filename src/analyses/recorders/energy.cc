#include "analyses/recorders/energy.h"

#include "analyses/recorders/step_quadrature.h"
#include "analyses/results/fields.h"

#include <algorithm>
#include <numeric>

namespace vibroimpact::analyses {

using model::Connection;
using motion::Bernstein;
using motion::StepView;
using motion::Trajectory;

namespace {

model::Projection without_base(model::Projection projection) {
  std::fill(projection.base_coefficients.begin(), projection.base_coefficients.end(), 0.0);
  return projection;
}

// Integral of the product of the rates of two displacements.
double product_of_rates(const Bernstein &a, const Bernstein &b, double length) {
  const Bernstein rate_a = a.derivative(), rate_b = b.derivative();
  double sum = 0;
  for (const QuadratureNode &node : step_nodes())
    sum += node.weight * rate_a(node.tau) * rate_b(node.tau);
  return sum / length;
}

double squared_rate(const Bernstein &displacement, double length) {
  return product_of_rates(displacement, displacement, length);
}

// Of both elongations, or of what the motion relative to the base makes of them.
double lost(const model::Bearing &bearing, const std::array<model::Projection, 2> &elongation,
            const StepView &view) {
  const std::array<Bernstein, 2> along = {view.displacement(elongation[0]),
                                          view.displacement(elongation[1])};
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      if (const double c = bearing.damping(static_cast<Index>(i), static_cast<Index>(j)); c != 0)
        sum += c * product_of_rates(along[i], along[j], view.length());
  return sum;
}

double dissipated_by(const model::Model &model, std::size_t b, const StepView &view) {
  const reduction::ReducedBody &body = *model.bodies()[b];
  if (body.damping.isZero(0))
    return 0;
  std::vector<Bernstein> rates;
  for (Index j = 0; j < body.size(); ++j)
    rates.push_back(view.coordinate(model.offset(b) + j).derivative());
  double sum = 0;
  Vector velocity(body.size());
  for (const QuadratureNode &node : step_nodes()) {
    for (Index j = 0; j < body.size(); ++j)
      velocity[j] = rates[static_cast<std::size_t>(j)](node.tau);
    sum += node.weight * velocity.dot(body.damping * velocity);
  }
  return sum / view.length();
}

double motor_work(const model::Rotor &rotor, const StepView &view) {
  if (!rotor.motor)
    return 0;
  const Bernstein torque = view.drive(rotor.motor->drive);
  const Bernstein speed = view.coordinate(rotor.angle).derivative();
  double work = 0;
  for (const QuadratureNode &node : step_nodes())
    work += node.weight * torque(node.tau) * speed(node.tau);
  return work;
}

double total(const std::vector<double> &parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

} // namespace

Energy::Energy(const System &system)
    : system_(system), by_body_(system.model.bodies().size(), 0),
      by_connection_(system.model.connections().size(), 0),
      by_bearing_(system.model.bearings().size(), 0),
      by_motor_(system.model.rotors().list().size(), 0),
      by_system_(system.model.modal_dashpots().empty() ? 0 : 1, 0) {
  for (const contact::ContactPair &pair : system.contacts.pairs())
    part_labels_.emplace_back("contact/" + pair.name + "/dissipated_energy",
                              "energy lost in the contact");
  for (const auto &body : system.model.bodies())
    part_labels_.emplace_back("body/" + body->name + "/dissipated_energy",
                              "energy lost by the damping of the body");
  for (const Connection &connection : system.model.connections())
    part_labels_.emplace_back("connection/" + connection.name + "/dissipated_energy",
                              "energy lost in the connection");
  for (const model::Bearing &bearing : system.model.bearings())
    part_labels_.emplace_back("bearing/" + bearing.name + "/dissipated_energy",
                              "energy lost in the bearing");
  for (const model::Rotor &rotor : system.model.rotors().list())
    part_labels_.emplace_back("rotor/" + rotor.name + "/motor_work", "work of the motor");
  if (!by_system_.empty())
    part_labels_.emplace_back("system_damping/dissipated_energy",
                              "energy lost by the system damping");
}

Energy::WorkLabels::WorkLabels(const std::string &path, const std::string &meaning)
    : whole(path, "J", meaning + " in the recorded window"),
      per_period(path + "_per_period", "J", meaning + ", mean of the forcing periods") {}

void Energy::declare(parameters::Section & /*analysis*/) {}

RecorderFactory Energy::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<Energy>(system); };
}

// What linear springs to a moving base hold beyond the energy of the motion relative to the base.
double Energy::energy_beyond(const Trajectory &trajectory) const {
  const ConstVectorView q(trajectory.state().data(), system_.model.size());
  const double time = trajectory.equations().source_time(trajectory.time());
  double energy = 0;
  for (const Connection &spring : system_.model.connections()) {
    const double whole = system_.model.value(spring.elongation, time, q);
    const double relative = spring.elongation.row.dot(q);
    energy += spring.stiffness * (whole * whole - relative * relative) / 2;
  }
  for (const model::Bearing &bearing : system_.model.bearings()) {
    const Eigen::Vector2d relative = bearing.rows() * q;
    const Eigen::Vector2d whole(system_.model.value(bearing.elongation[0], time, q),
                                system_.model.value(bearing.elongation[1], time, q));
    energy +=
        (whole.dot(bearing.stiffness * whole) - relative.dot(bearing.stiffness * relative)) / 2;
  }
  return energy;
}

double Energy::stored_energy(const Trajectory &trajectory) const {
  const ConstVectorView x(trajectory.state().data(), trajectory.state().size());
  return trajectory.equations().stored_energy(trajectory.time(), x) + energy_beyond(trajectory);
}

void Energy::begin(const Window &window, const Trajectory &trajectory) {
  window_ = window;
  for (std::vector<double> *works :
       {&by_body_, &by_connection_, &by_bearing_, &by_motor_, &by_system_})
    std::fill(works->begin(), works->end(), 0);
  first_state_ = trajectory.state();
  first_energy_ = stored_energy(trajectory);
  base_work_ = -energy_beyond(trajectory);
}

double Energy::lost_in_dashpot(double damping, const model::Projection &elongation,
                               const StepView &view) {
  if (damping == 0)
    return 0;
  const double whole = damping * squared_rate(view.displacement(elongation), view.length());
  base_work_ +=
      whole - damping * squared_rate(view.displacement(without_base(elongation)), view.length());
  return whole;
}

double Energy::lost_in_bearing(const model::Bearing &bearing, const StepView &view) {
  const double whole = lost(bearing, bearing.elongation, view);
  base_work_ +=
      whole - lost(bearing,
                   {without_base(bearing.elongation[0]), without_base(bearing.elongation[1])},
                   view);
  return whole;
}

void Energy::step(const StepView &view) {
  for (std::size_t b = 0; b < by_body_.size(); ++b)
    by_body_[b] += dissipated_by(system_.model, b, view);
  for (std::size_t c = 0; c < by_connection_.size(); ++c) {
    const Connection &connection = system_.model.connections()[c];
    by_connection_[c] += lost_in_dashpot(connection.damping, connection.elongation, view);
  }
  for (std::size_t k = 0; k < by_bearing_.size(); ++k)
    by_bearing_[k] += lost_in_bearing(system_.model.bearings()[k], view);
  for (const model::ModalDashpot &dashpot : system_.model.modal_dashpots())
    by_system_[0] += lost_in_dashpot(dashpot.damping, dashpot.coordinate, view);
  for (std::size_t r = 0; r < by_motor_.size(); ++r)
    by_motor_[r] += motor_work(system_.model.rotors().list()[r], view);
}

void Energy::end(const Trajectory &trajectory) {
  last_state_ = trajectory.state();
  last_energy_ = stored_energy(trajectory);
  base_work_ += energy_beyond(trajectory);
}

void Energy::add_work(const FieldWriter &result, const WorkLabels &labels, double work) const {
  result.number(labels.whole, work);
  if (window_.cycles > 0)
    result.number(labels.per_period, work / static_cast<double>(window_.cycles));
}

void Energy::add_fields(const FieldWriter &result) const {
  const motion::StateLayout layout{.n = system_.model.size(),
                                   .n_internal = system_.contacts.n_internal(),
                                   .n_drive = system_.model.n_drive(),
                                   .n_contacts = static_cast<Index>(system_.contacts.size()),
                                   .n_sliding = system_.contacts.n_sliding()};
  const Vector change = last_state_ - first_state_;
  const double input = change[layout.input_work()] + base_work_;
  const double damping =
      total(by_body_) + total(by_connection_) + total(by_bearing_) + total(by_system_);
  double contacts = 0;
  auto labels = part_labels_.begin();
  for (std::size_t c = 0; c < system_.contacts.size(); ++c) {
    const double work = change[layout.contact_work(static_cast<Index>(c))];
    contacts += work;
    add_work(result, *labels++, work);
  }
  for (const std::vector<double> *works :
       {&by_body_, &by_connection_, &by_bearing_, &by_motor_, &by_system_})
    for (const double work : *works)
      add_work(result, *labels++, work);
  static const WorkLabels input_work("energy/input_work",
                                     "work of loads, moving bases, motors and what turns shafts");
  static const WorkLabels damping_work(
      "energy/damping_work", "energy lost by bodies, connections, bearings and system damping");
  static const WorkLabels contact_work("energy/contact_work", "energy lost in contacts");
  static const Label stored_change("energy/stored_change", "J",
                                   "stored energy at the end less the start");
  static const Label residual("energy/residual", "J", "what the balance leaves over");
  add_work(result, input_work, input);
  add_work(result, damping_work, damping);
  add_work(result, contact_work, contacts);
  const double stored = last_energy_ - first_energy_;
  result.number(stored_change, stored);
  result.number(residual, stored - input + damping + contacts);
}

} // namespace vibroimpact::analyses
