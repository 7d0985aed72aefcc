#include "reduction/residual_modes.h"

#include "common/log.h"
#include "parameters/text.h"
#include "reduction/known_flexibility.h"
#include "structure/beam_definition.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::reduction {

namespace {

using structure::DefinitionError;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// Of the flexibility: less than this is what rounding leaves where nothing is lacking.
constexpr double rounding = 1e-9;

std::string axis_name(int axis) { return {static_cast<char>('x' + axis)}; }

/// 3 x 3, of the coordinates at a point; rigid motions do not count.
Matrix point_flexibility(const ReducedBody &body, const BodyPoint &point) {
  Matrix kept = Matrix::Zero(3, 3);
  for (Index j = 0; j < body.size(); ++j)
    if (body.stiffness[j] > 0)
      kept += point.rows.col(j).head(3) * point.rows.col(j).head(3).transpose() / body.stiffness[j];
  return kept;
}

/// Of a static test: what it does not tell is NaN.
Matrix measured_flexibility(const ModalPoint &measured, const Matrix &kept) {
  Matrix flexibility = kept;
  for (int axis = 0; axis < 3; ++axis) {
    const double stiffness = (*measured.static_stiffness)[axis];
    if (stiffness == 0) {
      flexibility.row(axis).setConstant(unknown);
      flexibility.col(axis).setConstant(unknown);
      continue;
    }
    if (kept(axis, axis) * stiffness > 1 + rounding)
      throw DefinitionError("Point", measured.name, "Static stiffness",
                            "must not be greater along " + axis_name(axis) + " than " +
                                parameters::number_text(1 / kept(axis, axis)) +
                                " N/m, the static stiffness of the given modes");
    flexibility(axis, axis) = 1 / stiffness;
  }
  return flexibility;
}

BodyPoint &find_point(ReducedBody &body, const std::string &name) {
  for (BodyPoint &point : body.points)
    if (point.name == name)
      return point;
  throw std::logic_error("body " + body.name + " has no point " + name);
}

/// R at a point, along the axes that are asked for; 0 along the others.
Matrix lacking_flexibility(const ReducedBody &body, const BodyPoint &point,
                           const std::array<bool, 3> &axes) {
  Matrix lacking = Matrix::Zero(3, 3);
  const Matrix kept = point_flexibility(body, point);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (axes[i] && axes[j])
        lacking(i, j) = point.flexibility(i, j) - kept(i, j);
  return (lacking + lacking.transpose()) / 2;
}

void append(double stiffness, double damping, Index point, const Vector3 &row, ReducedBody &body) {
  const Index n = body.size();
  body.mass.conservativeResize(n + 1);
  body.mass[n] = 1;
  body.stiffness.conservativeResize(n + 1);
  body.stiffness[n] = stiffness;
  body.damping.conservativeResizeLike(Matrix::Zero(n + 1, n + 1));
  body.damping(n, n) = damping;
  // The modes left out hardly move with the base as a whole.
  const bool known = body.base_participation.allFinite();
  body.base_participation.conservativeResizeLike(Matrix::Constant(n + 1, 3, known ? 0 : unknown));
  if (body.eigen_residual.size() > 0)
    body.eigen_residual.conservativeResizeLike(Vector::Constant(n + 1, unknown));
  for (BodyPoint &other : body.points)
    other.rows.conservativeResizeLike(Matrix::Zero(6, n + 1));
  BodyPoint &moved = body.points[static_cast<std::size_t>(point)];
  moved.rows.col(n).head(3) = row;
  Matrix &shapes = body.recovery.shapes;
  if (shapes.rows() == 0)
    return;
  shapes.conservativeResizeLike(Matrix::Zero(shapes.rows(), n + 1));
  if (moved.node >= 0)
    shapes.col(n).segment(Index{6} * moved.node, 3) = row;
}

double residual_frequency(const ModalDefinition &definition, const ReducedBody &body) {
  const double highest = body.omega().maxCoeff();
  const double frequency = definition.residual_frequency.value_or(std::numbers::sqrt3 * highest);
  if (!(frequency > highest))
    throw DefinitionError("Modal data", "", "Residual frequency",
                          "must be greater than the highest frequency of the modes, " +
                              parameters::number_text(definition.dimensionless
                                                          ? highest
                                                          : highest / (2 * std::numbers::pi)) +
                              (definition.dimensionless ? "" : " Hz"));
  return frequency;
}

std::array<bool, 3> attached_axes(const ModalDefinition &definition, const BodyPoint &point) {
  std::array<bool, 3> axes{};
  for (const Attachment &attachment : definition.attachments)
    if (attachment.point == point.name || attachment.point == point.interface)
      axes[static_cast<std::size_t>(attachment.axis)] = true;
  return axes;
}

void require_known(const BodyPoint &point, const std::array<bool, 3> &axes) {
  for (int axis = 0; axis < 3; ++axis)
    if (axes[static_cast<std::size_t>(axis)] &&
        std::isnan(flexibility_along(point, Vector3::Unit(axis))))
      throw DefinitionError("Modal data", "", "Attachments",
                            "must name places whose static flexibility is known, by the file or by "
                            "Static stiffness or Residual flexibility of their Point; that of " +
                                point.name + "." + axis_name(axis) + " is not");
}

/// A residual that is a difference of two measured values has the errors of both.
void warn_of_small_differences(const ModalDefinition &definition, const ReducedBody &body,
                               const BodyPoint &point, const std::array<bool, 3> &axes) {
  constexpr double small = 0.05;
  for (const ModalPoint &measured : definition.points)
    for (int axis = 0; axis < 3; ++axis) {
      if (measured.name != point.name || !measured.static_stiffness ||
          !axes[static_cast<std::size_t>(axis)])
        continue;
      const double lacking = 1 - body.flexibility_share(point, Vector3::Unit(axis));
      if (lacking < small)
        log::warning("body " + body.name + ": of the static flexibility at " + point.name + "." +
                     axis_name(axis) + " the modes lack " + parameters::number_text(100 * lacking) +
                     " %, which is no more than the errors of measured modes; a Residual "
                     "flexibility that was found by itself is better than Static stiffness");
    }
}

} // namespace

