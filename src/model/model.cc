#include "model/model.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace vibroimpact::model {

using reduction::ReducedBody;

void LinearForm::apply_to_many(ConstVectorView x, Vector &y) const {
  y.noalias() = diagonal.cwiseProduct(x);
  if (coupling.size() > 0)
    y.noalias() += coupling * x;
}

void LinearForm::add(double factor, const RowVector &row) {
  const RowVector scaled = factor * row;
  add(Matrix(row.transpose() * scaled));
}

void LinearForm::add(const Matrix &matrix) {
  diagonal += matrix.diagonal();
  Matrix off_diagonal = matrix;
  off_diagonal.diagonal().setZero();
  if (off_diagonal.isZero(0))
    return;
  if (coupling.size() == 0)
    coupling = off_diagonal;
  else
    coupling += off_diagonal;
}

Matrix LinearForm::dense() const {
  Matrix matrix = diagonal.asDiagonal();
  if (coupling.size() > 0)
    matrix += coupling;
  return matrix;
}

namespace {

LinearForm split_diagonal(const Matrix &matrix) {
  LinearForm form{.diagonal = matrix.diagonal(), .coupling = matrix};
  form.coupling.diagonal().setZero();
  if (form.coupling.size() == 0 || form.coupling.cwiseAbs().maxCoeff() == 0)
    form.coupling.resize(0, 0);
  return form;
}

} // namespace

Model::Model(std::vector<std::shared_ptr<const ReducedBody>> bodies) : bodies_(std::move(bodies)) {
  Index n = 0;
  for (const auto &body : bodies_) {
    offsets_.push_back(n);
    n += body->size();
  }
  mass_.resize(n);
  stiffness_.diagonal.resize(n);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const ReducedBody &body = *bodies_[b];
    mass_.segment(offsets_[b], body.size()) = body.mass;
    stiffness_.diagonal.segment(offsets_[b], body.size()) = body.stiffness;
  }
  add_body_damping();
}

void Model::add_body_damping() {
  Matrix damping = Matrix::Zero(size(), size());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    damping.block(offsets_[b], offsets_[b], bodies_[b]->size(), bodies_[b]->size()) =
        bodies_[b]->damping;
  damping_ = split_diagonal(damping);
}

void Model::change_damping(double share, double self_excitation) {
  for (std::size_t k = 0; k < spins_.size(); ++k)
    if (spins_[k].speed.constant())
      add_circulatory((share - 1) * spins_[k].speed.at(0) * circulation(k));
  for (RunUp &run_up : run_ups_)
    run_up.circulatory *= share;
  for (auto &body : bodies_) {
    ReducedBody changed = *body;
    changed.damping *= share;
    changed.spin.circulatory *= share;
    changed.damping.diagonal() -= self_excitation * changed.mass;
    body = std::make_shared<const ReducedBody>(std::move(changed));
  }
  add_body_damping();
  for (std::size_t k = 0; k < spins_.size(); ++k) // gyroscopic forces are no losses
    if (spins_[k].speed.constant())
      damping_.add(spins_[k].speed.at(0) * gyroscopic(k));
  for (Bearing &bearing : bearings_) {
    bearing.damping *= share;
    damping_.add(bearing.rows().transpose() * bearing.damping * bearing.rows());
  }
  for (Connection &connection : connections_) {
    connection.damping *= share;
    damping_.add(connection.damping, connection.elongation.row);
  }
  for (ModalDashpot &dashpot : modal_dashpots_) {
    dashpot.damping *= share;
    damping_.add(dashpot.damping, dashpot.coordinate.row);
  }
  for (Source &source : sources_)
    source.rate_load *= share;
  list_drives();
}

void Model::add_base_motion(const std::string &name, std::shared_ptr<const TimeFunction> function,
                            const std::vector<std::size_t> &bodies, const Vector3 &direction) {
  Source source{.name = name,
                .function = std::move(function),
                .load = Vector::Zero(size()),
                .rate_load = Vector::Zero(size()),
                .inertial_load = Vector::Zero(size())};
  std::vector<Vector3> carried(bodies_.size(), Vector3::Zero());
  for (const std::size_t b : bodies) {
    source.inertial_load.segment(offsets_[b], bodies_[b]->size()) =
        -bodies_[b]->base_participation * direction;
    carried[b] = direction;
  }
  sources_.push_back(std::move(source));
  carried_.push_back(std::move(carried));
  field_.emplace_back(bodies_.size(), Vector3::Zero());
  list_drives();
}

void Model::add_gravity(const std::string &name, std::shared_ptr<const TimeFunction> function,
                        const std::vector<std::size_t> &bodies, const Vector3 &direction) {
  Source source{.name = name,
                .function = std::move(function),
                .load = Vector::Zero(size()),
                .rate_load = Vector::Zero(size()),
                .inertial_load = Vector::Zero(size())};
  std::vector<Vector3> field(bodies_.size(), Vector3::Zero());
  for (const std::size_t b : bodies) {
    source.load.segment(offsets_[b], bodies_[b]->size()) =
        bodies_[b]->base_participation * direction;
    field[b] = direction;
  }
  sources_.push_back(std::move(source));
  carried_.emplace_back(bodies_.size(), Vector3::Zero());
  field_.push_back(std::move(field));
  list_drives();
}

