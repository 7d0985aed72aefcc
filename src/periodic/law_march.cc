#include "periodic/law_march.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "continuation/harmonic_series.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using contact::AffineForm;
using contact::LawResponse;
using contact::LocalState;

namespace {

LocalState local_state(double gap, double rate, const Vector &internal) {
  return {.gap = gap,
          .gap_rate = rate,
          .internal = {internal.data(), static_cast<std::size_t>(internal.size())}};
}

RowVector row_of(const std::vector<double> &values) {
  return Eigen::Map<const RowVector>(values.data(), static_cast<Index>(values.size()));
}

RowVector internal_row(const AffineForm &form, Index internals) {
  return form.internal.empty() ? RowVector::Zero(internals) : row_of(form.internal);
}

Vector column(const std::vector<double> &values) { return row_of(values).transpose(); }

Matrix square(const std::vector<double> &row_major, Index n) {
  return Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(row_major.data(), n, n);
}

} // namespace

bool LawState::repeats(const LawState &before) const {
  constexpr double rounding = 1e-12;
  if (mode != before.mode)
    return false;
  return internal.size() == 0 || (internal - before.internal).cwiseAbs().maxCoeff() <=
                                     rounding * internal.cwiseAbs().maxCoeff();
}

double LawPart::place(Index k) const {
  if (k == 0)
    return begin;
  return k > HarmonicGrid::nodes ? begin + length : begin + length * HarmonicGrid::places()(k - 1);
}

/// Gap, its rate, their derivatives by the phase and by the coefficients.
struct LawMarch::Local {
  double gap = 0, rate = 0, rate_by_phase = 0;
  RowVector gap_slope, rate_slope;
};

/// Of the collocation method over a part.
struct LawMarch::Stages {
  Matrix internal;              ///< at the nodes
  std::vector<LawResponse> law; ///< there
  LuFactors<Matrix> step;       ///< of Newton's method
  Vector end;
};

LawMarch::LawMarch(const contact::ContactLaw &law, const RowVector &gap, double frequency,
                   const HarmonicGrid &grid)
    : law_{law}, grid_{grid}, gap_{gap}, frequency_{frequency}, internals_{law.n_internal()} {
  const Matrix rate = continuation::harmonic_rate(grid.harmonics());
  rate_ = frequency * gap * rate;
  acceleration_ = rate_ * rate;
}

LawMarch::Local LawMarch::local(double phase) const {
  const Vector basis = continuation::harmonic_basis(phase, grid_.harmonics());
  return {.gap = gap_.dot(basis),
          .rate = rate_.dot(basis),
          .rate_by_phase = acceleration_.dot(basis),
          .gap_slope = basis.transpose(),
          .rate_slope = frequency_ * HarmonicGrid::rate_of(basis).transpose()};
}

LawState LawMarch::start() const {
  const Local here = local(0);
  LawState state{.mode = 0,
                 .internal = column(law_.initial_internal()),
                 .by_gap = Matrix::Zero(internals_, grid_.coefficients())};
  const LocalState at = local_state(here.gap, here.rate, state.internal);
  state.mode = internals_ == 0 ? settle(law_, at).mode : law_.initial_mode(at);
  return state;
}

const std::vector<contact::Guard> &LawMarch::guards(const LawState &state) const {
  return law_.modes()[static_cast<std::size_t>(state.mode)].guards;
}

LawPart LawMarch::part(Index interval, const LawState &state) const {
  return make_part(grid_.begin(interval), grid_.begin(interval + 1), grid_.basis(interval),
                   grid_.basis_at(interval), grid_.basis_at(interval + 1), state);
}

LawPart LawMarch::part(double begin, double end, const LawState &state) const {
  return make_part(begin, end, grid_.basis(begin, end),
                   continuation::harmonic_basis(begin, grid_.harmonics()),
                   continuation::harmonic_basis(end, grid_.harmonics()), state);
}

LawPart LawMarch::make_part(double begin, double end, Matrix basis, const Vector &first,
                            const Vector &last, const LawState &state) const {
  LawPart part;
  part.begin = begin;
  part.length = end - begin;
  part.basis = std::move(basis);
  part.gap.resize(HarmonicGrid::nodes + 2);
  part.gap << gap_.dot(first), gap_ * part.basis, gap_.dot(last);
  part.gap_rate.resize(HarmonicGrid::nodes + 2);
  part.gap_rate << rate_.dot(first), rate_ * part.basis, rate_.dot(last);
  part.internal.resize(internals_, HarmonicGrid::nodes);
  part.end = state;
  part.acts = !inactive(state);
  if (part.acts)
    act(part, state);
  return part;
}