void set_flexibility(const ModalDefinition &definition, ReducedBody &body) {
  for (const ModalPoint &measured : definition.points) {
    if (!measured.static_stiffness && !measured.residual_flexibility)
      continue;
    BodyPoint &point = find_point(body, measured.name);
    const Matrix kept = point_flexibility(body, point);
    if (measured.residual_flexibility)
      point.flexibility = kept + Matrix(measured.residual_flexibility->asDiagonal());
    else if ((body.stiffness.array() == 0).any())
      throw DefinitionError("Point", measured.name, "Static stiffness",
                            "must not be set when the body has rigid modes (frequency 0)");
    else
      point.flexibility = measured_flexibility(measured, kept);
  }
}

void add_residual_modes(const ModalDefinition &definition, ReducedBody &body) {
  if (definition.attachments.empty())
    return;
  const double frequency = residual_frequency(definition, body);
  const double ratio =
      definition.residual_damping_ratio.value_or(body.damping_ratio()[body.size() - 1]);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const BodyPoint &point = body.points[p];
    const std::array<bool, 3> axes = attached_axes(definition, point);
    if (!axes[0] && !axes[1] && !axes[2])
      continue;
    require_known(point, axes);
    warn_of_small_differences(definition, body, point, axes);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> lacking(
        lacking_flexibility(body, point, axes));
    const double most = point_flexibility(body, point).trace();
    if (lacking.eigenvalues()[0] < -1e-6 * most)
      throw DefinitionError("Modal data", "", "Attachments",
                            "must not name " + point.name +
                                ", whose static flexibility in the file is less than that of the "
                                "modes");
    for (int i = 0; i < 3; ++i)
      if (const double lambda = lacking.eigenvalues()[i]; lambda > rounding * most)
        append(frequency * frequency, 2 * ratio * frequency, static_cast<Index>(p),
               std::sqrt(lambda) * frequency * lacking.eigenvectors().col(i), body);
  }
}

} // namespace vibroimpact::reduction
