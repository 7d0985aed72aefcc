// The branch on the contact side of a graze, by the depth of the touch.
//
// Let g be the least value of the guard, and y = sqrt(-g). Behind the graze F = F_ext + h(u, y)
// with a smooth h that begins with y at square roots, with y^2 at corners and with y^3 where the
// force is continuous. At a fixed depth the system
//
//     F(u) = 0,   g(u) = -y^2
//
// is regular down to y = 0 wherever that of the graze itself is, and u(y) is smooth: derivatives of
// F that jump or are unbounded are multiples of g_u, which the last row eliminates. It does not
// matter whether the branch turns at the graze. At a rigid contact y is proportional to the impact
// speed (Nordmark 1991).
#pragma once

#include "continuation/newton.h"
#include "continuation/node.h"

namespace vibroimpact::continuation {

struct LocatedGraze {
  Graze graze;
  Vector u;
  double chart = 0;
  LinearisedExtension at;
};

/// -g in scaled unknowns: over the length of its gradient at the graze; < 0 on the open side.
double depth_at(const ScaledProblem &problem, const LocatedGraze &graze, const Vector &u);

/// Where a branch goes on the contact side.
enum class Depth { grows, falls };

class ContactSide {
public:
  /// Keeps references.
  ContactSide(const ScaledProblem &problem, const LocatedGraze &graze, const Settings &settings);

  const LocatedGraze &graze() const { return graze_; }
  /// The solution of depth y^2 nearest to the guess. NumericalError where there is none, or where
  /// Newton's method needs a correction longer than `largest`.
  Node at(double y, const Vector &guess, double largest, Depth depth) const;

private:
  struct OnSurface {
    Vector u;
    RowVector gradient; ///< of g, by u
  };
  OnSurface at_depth(double depth, Vector u) const;

  const ScaledProblem &problem_;
  const LocatedGraze &graze_;
  const Settings &settings_;
  double steepness_; ///< length of the gradient at the graze
  Vector normal_;    ///< the gradient, of length 1
  Matrix across_;    ///< directions orthogonal to it, (n + 1) x n
};

/// The branch between a graze and a node in contact.
class ContactPath {
public:
  /// `far`: a node of the depth y^2. `to_graze`: derivatives have a limit there, so that the path
  /// begins at the graze, otherwise close to it. NumericalError where no other nodes are found.
  ContactPath(ContactSide side, const Node &far, double y, Depth depth, bool to_graze);

  Depth depth() const { return depth_; }
  /// The node whose root y of the depth is this share of that of the far node.
  Node at(double share) const;
  /// Share of the node nearest to the graze, where tests have the signs of the limit.
  double first_share() const { return first_; }

private:
  ContactSide side_;
  Depth depth_;
  double first_ = 0;
  double y_; ///< of the far node
  /// u_graze + slope y + curve y^2 meets the branch at the far node and near it.
  Vector slope_, curve_;
  double largest_; ///< correction of Newton's method
};

} // namespace vibroimpact::continuation