bool LawMarch::inactive(const LawState &state) const {
  const auto &affine = law_.modes()[static_cast<std::size_t>(state.mode)].affine;
  return internals_ == 0 && affine && affine->force.constant == 0 && affine->force.gap == 0 &&
         affine->force.gap_rate == 0;
}

void LawMarch::act(LawPart &part, const LawState &state) const {
  constexpr Index nodes = HarmonicGrid::nodes;
  const Matrix rate_slope = frequency_ * HarmonicGrid::rate_of(part.basis);
  const Stages stages =
      this->stages(state, part.gap.segment(1, nodes), part.gap_rate.segment(1, nodes), part.length);
  const std::vector<Matrix> slopes = carry_slopes(stages, part, rate_slope, state);
  part.internal = stages.internal;
  refuse_objections(part, state);
  part.end.internal = stages.end;
  part.force.resize(nodes);
  part.force_slope.resize(grid_.coefficients(), nodes);
  for (Index k = 0; k < nodes; ++k) {
    const LawResponse &at = stages.law[static_cast<std::size_t>(k)];
    part.force(k) = at.force;
    part.force_slope.col(k) =
        at.force_by_gap * part.basis.col(k) + at.force_by_gap_rate * rate_slope.col(k);
    if (internals_ > 0)
      part.force_slope.col(k) +=
          slopes[static_cast<std::size_t>(k)].transpose() * column(at.force_by_internal);
  }
}

void LawMarch::refuse_objections(const LawPart &part, const LawState &state) const {
  if (law_.modes()[static_cast<std::size_t>(state.mode)].affine)
    return;
  for (Index k = 0; k < HarmonicGrid::nodes; ++k) {
    const Vector internal = part.internal.col(k);
    const std::string objection =
        law_.objection(state.mode, local_state(part.gap(k + 1), part.gap_rate(k + 1), internal));
    if (!objection.empty())
      throw NumericalError("the force of a contact " + objection);
  }
}

// Z_i = z_0 + h sum_j A_ij r(g_j, g'_j, Z_j), by Newton's method: one step where r is affine.
LawMarch::Stages LawMarch::stages(const LawState &state, const RowVector &gap,
                                  const RowVector &rate, double length) const {
  constexpr Index nodes = HarmonicGrid::nodes;
  constexpr int most_iterations = 20;
  constexpr double rounding = 1e-14;
  Stages stages{.internal = state.internal.replicate(1, nodes),
                .law = std::vector<LawResponse>(nodes),
                .step = {},
                .end = state.internal};
  const double h = length / frequency_;
  const Matrix &a = HarmonicGrid::collocation();
  for (int iteration = 0;; ++iteration) {
    Matrix rates(internals_, nodes);
    Matrix slope = Matrix::Identity(internals_ * nodes, internals_ * nodes);
    for (Index j = 0; j < nodes; ++j) {
      LawResponse &at = stages.law[static_cast<std::size_t>(j)];
      const Vector internal = stages.internal.col(j);
      law_.evaluate(state.mode, local_state(gap(j), rate(j), internal), at);
      if (internals_ == 0)
        continue;
      rates.col(j) = column(at.internal_rate);
      const Matrix by_internal = square(at.internal_rate_by_internal, internals_);
      for (Index i = 0; i < nodes; ++i)
        slope.block(i * internals_, j * internals_, internals_, internals_) -=
            h * a(i, j) * by_internal;
    }
    if (internals_ == 0)
      return stages;
    const Matrix residual =
        (stages.internal - h * rates * a.transpose()).colwise() - state.internal;
    stages.step.compute(slope);
    stages.end = state.internal + h * rates * HarmonicGrid::weights();
    const double size = stages.internal.cwiseAbs().maxCoeff();
    if (residual.cwiseAbs().maxCoeff() <= rounding * size)
      return stages;
    if (iteration == most_iterations)
      throw NumericalError("the internal states of a contact are not found");
    stages.internal -= stages.step.solve(Vector(residual.reshaped())).reshaped(internals_, nodes);
  }
}

