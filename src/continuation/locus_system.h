// A curve of special points in two keys as one that is followed.
#pragma once

#include "continuation/curve_system.h"
#include "continuation/locus_equation.h"
#include "continuation/newton.h"
#include "continuation/piece.h"

namespace vibroimpact::continuation {

struct LocusNode {
  Vector u{};
  double chart = 0;
  Vector tangent{}; ///< of length 1
  Augmented at{};
  int iterations = 0;
  double arclength = 0;
};

class LocusSystem {
public:
  using Curve = Locus;
  using Node = LocusNode;

  LocusSystem(Problem &problem, const LocusStart &start, const Settings &settings);

  const ScaledProblem &problem() const { return problem_; }
  LocusPoint curve_point(const LocusNode &node) const;
  /// A locus that leaves its range between two points ends there.
  static constexpr bool ends_at_predicted_bounds = true;
  static End end_at(const Bound & /*bound*/) { return End::bounds; }

  LocusNode first() const;
  LocusNode correct(const LocusNode &from, const Vector &guess, const Vector &normal,
                    double largest) const;
  LocusNode in_chart(const LocusNode &node, double chart) const;
  double best_chart(const LocusNode &node) const;
  std::vector<SpecialLocusPoint> special_points(const LocusNode &from, LocusNode &next,
                                                bool closes) const;
  /// Grazes end a locus.
  static std::optional<Behind<LocusNode, SpecialLocusPoint>> behind_graze(const LocusNode &) {
    return std::nullopt;
  }
  static std::optional<Ending<Locus>> end_before(const LocusNode &,
                                                 const std::vector<SpecialLocusPoint> &) {
    return std::nullopt;
  }
  Ending<Locus> end_at_steps(const LocusNode &last, const std::string &why) const;

  Vector predicted(const LocusNode &from, double step) const;
  static double step_factor(const LocusNode & /*from*/, const LocusNode &next) {
    return next.iterations <= 3 ? 1.5 : 1;
  }
  static double least_margin(const LocusNode & /*from*/, const LocusNode & /*next*/) { return 0; }
  /// Also at bounds the tangent turns by the largest angle at most.
  void check(const LocusNode &from, const LocusNode &next) const;
  void accept(const LocusNode &from, const LocusNode &next);
  void take_chart(const LocusNode &moved);

private:
  LocusNode solve(const LocusEquation &equation, const LocusNode &from, const Vector &guess,
                  const Vector &normal, double largest, Until until) const;
  void hold_at_bounds(LocusNode &node) const;
  LocusNode cusp_between(const LocusNode &from, const LocusNode &next) const;

  ScaledProblem problem_;
  LocusStart start_;
  Settings settings_;
  std::unique_ptr<LocusEquation> equation_; ///< with the borders of the last node
  std::optional<Hermite> path_;             ///< to it from the node before, in the same chart
};

} // namespace vibroimpact::continuation
