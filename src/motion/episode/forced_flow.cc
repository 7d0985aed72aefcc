#include "motion/episode/forced_flow.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

bool rotates(const Matrix &generator) {
  return generator.rows() == 2 && generator(0, 0) == generator(1, 1) &&
         generator(0, 1) == -generator(1, 0) && generator(0, 1) != 0;
}

Vector entries(const Vector &all, const std::vector<int> &places) {
  Vector part(static_cast<Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    part[static_cast<Index>(i)] = all[places[i]];
  return part;
}

} // namespace

ForcedFlow::ForcedFlow(const std::vector<FlowBlock> &blocks, const std::vector<Vector> &loads) {
  for (const Vector &load : loads)
    driven_.push_back({.load = load});
  for (const FlowBlock &block : blocks) {
    if (rotates(block.generator))
      turning_.push_back({.real = block.places[0],
                          .imaginary = block.places[1],
                          .rate = block.generator(0, 0),
                          .frequency = block.generator(1, 0)});
    else
      blocks_.push_back(block);
    fastest_ = std::max(fastest_, eigenvalues(block.generator).cwiseAbs().maxCoeff());
    for (Driven &driven : driven_)
      add_block(block, driven);
  }
  if (fastest_ == 0)
    fastest_ = 1;
}

void ForcedFlow::add_block(const FlowBlock &block, Driven &driven) {
  const Vector part = entries(driven.load, block.places);
  if (part.isZero(0))
    return;
  if (rotates(block.generator)) {
    driven.pairs.real.push_back(block.places[0]);
    driven.pairs.imaginary.push_back(block.places[1]);
    driven.pairs.rate.push_back(block.generator(0, 0));
    driven.pairs.frequency.push_back(block.generator(1, 0));
    driven.pairs.real_load.push_back(part[0]);
    driven.pairs.imaginary_load.push_back(part[1]);
  } else {
    driven.others.push_back(block);
    driven.other_loads.push_back(part);
  }
}

Vector ForcedFlow::before(const Vector &row) const {
  Vector result = Vector::Zero(size());
  for (const Turning &pair : turning_) {
    result[pair.real] = pair.rate * row[pair.real] + pair.frequency * row[pair.imaginary];
    result[pair.imaginary] = pair.rate * row[pair.imaginary] - pair.frequency * row[pair.real];
  }
  for (const FlowBlock &block : blocks_) {
    const Vector part = block.generator.transpose() * entries(row, block.places);
    for (std::size_t i = 0; i < block.places.size(); ++i)
      result[block.places[i]] = part[static_cast<Index>(i)];
  }
  return result;
}

void ForcedFlow::add(double duration, const double *moments, int terms, double *x,
                     int direction) const {
  add_pairs(duration, moments, terms, driven(direction), x);
  add_others(duration, moments, terms, driven(direction), x);
}

// Horner's rule in the exponents, all pairs side by side.
void ForcedFlow::add_pairs(double duration, const double *moments, int terms, const Driven &driven,
                           double *x) const {
  const Pairs &pairs = driven.pairs;
  const std::size_t count = pairs.size();
  sums_.assign(2 * count, 0);
  double *const real = sums_.data();
  double *const imaginary = real + count;
  const double *const rate = pairs.rate.data();
  const double *const frequency = pairs.frequency.data();
  for (int k = terms; k-- > 0;)
    for (std::size_t j = 0; j < count; ++j) {
      const double before = real[j];
      real[j] = moments[k] + duration * (rate[j] * before - frequency[j] * imaginary[j]);
      imaginary[j] = duration * (frequency[j] * before + rate[j] * imaginary[j]);
    }
  for (std::size_t j = 0; j < count; ++j) {
    const double a = pairs.real_load[j];
    const double b = pairs.imaginary_load[j];
    x[pairs.real[j]] += duration * (real[j] * a - imaginary[j] * b);
    x[pairs.imaginary[j]] += duration * (real[j] * b + imaginary[j] * a);
  }
}

void ForcedFlow::add_others(double duration, const double *moments, int terms, const Driven &driven,
                            double *x) {
  for (std::size_t b = 0; b < driven.others.size(); ++b) {
    Vector sum = Vector::Zero(driven.other_loads[b].size());
    for (int k = terms; k-- > 0;)
      sum = moments[k] * driven.other_loads[b] + duration * (driven.others[b].generator * sum);
    for (std::size_t i = 0; i < driven.others[b].places.size(); ++i)
      x[driven.others[b].places[i]] += duration * sum[static_cast<Index>(i)];
  }
}

ForcedOutput::ForcedOutput(const ForcedFlow &flow, Vector row, double constant, int terms)
    : flow_(flow), constant_(constant), last_(std::move(row)), rows_(flow.size(), 0),
      responses_(static_cast<std::size_t>(flow.n_loads())) {
  require(terms);
}

void ForcedOutput::require(int terms) {
  const int known = n_terms();
  if (terms <= known)
    return;
  rows_.conservativeResize(Eigen::NoChange, terms);
  for (Vector &responses : responses_)
    responses.conservativeResize(terms);
  for (int k = known; k < terms; ++k) {
    if (k > 0) {
      last_ = flow_.before(last_) / flow_.fastest();
      factorial_ *= k;
    }
    for (int l = 0; l < flow_.n_loads(); ++l)
      responses_[static_cast<std::size_t>(l)][k] = last_.dot(flow_.load(l));
    rows_.col(k) = last_ / factorial_;
  }
}

void ForcedOutput::free_motion(const double *x, int terms, double *coefficients) const {
  VectorView(coefficients, terms).noalias() =
      rows_.leftCols(terms).transpose() * ConstVectorView(x, rows_.rows());
  coefficients[0] += constant_;
}

} // namespace vibroimpact::motion
