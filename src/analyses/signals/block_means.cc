#include "analyses/signals/block_means.h"

#include "common/scalar.h"

#include <utility>

namespace vibroimpact::analyses {

void BlockMeans::begin(double time, Vector totals) {
  times_ = {time};
  totals_ = {std::move(totals)};
}

void BlockMeans::end_block(double time, Vector totals) {
  times_.push_back(time);
  totals_.push_back(std::move(totals));
}

Vector BlockMeans::standard_errors() const {
  const std::size_t blocks = times_.size() - 1;
  if (blocks < 2)
    return Vector::Constant(totals_.front().size(), nan);
  const double duration = times_.back() - times_.front();
  const Vector mean = (totals_.back() - totals_.front()) / duration;
  Vector squares = Vector::Zero(mean.size());
  for (std::size_t b = 0; b < blocks; ++b) {
    const Vector change = totals_[b + 1] - totals_[b];
    squares += ((change - (times_[b + 1] - times_[b]) * mean) / duration).cwiseAbs2();
  }
  const auto count = static_cast<double>(blocks);
  return (count / (count - 1) * squares).cwiseSqrt();
}

} // namespace vibroimpact::analyses
