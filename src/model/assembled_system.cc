#include "model/assembled_system.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::model {

namespace {

/// Orthonormal columns that the rows of `tied`, each of length 1, map to zero.
Matrix left_free(const Matrix &tied) {
  const Index n = tied.cols();
  if (tied.rows() == 0)
    return Matrix::Identity(n, n);
  const SingularValues values = singular_values(tied);
  constexpr double dependent = 1e-10; // of the largest
  const Index rank = (values.values.array() > dependent * values.values[0]).count();
  return values.right.rightCols(n - rank);
}

Matrix unit_rows(Matrix rows) {
  for (Index k = 0; k < rows.rows(); ++k)
    if (const double size = rows.row(k).norm(); size > 0)
      rows.row(k) /= size;
  return rows;
}

Matrix symmetric(const Matrix &a) { return (a + a.transpose()) / 2; }

Matrix projected_skew(const Matrix &skew, const Matrix &shapes) {
  const Matrix result = shapes.transpose() * skew * shapes;
  return (result - result.transpose()) / 2;
}

// Both parts by themselves, so that what is symmetric or skew stays so to the last digit.
Matrix projected(const Matrix &damping, const Matrix &shapes) {
  Matrix result = symmetric(shapes.transpose() * symmetric(damping) * shapes);
  const Matrix gyroscopic = damping - damping.transpose();
  if (gyroscopic.isZero(0))
    return result;
  return result + projected_skew(gyroscopic, shapes) / 2;
}

// Twice the strain energy, and what it would be if nothing in the sum cancelled: a motion without
// strain keeps some units of rounding of that.
double strain(const Matrix &stiffness, const Vector &shape) {
  constexpr double cancelled = 1e-12;
  const Vector size = shape.cwiseAbs();
  const double energy = shape.dot(stiffness * shape);
  return std::abs(energy) > cancelled * size.dot(stiffness.cwiseAbs() * size) ? energy : 0;
}

// Forces between modes are rounding if they are below this share of those of the modes themselves.
bool is_modal(const Matrix &damping) {
  constexpr double rounding = 1e-10;
  const Vector own = damping.diagonal().array().max(0.0).sqrt();
  Matrix between = damping;
  between.diagonal().setZero();
  return (between.array().abs() <= rounding * (own * own.transpose()).array()).all() ||
         between.cwiseAbs().maxCoeff() <= rounding * damping.cwiseAbs().maxCoeff();
}

struct Moved {
  std::string name;
  double size = 0;
};

// The point and axis of a body with the largest displacement; or else rotation.
std::string most_moved(const Model &model, std::size_t body, const Vector &motion) {
  for (const bool rotation : {false, true}) {
    Moved most;
    for (const reduction::BodyPoint &point : model.bodies()[body]->points)
      for (Index axis = 0; axis < 3; ++axis)
        if (const double size = std::abs(point.rows.row(axis + (rotation ? 3 : 0)).dot(motion));
            size > most.size)
          most = {model.bodies()[body]->name + "." + point.name +
                      (rotation ? " about " : " along ") + static_cast<char>('x' + axis),
                  size};
    if (most.size > 1e-9 * motion.norm())
      return most.name;
  }
  return "body " + model.bodies()[body]->name;
}

} // namespace

AssembledSystem::AssembledSystem(const Model &model, const Matrix &tied) : model_(model) {
  const Vector scale = model.mass().cwiseSqrt().cwiseInverse();
  const Matrix rows =
      tied.rows() > 0 ? unit_rows(tied * scale.asDiagonal()) : Matrix(0, model.size());
  basis_ = scale.asDiagonal() * left_free(rows);
  if (basis_.cols() == 0)
    throw NumericalError("nothing can move: the tied contacts hold all coordinates");
}

Matrix AssembledSystem::stiffness() const {
  return symmetric(basis_.transpose() * model_.stiffness().dense() * basis_);
}

Vector AssembledModes::damping_ratio() const {
  const Vector omega = angular_frequency();
  return (omega.array() > 0).select(damping.diagonal().array() / (2 * omega.array()), 0.0);
}

