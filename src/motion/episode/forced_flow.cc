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

ForcedFlow::ForcedFlow(const std::vector<FlowBlock> &blocks, const Vector &load) : load_(load) {
  for (const FlowBlock &block : blocks) {
    if (rotates(block.generator))
      turning_.push_back({.real = block.places[0],
                          .imaginary = block.places[1],
                          .rate = block.generator(0, 0),
                          .frequency = block.generator(1, 0)});
    else
      blocks_.push_back(block);
    fastest_ = std::max(fastest_, eigenvalues(block.generator).cwiseAbs().maxCoeff());
    const Vector part = entries(load, block.places);
    if (part.isZero(0))
      continue;
    if (rotates(block.generator)) {
      pairs_.real.push_back(block.places[0]);
      pairs_.imaginary.push_back(block.places[1]);
      pairs_.rate.push_back(block.generator(0, 0));
      pairs_.frequency.push_back(block.generator(1, 0));
      pairs_.real_load.push_back(part[0]);
      pairs_.imaginary_load.push_back(part[1]);
    } else {
      others_.push_back(block);
      other_loads_.push_back(part);
    }
  }
  if (fastest_ == 0)
    fastest_ = 1;
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

void ForcedFlow::add(double duration, const double *moments, int terms, double *x) const {
  add_pairs(duration, moments, terms, x);
  add_others(duration, moments, terms, x);
}

// Horner's rule in the exponents, all pairs side by side.
void ForcedFlow::add_pairs(double duration, const double *moments, int terms, double *x) const {
  const std::size_t count = pairs_.size();
  sums_.assign(2 * count, 0);
  double *const real = sums_.data();
  double *const imaginary = real + count;
  const double *const rate = pairs_.rate.data();
  const double *const frequency = pairs_.frequency.data();
  for (int k = terms; k-- > 0;)
    for (std::size_t j = 0; j < count; ++j) {
      const double before = real[j];
      real[j] = moments[k] + duration * (rate[j] * before - frequency[j] * imaginary[j]);
      imaginary[j] = duration * (frequency[j] * before + rate[j] * imaginary[j]);
    }
  for (std::size_t j = 0; j < count; ++j) {
    const double a = pairs_.real_load[j];
    const double b = pairs_.imaginary_load[j];
    x[pairs_.real[j]] += duration * (real[j] * a - imaginary[j] * b);
    x[pairs_.imaginary[j]] += duration * (real[j] * b + imaginary[j] * a);
  }
}

void ForcedFlow::add_others(double duration, const double *moments, int terms, double *x) const {
  for (std::size_t b = 0; b < others_.size(); ++b) {
    Vector sum = Vector::Zero(other_loads_[b].size());
    for (int k = terms; k-- > 0;)
      sum = moments[k] * other_loads_[b] + duration * (others_[b].generator * sum);
    for (std::size_t i = 0; i < others_[b].places.size(); ++i)
      x[others_[b].places[i]] += duration * sum[static_cast<Index>(i)];
  }
}

ForcedOutput::ForcedOutput(const ForcedFlow &flow, Vector row, double constant, int terms)
    : flow_(flow), constant_(constant), last_(std::move(row)), rows_(flow.size(), 0),
      responses_(0) {
  require(terms);
}

void ForcedOutput::require(int terms) {
  const int known = n_terms();
  if (terms <= known)
    return;
  rows_.conservativeResize(Eigen::NoChange, terms);
  responses_.conservativeResize(terms);
  for (int k = known; k < terms; ++k) {
    if (k > 0) {
      last_ = flow_.before(last_) / flow_.fastest();
      factorial_ *= k;
    }
    responses_[k] = last_.dot(flow_.load());
    rows_.col(k) = last_ / factorial_;
  }
}

void ForcedOutput::free_motion(const double *x, int terms, double *coefficients) const {
  VectorView(coefficients, terms).noalias() =
      rows_.leftCols(terms).transpose() * ConstVectorView(x, rows_.rows());
  coefficients[0] += constant_;
}

} // namespace vibroimpact::motion
