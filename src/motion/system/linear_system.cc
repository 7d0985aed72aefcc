#include "motion/system/linear_system.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace vibroimpact::motion {

using contact::ContactPair;

namespace {

// Beyond this condition of the balanced and normalised eigenvectors more than five digits are lost.
constexpr double largest_condition = 1e5;
// Eigenvectors A v = e v whose residual is larger, relative to A, are not taken for eigenvectors.
constexpr double largest_residual = 1e-12;
// Nearer to an eigenvalue (relatively) the particular solution loses more than five digits.
constexpr double resonance_distance = 1e-5;
// Eigenvalues below this part of the largest are as good as zero for a constant input.
constexpr double slow = 1e-8;
constexpr double rounding = 1e-13;

// Powers of two d with D^-1 A D of rows and columns of similar size (Osborne 1960).
Vector balance(const Matrix &matrix) {
  const Index n = matrix.rows();
  Vector scale = Vector::Ones(n);
  for (int sweep = 0; sweep < 20; ++sweep)
    for (Index i = 0; i < n; ++i) {
      double row = 0;
      double column = 0;
      for (Index j = 0; j < n; ++j)
        if (j != i) {
          row += std::abs(matrix(i, j)) * scale[j] / scale[i];
          column += std::abs(matrix(j, i)) * scale[i] / scale[j];
        }
      if (row > 0 && column > 0)
        scale[i] *= std::exp2(std::round(0.5 * std::log2(row / column)));
    }
  return scale;
}

double condition(const Eigen::MatrixXcd &vectors) {
  const Eigen::MatrixXcd normalised = vectors.colwise().normalized();
  const Eigen::JacobiSVD<Eigen::MatrixXcd, Eigen::NoQRPreconditioner> svd(normalised);
  const auto &values = svd.singularValues();
  const double smallest = values[values.size() - 1];
  return smallest > 0 ? values[0] / smallest : std::numeric_limits<double>::infinity();
}

// Of a defective pair the solver may return two vectors that are none (Eigen does so when the two
// eigenvalues come out equal to the last digit).
double residual(const Matrix &matrix, const ComplexVector &eigenvalues,
                const Eigen::MatrixXcd &vectors) {
  const Eigen::MatrixXcd normalised = vectors.colwise().normalized();
  return (matrix * normalised - normalised * eigenvalues.asDiagonal()).colwise().norm().maxCoeff();
}

const std::optional<contact::AffineLaw> &affine_law(const Equations &equations,
                                                    std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  return pair.law->modes()[static_cast<std::size_t>(equations.modes()[contact])].affine;
}

} // namespace

bool LinearSystem::holds(const Equations &equations) {
  if (!equations.model().linear())
    return false;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!affine_law(equations, c))
      return false;
  return true;
}

LinearSystem::LinearSystem(const Equations &equations) {
  if (!holds(equations))
    throw std::logic_error("this phase of the motion is not linear");
  assemble(equations);
  decompose();
}

LinearSystem::ConstraintForces LinearSystem::constraint_forces(const Equations &equations) {
  LinearSystem system;
  system.assemble(equations);
  return system.constraint_forces_;
}

void LinearSystem::assemble(const Equations &equations) {
  const model::Model &model = equations.model();
  const Index n = model.size();
  const Index size = equations.layout().physical_size();
  mass_ = model.mass();
  const Vector inverse_mass = mass_.cwiseInverse();
  matrix_ = Matrix::Zero(size, size);
  matrix_.block(0, n, n, n).setIdentity();
  matrix_.block(n, 0, n, n) = -(inverse_mass.asDiagonal() * model.stiffness().dense());
  matrix_.block(n, n, n, n) = -(inverse_mass.asDiagonal() * model.damping().dense());
  constant_ = Vector::Zero(size);
  for (const model::Source &source : model.sources()) {
    const auto acceleration = [&](const Vector &load) {
      Vector y = Vector::Zero(size);
      y.segment(n, n) = inverse_mass.cwiseProduct(load);
      return y;
    };
    loads_.push_back({acceleration(source.load), acceleration(source.rate_load),
                      acceleration(source.inertial_load)});
  }
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (!equations.mode(c).holds_gap)
      add_contact(equations, c);
  if (!equations.holding().empty())
    hold(equations);
}

