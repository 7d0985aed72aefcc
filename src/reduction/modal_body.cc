#include "reduction/modal_body.h"

#include "parameters/text.h"
#include "reduction/body_file.h"
#include "reduction/named_file.h"
#include "reduction/residual_modes.h"
#include "structure/beam_definition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::reduction {

namespace {

using structure::DefinitionError;
using Normalisation = ModalDefinition::Normalisation;

[[noreturn]] void reject(const std::string &key, const std::string &problem) {
  throw DefinitionError("Modal data", "", key, problem);
}

std::string of_mode(Index j) { return " of mode " + std::to_string(j + 1); }

/// InputError names the first mode with a number that is none of a structure.
void check_numbers(const ModalData &data) {
  for (Index j = 0; j < data.size(); ++j) {
    const auto require = [&](bool good, const std::string &what, double value) {
      if (!good)
        reject("File", what + ", but that" + of_mode(j) + " is " + parameters::number_text(value));
    };
    require(data.frequency[j] >= 0, "must hold frequencies that are at least 0", data.frequency[j]);
    if (data.damping_ratio.size() > 0)
      require(data.damping_ratio[j] >= 0, "must hold damping ratios that are at least 0",
              data.damping_ratio[j]);
    if (data.mass.size() > 0)
      require(data.mass[j] > 0, "must hold modal masses greater than 0", data.mass[j]);
  }
  for (const BodyPoint &point : data.points)
    if (!point.rows.allFinite())
      reject("File", "must hold finite mode shapes, but not all at point " + point.name + " are");
}

void keep_first(Index number, ModalData &data) {
  if (number > data.size())
    reject("Number",
           "must not exceed the number of modes in the file, " + std::to_string(data.size()));
  if (number == 0)
    return;
  data.frequency.conservativeResize(number);
  for (Vector *values : {&data.damping_ratio, &data.mass, &data.stiffness, &data.eigen_residual})
    if (values->size() > 0)
      values->conservativeResize(number);
  if (data.damping.size() > 0)
    data.damping.conservativeResize(number, number);
  if (data.base_participation.size() > 0)
    data.base_participation.conservativeResize(number, Eigen::NoChange);
  for (BodyPoint &point : data.points)
    point.rows.conservativeResize(Eigen::NoChange, number);
  if (data.recovery.shapes.size() > 0)
    data.recovery.shapes.conservativeResize(Eigen::NoChange, number);
}

/// Of what a mode moves by one unit: the displacements at points and nodes.
double largest_component(const ModalData &data, Index mode) {
  double largest = 0;
  for (const BodyPoint &point : data.points)
    largest = std::max(largest, point.rows.col(mode).head(3).cwiseAbs().maxCoeff());
  for (Index node = 0; node < data.recovery.nodes.cols(); ++node)
    largest = std::max(largest,
                       data.recovery.shapes.col(mode).segment(6 * node, 3).cwiseAbs().maxCoeff());
  return largest;
}

// Files hold rounded numbers.
constexpr double mass_rounding = 1e-6;
constexpr double component_rounding = 1e-3;

Vector checked_masses(const ModalDefinition &definition, const ModalData &data) {
  const bool given = data.mass.size() > 0;
  if (definition.normalisation == Normalisation::unit_mass) {
    for (Index j = 0; given && j < data.size(); ++j)
      if (std::abs(data.mass[j] - 1) > mass_rounding)
        reject("Normalisation", "must not be unit modal mass when the file gives other modal "
                                "masses; that" +
                                    of_mode(j) + " is " + parameters::number_text(data.mass[j]) +
                                    " kg");
    return Vector::Ones(data.size());
  }
  if (!given)
    reject("Normalisation", "must be unit modal mass when the file gives no modal masses");
  for (Index j = 0; definition.normalisation == Normalisation::largest_component && j < data.size();
       ++j)
    if (const double largest = largest_component(data, j);
        std::abs(largest - 1) > component_rounding)
      reject("Normalisation", "must not be unit largest component when the largest displacement" +
                                  of_mode(j) + " is " + parameters::number_text(largest));
  return data.mass;
}

/// omega^2. Frequencies that went through a file in Hz have lost their last digits.
Vector squared_frequencies(const ModalData &data) {
  if (data.stiffness.size() == 0)
    return data.frequency.cwiseAbs2();
  const Vector squared = data.stiffness.cwiseQuotient(data.mass);
  constexpr double same = 1e-9;
  for (Index j = 0; j < data.size(); ++j)
    if (!(std::abs(squared[j] - std::pow(data.frequency[j], 2)) <= same * squared[j]))
      reject("File", "must hold stiffnesses that are the modal masses times the squared angular "
                     "frequencies, but that" +
                         of_mode(j) + " is " + parameters::number_text(data.stiffness[j]) + " N/m");
  return squared;
}

Vector damping_ratios(const ModalDefinition &definition, const ModalData &data) {
  if (data.damping_ratio.size() > 0 && !definition.damping_ratios.empty())
    reject("Damping ratio", "must not be set when the file gives damping ratios");
  if (data.damping_ratio.size() > 0)
    return data.damping_ratio;
  if (definition.damping_ratios.empty())
    reject("Damping ratio", "must be set when the file gives no damping ratios");
  Vector ratios(data.size());
  for (Index j = 0; j < ratios.size(); ++j)
    ratios[j] = definition.damping_ratios[std::min<std::size_t>(
        static_cast<std::size_t>(j), definition.damping_ratios.size() - 1)];
  return ratios;
}

void place_points(const ModalDefinition &definition, ReducedBody &body) {
  std::vector<std::string> names;
  for (const BodyPoint &point : body.points)
    names.push_back(point.name);
  for (const ModalPoint &given : definition.points) {
    const auto at = std::find(names.begin(), names.end(), given.name);
    if (at == names.end())
      throw DefinitionError(
          "Point", given.name, "",
          "must be one of the points in the file: " + parameters::join(names, ", ") +
              parameters::suggestion(given.name, names));
    if (given.position)
      body.points[static_cast<std::size_t>(at - names.begin())].position = *given.position;
  }
}

int point_number(const ReducedBody &body, const std::string &name) {
  std::vector<std::string> names;
  for (const BodyPoint &point : body.points)
    names.push_back(point.name);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end())
    reject("Lines", "must run between points of the file: " + parameters::join(names, ", ") +
                        parameters::suggestion(name, names));
  return static_cast<int>(at - names.begin());
}

