#include "motion/moments/moment_flow.h"

#include "common/decompositions.h"

namespace vibroimpact::motion {

namespace {

// The coordinates of a group with one exponent as a complex number.
Complex amplitude(const PhaseGroup &group, const double *coordinates) {
  const double re = coordinates[group.coordinates[0]];
  return group.kind == BlockKind::pair ? Complex(re, coordinates[group.coordinates[1]]) : re;
}

void set_amplitude(const PhaseGroup &group, Complex value, Vector &coordinates) {
  coordinates[group.coordinates[0]] = value.real();
  if (group.kind == BlockKind::pair)
    coordinates[group.coordinates[1]] = value.imag();
}

Vector part_of(const PhaseGroup &group, const double *coordinates) {
  Vector part(static_cast<Index>(group.coordinates.size()));
  for (std::size_t i = 0; i < group.coordinates.size(); ++i)
    part[static_cast<Index>(i)] = coordinates[group.coordinates[i]];
  return part;
}

void set_part(const PhaseGroup &group, const Vector &part, Vector &coordinates) {
  for (std::size_t i = 0; i < group.coordinates.size(); ++i)
    coordinates[group.coordinates[i]] = part[static_cast<Index>(i)];
}

} // namespace

MomentFlow::MomentFlow(const ExactPhase &phase, const Vector &mass) : phase_(phase) {
  const Index n = mass.size();
  load_ = Matrix::Zero(phase.n_coordinates(), n);
  load_.topRows(phase.n_modes()) =
      phase.modal().inverse().middleCols(n, n) * mass.cwiseInverse().asDiagonal();
}

MomentTable MomentFlow::table(double h, double x) const {
  MomentTable table;
  for (const PhaseGroup &group : phase_.groups())
    if (group.kind == BlockKind::dense) {
      table.dense_turn.push_back(exponential(group.generator * (h * x)));
      table.dense_responses.push_back(legendre_responses(h * group.generator, x));
      for (Matrix &response : table.dense_responses.back())
        response *= h;
    } else {
      table.turn.push_back(std::exp(group.exponent * (h * x)));
      table.responses.push_back(group.is_input() ? LegendreResponses{}
                                                 : legendre_responses(group.exponent * h, x));
      for (Complex &response : table.responses.back())
        response *= h;
    }
  return table;
}

void MomentFlow::move(const MomentTable &table, const Vector &start, const Matrix &loads,
                      Vector &coordinates) const {
  coordinates.resize(start.size());
  std::size_t simple = 0, dense = 0;
  for (const PhaseGroup &group : phase_.groups())
    if (group.kind == BlockKind::dense) {
      Vector sum = table.dense_turn[dense] * part_of(group, start.data());
      for (Index k = 0; k < n_moments; ++k)
        sum += table.dense_responses[dense][static_cast<std::size_t>(k)] *
               part_of(group, loads.col(k).data());
      set_part(group, sum, coordinates);
      ++dense;
    } else {
      Complex sum = table.turn[simple] * amplitude(group, start.data());
      for (Index k = 0; k < n_moments; ++k)
        sum += table.responses[simple][static_cast<std::size_t>(k)] *
               amplitude(group, loads.col(k).data());
      set_amplitude(group, sum, coordinates);
      ++simple;
    }
}

Vector MomentFlow::response(const MomentTable &table, const Vector &load) const {
  Vector result(load.size());
  std::size_t simple = 0, dense = 0;
  for (const PhaseGroup &group : phase_.groups())
    if (group.kind == BlockKind::dense)
      set_part(group, table.dense_responses[dense++].back() * part_of(group, load.data()), result);
    else
      set_amplitude(group, table.responses[simple++].back() * amplitude(group, load.data()),
                    result);
  return result;
}

} // namespace vibroimpact::motion
