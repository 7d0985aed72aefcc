// What the exponential of a matrix does to a few vectors, without the exponential itself.
//
//   y(h) = exp(M h) y(0),   y_k(h) = sum over m of z_m,   z_0 = y(0),   z_(m+1) = (h / (m + 1)) M
//   z_m
//
// in parts so short that |M| h <= 3, where forty terms leave 3^40 / 40! < 1e-28 (Al-Mohy and Higham
// 2011). No eigenvectors are needed, so that resonance, free bodies and critical damping are like
// any other case.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::motion {

/// exp(matrix h) columns. `radius`: a bound of the eigenvalues [1/s], which says how many parts
/// there are.
Matrix exponential_action(const Matrix &matrix, double radius, double h, const Matrix &columns);

/// The derivative of exp(matrix h) z by a few keys: column k belongs to the derivative changes[k]
/// of the matrix and to the derivative in column k of `start` of z.
Matrix exponential_tangent(const Matrix &matrix, const std::vector<Matrix> &changes, double radius,
                           double h, const Vector &z, const Matrix &start);

} // namespace vibroimpact::motion
