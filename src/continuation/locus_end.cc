#include "continuation/locus_end.h"

namespace vibroimpact::continuation {

namespace {

class EndSystem {
public:
  EndSystem(const ScaledProblem &problem, LocusKind kind, const LocusNode &last, const Graze &graze)
      : problem_{problem}, chart_{last.chart}, graze_{graze}, multiplier_{kind == LocusKind::fold
                                                                              ? 1.0
                                                                              : -1.0} {
    const LinearisedExtension start = problem.extend(last.u, chart_, graze_);
    open_ = start.value > 0;
    borders_ = Borders::of(shifted(start));
  }

  SquareSystem operator()(const Vector &u) {
    const Index n = problem_.states();
    extension = problem_.extend(u, chart_, graze_);
    SquareSystem at{Vector(n + 2), Matrix(n + 2, n + 2)};
    at.residual << extension.smooth.residual, extension.value, singularity(extension);
    at.slope << extension.smooth.slope, extension.gradient, singularity_slope(u);
    return at;
  }

  LinearisedExtension extension;

private:
  Matrix shifted(const LinearisedExtension &at) const {
    const Index n = problem_.states();
    Matrix matrix = at.smooth.slope.leftCols(n) + (1 - multiplier_) * Matrix::Identity(n, n);
    if (open_ || at.touch == Touch::smooth)
      return matrix;
    if (at.touch == Touch::square_root || at.jump.size() == 0)
      throw NumericalError("derivatives have no limit beyond this grazing motion");
    return matrix + at.jump * at.gradient.head(n);
  }

  double singularity(const LinearisedExtension &at) const { return borders_.solve(shifted(at)).g; }

  // By differences in every direction: the jump has no symmetric derivatives. It is needed once.
  RowVector singularity_slope(const Vector &u) const {
    constexpr double h = 1e-6;
    RowVector slope(u.size());
    for (Index i = 0; i < u.size(); ++i) {
      const Vector step = h * Vector::Unit(u.size(), i);
      slope(i) = (singularity(problem_.extend(u + step, chart_, graze_)) -
                  singularity(problem_.extend(u - step, chart_, graze_))) /
                 (2 * h);
    }
    return slope;
  }

  const ScaledProblem &problem_;
  double chart_;
  Graze graze_;
  double multiplier_;
  bool open_ = true;
  Borders borders_;
};

} // namespace

std::optional<GrazeEnd> end_at_graze(const ScaledProblem &problem, LocusKind kind,
                                     const LocusNode &last, const Settings &settings) {
  if (kind != LocusKind::fold && kind != LocusKind::flip)
    return std::nullopt;
  std::optional<GrazeEnd> nearest;
  double least = 10 * settings.graze_step; // ends further away are not those of this curve
  for (const Graze &graze : problem.problem().grazes_near(problem.point(last.u, last.chart))) {
    try {
      EndSystem system(problem, kind, last, graze);
      const Vector u =
          newton([&](const Vector &at) { return system(at); }, last.u, least, settings).u;
      const double distance = (u - last.u).norm();
      if (distance < least) {
        least = distance;
        nearest = GrazeEnd{u, system.extension.smooth, graze};
      }
    } catch (const NumericalError &) {
    }
  }
  return nearest;
}

} // namespace vibroimpact::continuation