/// The points as nodes, and the lines between them.
void draw_lines(const ModalDefinition &definition, ReducedBody &body) {
  if (definition.lines.empty())
    return;
  if (!body.recovery.empty())
    reject("Lines", "must not be set when the file holds a mesh");
  Recovery &recovery = body.recovery;
  for (const auto &[a, b] : definition.lines) {
    recovery.lines.push_back({point_number(body, a), point_number(body, b)});
    const auto &[first, second] = recovery.lines.back();
    if (body.points[first].position == body.points[second].position)
      reject("Lines", "must run between points at different places, but " + a + " and " + b +
                          " have the same Position");
  }
  recovery.nodes.resize(3, static_cast<Index>(body.points.size()));
  recovery.shapes.resize(6 * recovery.nodes.cols(), body.size());
  for (Index p = 0; p < recovery.nodes.cols(); ++p) {
    BodyPoint &point = body.points[static_cast<std::size_t>(p)];
    point.node = static_cast<int>(p);
    recovery.nodes.col(p) = point.position;
    recovery.shapes.middleRows(6 * p, 6) = point.rows;
  }
}

void check_attachments(const ModalDefinition &definition, const ReducedBody &body) {
  for (const Attachment &attachment : definition.attachments)
    if (std::none_of(body.points.begin(), body.points.end(), [&](const BodyPoint &point) {
          return point.name == attachment.point || point.interface == attachment.point;
        }))
      reject("Attachments",
             "must name points of the file as POINT.x, POINT.y or POINT.z; it has no "
             "point " +
                 attachment.point);
}

} // namespace

ReducedBody modal_body(const std::string &name, const ModalDefinition &definition, ModalData data) {
  check_numbers(data);
  keep_first(definition.number, data);
  const Vector scale = checked_masses(definition, data).cwiseSqrt().cwiseInverse();
  ReducedBody body;
  body.name = name;
  body.type = "modes";
  body.mass = Vector::Ones(data.size());
  body.stiffness = squared_frequencies(data);
  if (data.damping.size() > 0)
    body.damping = scale.asDiagonal() * data.damping * scale.asDiagonal();
  else
    body.damping =
        Vector(2 * damping_ratios(definition, data).cwiseProduct(data.frequency)).asDiagonal();
  if (data.base_participation.size() > 0)
    body.base_participation = scale.asDiagonal() * data.base_participation;
  else
    body.base_participation =
        Matrix::Constant(data.size(), 3, std::numeric_limits<double>::quiet_NaN());
  body.total_mass = data.total_mass;
  body.eigen_residual = data.eigen_residual;
  body.orthogonality_residual = data.orthogonality_residual;
  body.points = std::move(data.points);
  for (BodyPoint &point : body.points)
    point.rows *= scale.asDiagonal();
  body.recovery = std::move(data.recovery);
  body.recovery.shapes *= scale.asDiagonal();
  place_points(definition, body);
  check_attachments(definition, body);
  draw_lines(definition, body);
  set_flexibility(definition, body);
  add_residual_modes(definition, body);
  return body;
}

ReducedBody modal_body_from_file(const std::string &name, const ModalDefinition &definition) {
  if (is_hdf5(definition.file))
    return modal_body(name, definition, read_modal_hdf5(definition, name));
  return modal_body(name, definition,
                    read_modal_text(read_file(definition.file).value_or(""), definition));
}

} // namespace vibroimpact::reduction