AssembledModes assembled_modes(const Model &model, const AssembledSystem &system) {
  const SymmetricEigen eigen = symmetric_eigen(system.stiffness());
  AssembledModes modes{.shapes = system.basis() * eigen.vectors,
                       .stiffness = eigen.values,
                       .damping = {},
                       .circulatory = {}};
  const Matrix stiffness = model.stiffness().dense();
  // The quotient of Rayleigh has digits that the eigenvalue, with an error of the largest, lacks.
  for (Index j = 0; j < modes.stiffness.size(); ++j)
    modes.stiffness[j] = strain(stiffness, modes.shapes.col(j));
  modes.rigid = (modes.stiffness.array() == 0).count();
  modes.damping = projected(model.damping().dense(), modes.shapes);
  if (model.circulatory().size() > 0)
    modes.circulatory = projected_skew(model.circulatory(), modes.shapes);
  modes.modal_damping = is_modal(modes.damping) && modes.circulatory.size() == 0;
  return modes;
}

// In the undamped modes p, so that rigid ones are exactly at rest, and of the state [S p, p'] with
// S their frequencies: an eigenvalue then errs by the rounding of the highest frequency, of [p, p']
// by that of its square.
DampedModes damped_modes(const AssembledModes &modes) {
  const Index n = modes.stiffness.size();
  const Vector size = modes.stiffness.cwiseAbs().cwiseSqrt();
  const Vector scale = (size.array() > 0).select(size, 1.0);
  Matrix state = Matrix::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).diagonal() = scale;
  if (modes.circulatory.size() > 0)
    state.bottomLeftCorner(n, n) = -modes.circulatory * scale.cwiseInverse().asDiagonal();
  state.bottomLeftCorner(n, n).diagonal() -= modes.stiffness.cwiseQuotient(scale);
  state.bottomRightCorner(n, n) = -modes.damping;
  const GeneralEigen eigen = general_eigen(state);
  if (!eigen.values.allFinite())
    throw NumericalError("the eigenvalues of the damped system do not converge");
  std::vector<Index> order;
  for (Index k = 0; k < 2 * n; ++k)
    if (eigen.values[k].imag() >= 0)
      order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::abs(eigen.values[a]) < std::abs(eigen.values[b]);
  });
  const auto count = static_cast<Index>(order.size());
  DampedModes damped{.eigenvalues = ComplexVector(count),
                     .shapes = ComplexMatrix(modes.shapes.rows(), count)};
  const ComplexMatrix shapes =
      (modes.shapes * scale.cwiseInverse().asDiagonal()).cast<std::complex<double>>();
  for (Index j = 0; j < count; ++j) {
    const Index of = order[static_cast<std::size_t>(j)];
    damped.eigenvalues[j] = eigen.values[of];
    const ComplexVector shape = shapes * eigen.vectors.col(of).head(n);
    Index largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    damped.shapes.col(j) = shape / shape[largest];
  }
  return damped;
}

std::string moved_points(const Model &model, const Vector &shape) {
  constexpr double least_share = 0.01;
  const double energy = shape.dot(model.mass().cwiseProduct(shape));
  std::vector<std::string> names;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const Index first = model.offset(b), size = model.bodies()[b]->size();
    const Vector motion = shape.segment(first, size);
    if (motion.dot(model.mass().segment(first, size).cwiseProduct(motion)) >= least_share * energy)
      names.push_back(most_moved(model, b, motion));
  }
  return parameters::join(names, " and ");
}

std::string unheld_motions(const Model &model) {
  if (model.size() == 0)
    return "";
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  std::vector<std::string> motions;
  for (Index j = 0; j < modes.rigid; ++j)
    motions.push_back(moved_points(model, modes.shapes.col(j)));
  return motions.empty() ? ""
                         : "; no spring holds the whole system against the motion of " +
                               parameters::join(motions, ", nor of ");
}

} // namespace vibroimpact::model