// The forces of equations.holding() as rows, and what they add to the equations.
void LinearSystem::hold(const Equations &equations) {
  const ActiveConstraints &holding = equations.holding();
  const Index n = equations.model().size();
  const auto n_sources = static_cast<Index>(loads_.size());
  const Matrix &w = holding.rows();
  Matrix missing = Matrix::Zero(holding.size(), size() + 3 * n_sources + 1);
  missing.leftCols(size()) = w * matrix_.middleRows(n, n);
  missing.rightCols(1) = w * constant_.segment(n, n);
  for (Index s = 0; s < n_sources; ++s) {
    const Load &load = loads_[static_cast<std::size_t>(s)];
    missing.col(size() + 3 * s) = w * load.value.segment(n, n);
    missing.col(size() + 3 * s + 1) = w * load.rate.segment(n, n);
    missing.col(size() + 3 * s + 2) = w * load.acceleration.segment(n, n);
  }
  for (Index k = 0; k < holding.size(); ++k) {
    const ContactPair &pair = equations.contacts().pairs()[holding.contact(k)];
    missing.row(k).head(n) += holding.by_gap(k) * w.row(k);
    missing.row(k).segment(n, n) += holding.by_gap_rate(k) * w.row(k);
    missing(k, missing.cols() - 1) += holding.by_gap(k) * pair.clearance;
    for (std::size_t s = 0; s < pair.gap.base_coefficients.size(); ++s)
      missing.row(k).segment(size() + 3 * static_cast<Index>(s), 3) +=
          pair.gap.base_coefficients[s] *
          Eigen::RowVector3d(holding.by_gap(k), holding.by_gap_rate(k), 1);
    constraint_forces_.contacts.push_back(holding.contact(k));
  }
  const Matrix forces = -holding.forces(missing);
  constraint_forces_.rows = forces.leftCols(forces.cols() - 1);
  constraint_forces_.constants = forces.rightCols(1);
  const Matrix added = holding.response() * forces;
  matrix_.middleRows(n, n) += added.leftCols(size());
  constant_.segment(n, n) += added.rightCols(1);
  for (Index s = 0; s < n_sources; ++s) {
    Load &load = loads_[static_cast<std::size_t>(s)];
    load.value.segment(n, n) += added.col(size() + 3 * s);
    load.rate.segment(n, n) += added.col(size() + 3 * s + 1);
    load.acceleration.segment(n, n) += added.col(size() + 3 * s + 2);
  }
}

void LinearSystem::add_contact(const Equations &equations, std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  const contact::AffineLaw &law = *affine_law(equations, contact);
  Vector into = Vector::Zero(size());
  into.segment(layout.n, layout.n) =
      equations.model().mass().cwiseInverse().cwiseProduct(pair.gap.row.transpose());
  add_form(equations, contact, law.force, into);
  for (std::size_t i = 0; i < law.internal_rate.size(); ++i)
    add_form(
        equations, contact, law.internal_rate[i],
        Vector::Unit(size(), layout.internal() + pair.internal_offset + static_cast<Index>(i)));
}