void Model::add_force(const std::string &name, std::shared_ptr<const TimeFunction> function,
                      const PointReference &at, const MotionAxis &axis) {
  add_load(name, std::move(function), displacement(at, axis, false).row.transpose());
}

void Model::add_load(const std::string &name, std::shared_ptr<const TimeFunction> function,
                     const Vector &load) {
  sources_.push_back({.name = name,
                      .function = std::move(function),
                      .load = load,
                      .rate_load = Vector::Zero(size()),
                      .inertial_load = Vector::Zero(size())});
  carried_.emplace_back(bodies_.size(), Vector3::Zero());
  field_.emplace_back(bodies_.size(), Vector3::Zero());
  list_drives();
}

void Model::add_connection(Connection connection) {
  const RowVector &row = connection.elongation.row;
  stiffness_.add(connection.stiffness, row);
  for (std::size_t k = 0; k < sources_.size(); ++k)
    sources_[k].load -=
        connection.stiffness * connection.elongation.base_coefficients[k] * row.transpose();
  add_dashpot(connection.damping, connection.elongation);
  list_drives();
  if (connection.cubic_stiffness != 0)
    cubic_.push_back(connections_.size());
  connections_.push_back(std::move(connection));
}

void Model::add_rotor(Rotor rotor, const PointReference &at, const Vector3 &first,
                      const Vector3 &second) {
  rotor.at = point_name(at);
  rotor.first = displacement(at, first, true);
  rotor.second = displacement(at, second, true);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    rotor.field_first.push_back(field_[k][at.body].dot(first));
    rotor.field_second.push_back(field_[k][at.body].dot(second));
  }
  rotors_.add(std::move(rotor));
}

void Model::rotor_frame(double time, Vector &frame) const {
  frame.setZero(2 * static_cast<Index>(rotors_.list().size()));
  for (std::size_t i = 0; i < rotors_.list().size(); ++i) {
    const Rotor &rotor = rotors_.list()[i];
    const auto first = 2 * static_cast<Index>(i);
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      const TimeFunction &function = *sources_[k].function;
      if (rotor.first.base_coefficients[k] != 0 || rotor.second.base_coefficients[k] != 0) {
        const double acceleration = function.acceleration(time);
        frame[first] += rotor.first.base_coefficients[k] * acceleration;
        frame[first + 1] += rotor.second.base_coefficients[k] * acceleration;
      }
      if (rotor.field_first[k] != 0 || rotor.field_second[k] != 0) {
        const double field = function.value(time);
        frame[first] -= rotor.field_first[k] * field;
        frame[first + 1] -= rotor.field_second[k] * field;
      }
    }
  }
}

void Model::set_frequency(std::size_t source, double angular_frequency) {
  auto function = sources_.at(source).function->with_frequency(angular_frequency);
  if (!function)
    throw std::logic_error("source " + sources_[source].name + " has no frequency");
  sources_[source].function = std::move(function);
}

void Model::list_drives() {
  drives_.clear();
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const auto add = [&](Vector Source::*load, std::size_t derivative) {
      if (!(sources_[k].*load).isZero(0))
        drives_.push_back({.source = k, .load = load, .derivative = derivative});
    };
    add(&Source::load, 0);
    add(&Source::inertial_load, 2);
    add(&Source::rate_load, 1);
  }
}

void Model::load(double time, Vector &f) const {
  const auto source = [&](std::size_t k, std::size_t derivative) {
    const TimeFunction &function = *sources_[k].function;
    return derivative == 0   ? function.value(time)
           : derivative == 1 ? function.rate(time)
                             : function.acceleration(time);
  };
  load(source, f);
}

Vector Model::static_load() const {
  Vector f = Vector::Zero(size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    if (sources_[k].function->highest_frequency() > 0)
      continue;
    const double value = sources_[k].function->value(0);
    f += value * sources_[k].load;
    for (const Rotor &rotor : rotors_.list())
      f += value * rotor.mass *
           (rotor.field_first[k] * rotor.first.row + rotor.field_second[k] * rotor.second.row)
               .transpose();
  }
  return f;
}

double Model::value(const Projection &projection, double time, ConstVectorView q) const {
  double sum = projection.row.dot(q);
  for (std::size_t k = 0; k < projection.base_coefficients.size(); ++k)
    if (projection.base_coefficients[k] != 0)
      sum += projection.base_coefficients[k] * sources_[k].function->value(time);
  return sum;
}

double Model::rate(const Projection &projection, double time, ConstVectorView velocity) const {
  double sum = projection.row.dot(velocity);
  for (std::size_t k = 0; k < projection.base_coefficients.size(); ++k)
    if (projection.base_coefficients[k] != 0)
      sum += projection.base_coefficients[k] * sources_[k].function->rate(time);
  return sum;
}

