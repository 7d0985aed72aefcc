#include "motion/variation/contact_map.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// Sum of c_k s^k and sum of k c_k s^(k-1).
struct Polynomial {
  double value = 0, slope = 0;
};
Polynomial evaluate(const Vector &coefficients, double s) {
  Polynomial sum;
  for (Index k = coefficients.size(); k-- > 0;) {
    sum.slope = sum.value + s * sum.slope;
    sum.value = coefficients[k] + s * sum.value;
  }
  return sum;
}

} // namespace

ContactMap::ContactMap(const ContactEpisode &solved, const ForcedOutput &penetration,
                       const double *x0)
    : solved_(solved), penetration_(penetration), n_(solved.nodes()) {
  const double theta = penetration.flow().fastest() * solved.duration();
  positions_.resize(n_ + 1);
  for (Index i = 0; i < n_; ++i)
    positions_[i] = theta * static_cast<double>(solved.tools().family.nodes()[i]);
  positions_[n_] = theta;
  powers_.resize(solved.terms());
  for (Index k = 0; k < powers_.size(); ++k)
    powers_[k] = penetration.responses()[k] * std::pow(theta, k);
  coefficients_.setZero(solved.terms() + 1);
  penetration.free_motion(x0, std::min(solved.terms() + 1, penetration.n_terms()),
                          coefficients_.data());
  coefficients_[0] = 0;
  factorise();
}

// Rows: nodes, then the end; columns: forces in units of m v / T, then ln T. Slopes of the law are
// those at the nodes, which are inside the contact.
void ContactMap::factorise() {
  const ForceOperators &operators = solved_.tools().at_nodes;
  const ConstVectorView forces(solved_.forces(), n_);
  const double duration = solved_.duration();
  const double fastest = penetration_.flow().fastest();
  const double unit = solved_.mass() * solved_.approach_speed() / duration;
  const EndCondition &end = solved_.end();
  Matrix by_force = Matrix::Zero(n_ + 1, n_), rate_by_force = by_force;
  Vector by_length(n_ + 1), rate_by_length(n_ + 1);
  Vector slopes = coefficients_;
  for (Index k = 0; k < slopes.size(); ++k)
    slopes[k] *= static_cast<double>(k);
  for (Index i = 0; i <= n_; ++i) {
    by_length[i] = evaluate(slopes, positions_[i]).value;
    rate_by_length[i] = fastest * (evaluate(slopes, positions_[i]).slope -
                                   evaluate(coefficients_, positions_[i]).slope);
  }
  for (Index k = 1; k < powers_.size(); ++k) {
    const auto order = static_cast<double>(k);
    const Matrix moved = duration * powers_[k] * operators.term(static_cast<int>(k));
    const Matrix hastened = powers_[k] * operators.term(static_cast<int>(k) - 1);
    by_force += moved;
    rate_by_force += hastened;
    by_length += (order + 1) * (moved * forces);
    rate_by_length += order * (hastened * forces);
  }
  const ConstVectorView stiffness(solved_.law().by_place[0][0].data(), n_);
  const ConstVectorView damping(solved_.law().by_rate[0][0].data(), n_);
  Matrix matrix = Matrix::Identity(n_ + 1, n_ + 1);
  matrix.topLeftCorner(n_, n_) -= stiffness.asDiagonal() * by_force.topRows(n_);
  matrix.topLeftCorner(n_, n_) -= damping.asDiagonal() * rate_by_force.topRows(n_);
  matrix.topRightCorner(n_, 1) = -(stiffness.cwiseProduct(by_length.head(n_)) +
                                   damping.cwiseProduct(rate_by_length.head(n_))) /
                                 unit;
  const double scale = end_scale();
  matrix.bottomLeftCorner(1, n_) =
      unit / scale * (end.by_penetration * by_force.row(n_) + end.by_rate * rate_by_force.row(n_));
  matrix(n_, n_) = (end.by_penetration * by_length[n_] + end.by_rate * rate_by_length[n_]) / scale;
  newton_.compute(matrix);
}

// Of the form that is zero at the end.
double ContactMap::end_scale() const {
  return solved_.approach_speed() * (solved_.duration() * std::abs(solved_.end().by_penetration) +
                                     std::abs(solved_.end().by_rate));
}

ContactMap::Shift ContactMap::shift(const Matrix &columns) const {
  const double duration = solved_.duration();
  const double fastest = penetration_.flow().fastest();
  const double unit = solved_.mass() * solved_.approach_speed() / duration;
  const EndCondition &end = solved_.end();
  const Index terms = powers_.size();
  Matrix coefficients = penetration_.rows().leftCols(terms).transpose() * columns;
  const RowVector late = -coefficients.row(0) / (fastest * coefficients_[1]);
  for (Index k = 0; k < terms; ++k)
    coefficients.row(k) += static_cast<double>(k + 1) * fastest * coefficients_[k + 1] * late;
  Matrix right(n_ + 1, columns.cols());
  for (Index c = 0; c < columns.cols(); ++c)
    for (Index i = 0; i <= n_; ++i) {
      const Polynomial free = evaluate(coefficients.col(c), positions_[i]);
      const auto at = static_cast<std::size_t>(i);
      right(i, c) = i < n_
                        ? (solved_.law().by_place[0][0][at] * free.value +
                           solved_.law().by_rate[0][0][at] * fastest * free.slope) /
                              unit
                        : -(end.by_penetration * free.value + end.by_rate * fastest * free.slope) /
                              end_scale();
    }
  const Matrix solution = newton_.solve(right);
  return {.forces = unit * solution.topRows(n_),
          .length = solution.row(n_),
          .instant = late / duration};
}

// f acts on u' by row S b = g_1 max|exponent|, and F_u' begins and ends like the force.
double ContactMap::divergence() const {
  const ConstVectorView damping(solved_.law().by_rate[0][0].data(), n_);
  return powers_[1] * solved_.tools().at_nodes.term(0).row(n_).dot(damping);
}

Matrix ContactMap::forced(const Matrix &columns) const {
  const Shift moved = shift(columns);
  const ForceOperators &operators = solved_.tools().at_nodes;
  const ConstVectorView forces(solved_.forces(), n_);
  const Index terms = powers_.size();
  Matrix moments(terms, columns.cols());
  double before = 0;
  for (Index k = 0; k < terms; ++k) {
    const RowVector to_end = operators.term(static_cast<int>(k)).row(n_);
    const double present = to_end.dot(forces);
    moments.row(k) = to_end * moved.forces +
                     (static_cast<double>(k + 1) * present - before) * moved.length -
                     before * moved.instant;
    before = present;
  }
  Matrix result = Matrix::Zero(columns.rows(), columns.cols());
  for (Index c = 0; c < columns.cols(); ++c)
    penetration_.flow().add(solved_.duration(), moments.col(c).data(), static_cast<int>(terms),
                            result.col(c).data());
  return result;
}

} // namespace vibroimpact::motion