// y' += into * form(gap, gap rate, internal states)
void LinearSystem::add_form(const Equations &equations, std::size_t contact,
                            const contact::AffineForm &form, const Vector &into) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const StateLayout &layout = equations.layout();
  matrix_.leftCols(layout.n) += form.gap * into * pair.gap.row;
  matrix_.middleCols(layout.n, layout.n) += form.gap_rate * into * pair.gap.row;
  for (std::size_t i = 0; i < form.internal.size(); ++i)
    matrix_.col(layout.internal() + pair.internal_offset + static_cast<Index>(i)) +=
        form.internal[i] * into;
  constant_ += (form.constant + form.gap * pair.clearance) * into;
  for (std::size_t k = 0; k < pair.gap.base_coefficients.size(); ++k) {
    loads_[k].value += form.gap * pair.gap.base_coefficients[k] * into;
    loads_[k].rate += form.gap_rate * pair.gap.base_coefficients[k] * into;
  }
}

void LinearSystem::differentiate(Matrix &rows) const {
  for (Index j = 1; j < rows.cols(); ++j) {
    auto next = rows.col(j).head(size());
    next.noalias() = matrix_ * rows.col(j - 1).head(size());
    if (j == 1)
      next += constant_;
    for (std::size_t k = 0; k < loads_.size(); ++k) {
      const double *s = &rows(size() + 3 * static_cast<Index>(k), j - 1);
      next += s[0] * loads_[k].value + s[1] * loads_[k].rate + s[2] * loads_[k].acceleration;
    }
  }
}

void LinearSystem::decompose() {
  scale_ = balance(matrix_);
  const Matrix balanced = scale_.cwiseInverse().asDiagonal() * matrix_ * scale_.asDiagonal();
  spectral_radius_ = balanced.norm(); // an upper bound, if nothing better is found
  const Eigen::EigenSolver<Matrix> solver(balanced);
  if (solver.info() != Eigen::Success)
    return;
  eigenvalues_ = solver.eigenvalues();
  spectral_radius_ = eigenvalues_.size() > 0 ? eigenvalues_.cwiseAbs().maxCoeff() : 0;
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  diagonalizable_ = eigenvalues_.size() > 0 && condition(vectors) <= largest_condition &&
                    residual(balanced, eigenvalues_, vectors) <= largest_residual * balanced.norm();
  if (!diagonalizable_)
    return;
  eigenvectors_ = scale_.cast<Complex>().asDiagonal() * vectors;
  left_ = vectors.inverse();
  left_sizes_ = left_.rowwise().norm();
  left_ = left_ * scale_.cwiseInverse().cast<Complex>().asDiagonal();
  basis_.resize(size(), size());
  // EigenSolver puts conjugate eigenvalues side by side, the one with positive imaginary part
  // first.
  for (Index k = 0; k < size(); ++k) {
    const bool is_pair = eigenvalues_[k].imag() != 0;
    modes_.push_back({.eigenvalue = eigenvalues_[k], .column = k, .is_pair = is_pair});
    basis_.col(k) = (is_pair ? 2 : 1) * eigenvectors_.col(k).real();
    if (is_pair) {
      ++k;
      basis_.col(k) = -2 * eigenvectors_.col(k - 1).imag();
    }
  }
  inverse_ = basis_.inverse();
}

bool LinearSystem::response(Complex exponent, const ComplexVector &input,
                            ComplexVector &solution) const {
  ComplexVector amplitude = left_ * input;
  // What is below the rounding of a product with the whole (balanced) row is nothing: a mode at
  // rest whose entry for the loaded coordinate vanishes does not take part.
  const double size_of_input = scale_.cwiseInverse().cwiseProduct(input.cwiseAbs()).norm();
  for (Index k = 0; k < size(); ++k) {
    const Complex distance = exponent - eigenvalues_[k];
    const bool near =
        std::abs(distance) <=
        (exponent == 0.0 ? slow * spectral_radius_ : resonance_distance * std::abs(exponent));
    if (!near)
      amplitude[k] /= distance;
    else if (std::abs(amplitude[k]) > rounding * left_sizes_[k] * size_of_input)
      return false;
    else
      amplitude[k] = 0;
  }
  solution = eigenvectors_ * amplitude;
  return true;
}

} // namespace vibroimpact::motion