// The same equation differentiated by the coefficients of the gap; sets those of the end.
std::vector<Matrix> LawMarch::carry_slopes(const Stages &stages, LawPart &part,
                                           const Matrix &rate_slope, const LawState &state) const {
  constexpr Index nodes = HarmonicGrid::nodes;
  if (internals_ == 0)
    return {};
  const double h = part.length / frequency_;
  std::vector<Matrix> direct;
  for (Index j = 0; j < nodes; ++j) {
    const LawResponse &at = stages.law[static_cast<std::size_t>(j)];
    direct.emplace_back(column(at.internal_rate_by_gap) * part.basis.col(j).transpose() +
                        column(at.internal_rate_by_gap_rate) * rate_slope.col(j).transpose());
  }
  Matrix right = state.by_gap.replicate(nodes, 1);
  for (Index i = 0; i < nodes; ++i)
    for (Index j = 0; j < nodes; ++j)
      right.middleRows(i * internals_, internals_) +=
          h * HarmonicGrid::collocation()(i, j) * direct[static_cast<std::size_t>(j)];
  const Matrix all = stages.step.solve(right);
  std::vector<Matrix> slopes;
  for (Index j = 0; j < nodes; ++j) {
    const auto place = static_cast<std::size_t>(j);
    slopes.emplace_back(all.middleRows(j * internals_, internals_));
    part.end.by_gap +=
        h * HarmonicGrid::weights()(j) *
        (square(stages.law[place].internal_rate_by_internal, internals_) * slopes[place] +
         direct[place]);
  }
  return slopes;
}

Vector LawMarch::guard_values(const LawPart &part, const LawState &state,
                              const contact::Guard &guard) const {
  constexpr Index nodes = HarmonicGrid::nodes;
  Vector values(nodes + 2);
  for (Index k = 0; k < nodes + 2; ++k) {
    Vector internal = part.end.internal;
    if (k <= nodes)
      internal = k == 0 ? state.internal : Vector(part.internal.col(k - 1));
    values(k) = guard.indicator(local_state(part.gap(k), part.gap_rate(k), internal));
  }
  return values;
}

double LawMarch::guard_value(const LawState &state, double begin, double phase,
                             const contact::Guard &guard) const {
  const Local here = local(phase);
  Vector internal = state.internal;
  if (internals_ > 0 && phase > begin) {
    const Matrix basis = grid_.basis(begin, phase);
    internal = stages(state, gap_ * basis, rate_ * basis, phase - begin).end;
  }
  return guard.indicator(local_state(here.gap, here.rate, internal));
}

// At a fixed phase behind the change the state differs by what it differs at the change itself,
// less what it moves in the time by which that comes later.
LawPassage LawMarch::pass(const LawState &state, double phase, const contact::Guard &guard) const {
  const Local here = local(phase);
  const LocalState before = local_state(here.gap, here.rate, state.internal);
  LawResponse law;
  law_.evaluate(state.mode, before, law);
  LawPassage passage{
      .force_before = law.force, .force_after = 0, .phase_slope = {}, .after = state};
  const Vector rate_before = column(law.internal_rate) / frequency_;
  const auto slope = [&](const AffineForm &form) {
    return RowVector(form.gap * here.gap_slope + form.gap_rate * here.rate_slope +
                     internal_row(form, internals_) * state.by_gap);
  };
  const auto by_phase = [&](const AffineForm &form) {
    const double own = internals_ > 0 ? internal_row(form, internals_).dot(rate_before) : 0;
    return form.gap * here.rate / frequency_ + form.gap_rate * here.rate_by_phase + own;
  };
  const double fall = by_phase(guard.indicator);
  passage.phase_slope = RowVector::Zero(grid_.coefficients());
  if (fall < 0)
    passage.phase_slope = slope(guard.indicator) / -fall;
  passage.after.mode = guard.target;
  Vector moving = rate_before; // derivative of the new states along the way
  for (std::size_t i = 0; i < guard.reset.size(); ++i) {
    const auto place = static_cast<Index>(i);
    passage.after.internal(place) = guard.reset[i](before);
    passage.after.by_gap.row(place) = slope(guard.reset[i]);
    moving(place) = by_phase(guard.reset[i]);
  }
  law_.evaluate(guard.target, local_state(here.gap, here.rate, passage.after.internal), law);
  passage.force_after = law.force;
  if (internals_ > 0)
    passage.after.by_gap += (moving - column(law.internal_rate) / frequency_) * passage.phase_slope;
  return passage;
}

} // namespace vibroimpact::periodic