double Model::add_cubic_forces(double time, ConstVectorView q, VectorView f) const {
  double base_power = 0;
  for (const std::size_t c : cubic_) {
    const Connection &spring = connections_[c];
    const double e = value(spring.elongation, time, q);
    const double tension = spring.cubic_stiffness * e * e * e;
    f -= tension * spring.elongation.row.transpose();
    for (std::size_t k = 0; k < sources_.size(); ++k)
      if (spring.elongation.base_coefficients[k] != 0)
        base_power +=
            tension * spring.elongation.base_coefficients[k] * sources_[k].function->rate(time);
  }
  return base_power;
}

void Model::add_cubic_stiffness(double time, ConstVectorView q, Matrix &stiffness) const {
  for (const std::size_t c : cubic_) {
    const RowVector &row = connections_[c].elongation.row;
    const double e = value(connections_[c].elongation, time, q);
    stiffness += (3 * connections_[c].cubic_stiffness * e * e) * row.transpose() * row;
  }
}

double Model::cubic_energy(double time, ConstVectorView q) const {
  double energy = 0;
  for (const std::size_t c : cubic_) {
    const double e = value(connections_[c].elongation, time, q);
    energy += connections_[c].cubic_stiffness * e * e * e * e / 4;
  }
  return energy;
}

std::size_t Model::find_body(const std::string &name) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                  [&](const auto &body) { return body->name == name; });
  return static_cast<std::size_t>(found - bodies_.begin());
}

std::size_t Model::find_source(const std::string &name) const {
  const auto found = std::find_if(sources_.begin(), sources_.end(),
                                  [&](const Source &source) { return source.name == name; });
  return static_cast<std::size_t>(found - sources_.begin());
}

bool Model::find_point(const std::string &name, PointReference &reference) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t p = 0; p < bodies_[b]->points.size(); ++p)
      if (name == bodies_[b]->name + "." + bodies_[b]->points[p].name) {
        reference = {.body = b, .point = p};
        return true;
      }
  return false;
}

std::string Model::point_name(const PointReference &reference) const {
  const ReducedBody &body = *bodies_.at(reference.body);
  return body.name + "." + body.points.at(reference.point).name;
}

std::vector<std::string> Model::point_names() const {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t p = 0; p < bodies_[b]->points.size(); ++p)
      names.push_back(point_name({.body = b, .point = p}));
  return names;
}

Projection Model::displacement(const PointReference &point, const MotionAxis &axis,
                               bool absolute) const {
  const ReducedBody &body = *bodies_.at(point.body);
  Projection projection{.row = RowVector::Zero(size()),
                        .base_coefficients = std::vector<double>(sources_.size(), 0)};
  projection.row.segment(offsets_[point.body], body.size()) =
      axis.direction.transpose() * body.points.at(point.point).rows.middleRows(axis.first_row(), 3);
  if (absolute && !axis.rotation)
    for (std::size_t k = 0; k < sources_.size(); ++k)
      projection.base_coefficients[k] = carried_[k][point.body].dot(axis.direction);
  return projection;
}

bool Model::moves_base(std::size_t source) const {
  return std::any_of(carried_[source].begin(), carried_[source].end(),
                     [](const Vector3 &direction) { return !direction.isZero(0); }) ||
         std::any_of(connections_.begin(), connections_.end(), [&](const Connection &connection) {
           return connection.elongation.base_coefficients[source] != 0;
         });
}

Vector3 Model::base_displacement(std::size_t body, double time) const {
  Vector3 displacement = Vector3::Zero();
  for (std::size_t k = 0; k < sources_.size(); ++k)
    if (!carried_[k][body].isZero(0))
      displacement += sources_[k].function->value(time) * carried_[k][body];
  return displacement;
}

Vector3 Model::base_velocity(std::size_t body, double time) const {
  Vector3 velocity = Vector3::Zero();
  for (std::size_t k = 0; k < sources_.size(); ++k)
    if (!carried_[k][body].isZero(0))
      velocity += sources_[k].function->rate(time) * carried_[k][body];
  return velocity;
}

double Model::highest_frequency() const {
  double highest = (stiffness_.diagonal.array() / mass_.array()).max(0.0).sqrt().maxCoeff();
  highest = std::max(highest, rotors_.highest_frequency());
  for (const Spin &spin : spins_)
    highest = std::max(highest, spin.speed.highest());
  for (const Source &source : sources_)
    highest = std::max(highest, source.function->highest_frequency());
  return highest;
}

double Model::next_break(double time) const {
  double next = std::numeric_limits<double>::infinity();
  for (const Source &source : sources_)
    next = std::min(next, source.function->next_break(time));
  for (const RunUp &run_up : run_ups_)
    next = std::min(next, run_up.speed.next_break(time));
  return next;
}

} // namespace vibroimpact::model
